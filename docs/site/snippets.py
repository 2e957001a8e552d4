# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Sphinx extension: the search shows snippets of a site that is opened from disk, too.

The script of the search fetches each page that it found, which browsers refuse for files. The text of all pages is
therefore in a script of its own, which the page of the search loads and which answers in the place of the pages.
"""
import html
import json
import pathlib

from docutils import nodes

LONGEST = 100_000  # characters of a page; snippets of what follows show its beginning instead
SCRIPT = "snippets.js"
ANSWER = """// The text of the pages, for the snippets of the search.
const PAGE_TEXTS = %s;
const fetchFile = window.fetch;
window.fetch = (address, ...more) => {
  const text = PAGE_TEXTS[String(address).replace(/^\\.\\//, "")];
  return text === undefined ? fetchFile(address, ...more) : Promise.resolve(new Response(`<div role="main">${text}</div>`));
};
"""


def page_text(doctree: nodes.document) -> str:
    for raw in list(doctree.findall(nodes.raw)):
        raw.parent.remove(raw)
    return html.escape(" ".join(doctree.astext().split())[:LONGEST], quote=False)


def write(app, failed) -> None:
    if failed or app.builder.format != "html":
        return
    texts = {app.builder.get_target_uri(name): page_text(app.env.get_doctree(name)) for name in sorted(app.env.found_docs)}
    (pathlib.Path(app.outdir) / "_static" / SCRIPT).write_text(ANSWER % json.dumps(texts, ensure_ascii=False))


def load(app, page, template, context, doctree) -> None:
    if page == "search":
        app.add_js_file(SCRIPT)


def setup(app) -> dict:
    app.connect("build-finished", write)
    app.connect("html-page-context", load)
    return {"parallel_read_safe": True, "parallel_write_safe": True, "version": "1"}
