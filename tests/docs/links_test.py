# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Every link of the documents leads somewhere, and the site needs no other server.

    links_test.py sources       relative links and anchors of all Markdown files; form of other links
    links_test.py site FOLDER   links, anchors, pictures, scripts, styles and fonts of the built site
    links_test.py self-test

Nothing is fetched from the network: of links to other servers only the form is checked.
"""
import functools
import html.parser
import pathlib
import re
import sys
import tempfile
import urllib.parse

import commands

HOME = pathlib.Path(__file__).resolve().parents[2]
LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\[\]]*\])*\]\(\s*<?([^()\s<>]+)>?(?:\s+\"[^\"]*\")?\s*\)")
DEFINITION = re.compile(r"^\s*\[[^\]]+\]:\s+(\S+)", re.M)
FENCE = re.compile(r"^([ \t]*)(`{3,}|~{3,}).*?^\1\2[`~]*\s*$", re.M | re.S)
CODE = re.compile(r"(`+)(?!`)(.*?)(?<!`)\1(?!`)", re.S)
HEADING = re.compile(r"^(#{1,6})\s+(.*?)\s*#*\s*$", re.M)
OUTSIDE = ("http", "https", "mailto")


# Markdown

def prose(text: str) -> str:
    """The text without fenced code, comments and code in lines."""
    text = re.sub(r"<!--.*?-->", "", FENCE.sub("", text), flags=re.S)
    return CODE.sub("", text)


def slug(heading: str) -> str:
    """The anchor that code-hosting pages and MyST make of a heading."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    text = re.sub(r"[*`]|(?<!\w)_|_(?!\w)", "", text)
    return re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")


@functools.lru_cache(None)
def anchors(file: pathlib.Path) -> frozenset[str]:
    text = re.sub(r"<!--.*?-->", "", FENCE.sub("", file.read_text()), flags=re.S)
    found: list[str] = re.findall(r"<a (?:id|name)=\"([^\"]+)\"", text)
    for _, heading in HEADING.findall(text):
        name, number = slug(heading), 0
        while (name if not number else f"{name}-{number}") in found:
            number += 1
        found.append(name if not number else f"{name}-{number}")
    return frozenset(found)


def fault_of_form(target: str) -> str:
    """What is wrong with the form of a link to another server; "" for nothing."""
    parts = urllib.parse.urlsplit(target)
    if parts.scheme == "mailto":
        return "" if re.fullmatch(r"[^@\s]+@[^@\s]+\.\w+", parts.path) else "is no address"
    if parts.scheme == "http":
        return "is not https"
    return "" if re.fullmatch(r"[\w.-]+\.[a-z]{2,}(:\d+)?", parts.netloc) else "has no server"


def fault_of_link(file: pathlib.Path, target: str) -> str:
    if urllib.parse.urlsplit(target).scheme in OUTSIDE:
        return fault_of_form(target)
    path, _, anchor = urllib.parse.unquote(target).partition("#")
    wanted = (file.parent / path).resolve() if path else file
    if path.startswith("/") or not wanted.exists():
        return "leads nowhere"
    if anchor and wanted.is_dir():
        wanted = wanted / "README.md"
    if anchor and wanted.suffix == ".md" and anchor not in anchors(wanted):
        return f"names no heading of {wanted.name}"
    return ""


def check_sources(home: pathlib.Path) -> list[str]:
    faults, count = [], 0
    for file in [*commands.documents(home), *home.glob("CHANGELOG.md")]:
        text = prose(file.read_text())
        for target in LINK.findall(text) + DEFINITION.findall(text):
            count += 1
            if what := fault_of_link(file, target):
                faults.append(f"{file.relative_to(home)}: the link '{target}' {what}")
    print(f"{count} links of Markdown files")
    return faults


# The site

class Page(html.parser.HTMLParser):
    """Anchors of a page, its links, and what a browser loads for it."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.anchors: set[str] = set()
        self.links: list[str] = []
        self.loads: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag, attributes) -> None:
        given = {name: value or "" for name, value in attributes}
        self.anchors |= {given[name] for name in ("id", "name") if name in given}
        if tag == "a" and "href" in given:
            self.links.append(given["href"])
        elif tag == "link" and "href" in given:
            wanted = {"stylesheet", "icon", "preload", "manifest"} & set(given.get("rel", "").split())
            (self.loads if wanted else self.links).append(given["href"])
        for name in ("src", "data", "poster"):
            if name in given and tag in ("script", "img", "iframe", "source", "video", "object", "embed"):
                self.loads.append(given[name])


@functools.lru_cache(None)
def page(file: pathlib.Path) -> Page:
    return Page(file.read_text())


def fault_in_site(site: pathlib.Path, file: pathlib.Path, target: str, loads: bool) -> str:
    parts = urllib.parse.urlsplit(target)
    if parts.scheme == "data":
        return ""
    if parts.scheme or parts.netloc:
        return "comes from another server" if loads else fault_of_form(target)
    path = urllib.parse.unquote(parts.path)
    wanted = (file.parent / path).resolve() if path else file
    if path.startswith("/"):
        return "is absolute"
    if site not in wanted.parents and wanted != site:
        return "leads out of the site"
    if wanted.is_dir():
        wanted = wanted / "index.html"
    if not wanted.is_file():
        return "leads nowhere"
    anchor = urllib.parse.unquote(parts.fragment)
    if anchor and wanted.suffix == ".html" and anchor not in page(wanted).anchors:
        return "names no place of the page"
    return ""


def check_site(site: pathlib.Path) -> list[str]:
    site, faults, count = site.resolve(), [], 0
    for file in sorted(site.rglob("*.html")):
        for loads, targets in ((False, page(file).links), (True, page(file).loads)):
            for target in targets:
                count += 1
                if what := fault_in_site(site, file, target, loads):
                    faults.append(f"{file.relative_to(site)}: '{target}' {what}")
        if re.search(r"<!--\s*test:", file.read_text()):
            faults.append(f"{file.relative_to(site)}: shows an annotation of the tests")
    for file in sorted(site.rglob("*.css")):
        text = re.sub(r"/\*.*?\*/", "", file.read_text(), flags=re.S)
        # Not within url('data:...'), which may hold addresses of name spaces.
        text = re.sub(r"url\(\s*(['\"]?)data:.*?\1\s*\)", "", text, flags=re.S)
        imported = re.findall(r"@import\s+['\"]([^'\"]+)['\"]", text)
        for target in imported + re.findall(r"url\(\s*['\"]?([^'\")]+)", text):
            count += 1
            if what := fault_in_site(site, file, target, True):
                faults.append(f"{file.relative_to(site)}: '{target}' {what}")
    print(f"{count} links and files of the site")
    return faults if count else ["the site has no pages"]


def self_test() -> int:
    assert slug("How `sure`, and *why*?") == "how-sure-and-why"
    assert slug("[Wear](x.md) & heat_capacity") == "wear--heat_capacity"
    with tempfile.TemporaryDirectory() as folder:
        home = pathlib.Path(folder)
        (home / "a.md").write_text("# One two\n\n# One two\n\n```sh\n[x](none)\n```\n`[x](none)` "
                                   "[x](#one-two-1) [y](b.md#b) ![p](none.svg) [z](https:///)\n")
        (home / "b.md").write_text("# B\n\n[a](a.md#three) [d](http://a.org)\n")
        faults = check_sources(home)
        assert [f.split("'")[1] for f in faults] == ["none.svg", "https:///", "a.md#three",
                                                     "http://a.org"], faults
        (home / "i.html").write_text('<a href="#x"></a><a href="j.html#y"></a><p id="y"></p>'
                                     '<script src="https://a.org/x.js"></script><img src="n.png">'
                                     '<a href="https://a.org/">a</a><!-- test: slow -->')
        (home / "j.html").write_text('<a id="y" href="../k.html"></a>')
        (home / "s.css").write_text("@import url(/n.css); a { b: url('data:x,http://w3.org') }")
        faults = check_site(home)
        assert len(faults) == 6, faults
    print("the reader of links is sound")
    return 0


def main() -> int:
    if sys.argv[1:] == ["self-test"]:
        return self_test()
    if sys.argv[1:] == ["sources"]:
        faults = check_sources(HOME)
    elif len(sys.argv) == 3 and sys.argv[1] == "site":
        faults = check_site(pathlib.Path(sys.argv[2]))
    else:
        print(__doc__, file=sys.stderr)
        return 2
    print("\n".join(faults + [f"{len(faults)} faults"]))
    return 1 if faults else 0


sys.exit(main())
