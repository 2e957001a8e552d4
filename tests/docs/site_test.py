# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The site builds without warnings, the cells of notebooks work, every link in it leads somewhere, its equations can be
set, its search finds what users look for, and it needs no other server. Opened from disk its search shows snippets, and its
tables can be read on a narrow screen.

    site_test.py PROGRAM FOLDER [PACKAGE]

Builds into FOLDER with tools/build_docs. PACKAGE: folder of the built Python package. Exit code 77:
Sphinx or another package is not installed.
"""
import json
import pathlib
import re
import subprocess
import sys
import time

import browse
import typeset

HOME = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(HOME / "docs" / "site"))
import notebooks  # noqa: E402
import search_words  # noqa: E402

SKIPPED = 77
OUTPUT = re.compile(r'<div class="output"><(\w+)')


def check_pages(site: pathlib.Path) -> list[str]:
    faults = []
    first = (site / "index.html").read_text()
    for door in ("install.html", "tutorial/index.html", "cases.html"):
        if f'href="{door}"' not in first:
            faults.append(f"the first page has no link to {door}")
    if '<div id="page"></div>' not in first:
        faults.append("the first page has no place for the page for browsers (tools/make_site)")
    for page in site.rglob("*.html"):
        text = page.read_text()
        if "math notranslate" in text and not re.search(r'src="[./]*_static/mathjax/MathJax\.js', text):
            faults.append(f"{page.relative_to(site)} has equations without the local MathJax")
    for entry in sorted((HOME / "catalogue").glob("*/*.toml")):
        page = site / "catalogue" / f"{entry.parent.name}.html"
        if f">{entry.stem}<" not in page.read_text():
            faults.append(f"{page.relative_to(site)} does not show {entry.stem}")
    if not (site / "searchindex.js").exists():
        faults.append("there is no index for the search")
    return faults


def check_notebooks(site: pathlib.Path) -> list[str]:
    """Each notebook was executed: what its cells print or return is in its page, and at least one picture."""
    faults = []
    for notebook in sorted((HOME / "examples/python").glob("*.ipynb")):
        shown = OUTPUT.findall((site / "examples/python" / f"{notebook.stem}.html").read_text())
        if len(shown) < 2 or "img" not in shown:
            faults.append(f"the page of {notebook.name} shows {len(shown)} outputs, pictures among them: {shown.count('img')}")
    return faults


def check_search(site: pathlib.Path) -> list[str]:
    """Searches by words of users find their page, as searchtools.js looks them up."""
    import snowballstemmer  # of Sphinx

    text, stem = (site / "searchindex.js").read_text(), snowballstemmer.stemmer("english").stemWord
    index = json.loads(text[text.index("(") + 1:text.rindex(")")])

    def pages(word: str) -> set[str]:
        found = set()
        for table in (index["terms"], index["titleterms"]):
            hits = table.get(stem(word.lower()), [])
            found.update([hits] if isinstance(hits, int) else hits)
        return {index["docnames"][hit] for hit in found}

    return [f"a search for '{words}' does not find {page}" for words, page in search_words.SEARCHES.items()
            if page not in set.intersection(*map(pages, words.split()))]


def main() -> int:
    program, folder, *package = sys.argv[1:]
    site, begin = pathlib.Path(folder) / "site", time.monotonic()
    command = [sys.executable, "-B", HOME / "tools" / "build_docs", site, "--program", program]
    executed = package and not notebooks.why_not(pathlib.Path(package[0]))
    if package and list(pathlib.Path(package[0]).glob("mahlwerk/_core*.so")):
        command += ["--package", package[0]]
    built = subprocess.run(command)
    if built.returncode:
        return built.returncode if built.returncode == SKIPPED else 1
    print(f"built in {time.monotonic() - begin:.0f} s")
    faults = (check_pages(site) + (check_notebooks(site) if executed else []) + check_search(site) + typeset.check(site) +
              browse.check(site))
    for fault in faults:
        print(fault)
    links = subprocess.run([sys.executable, "-B", pathlib.Path(__file__).with_name("links_test.py"), "site", site])
    return 1 if faults else links.returncode


sys.exit(main())
