# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Copies the Markdown files and notebooks of the repository into one folder for Sphinx.

Notebooks are executed. Links between pages follow the pages to their places. A link to another file of the repository leads to
a copy of it in `source/`, a link to a folder to a page that lists it. Annotations of tests are left out.
"""
import base64
import fnmatch
import html
import json
import os
import pathlib
import re
import shutil

import notebooks
from pages import BELOW, HOME, HOWTO, LISTS, NAVIGATION, sources
from search_words import front_matter

LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\[\]]*\])*)\]\(([^()\s]+)\)")
CODE = re.compile(r"(`+)(?!`).*?(?<!`)\1(?!`)", re.S)
FENCE = re.compile(r"^\s*(`{3,}|~{3,})")
COMMENT = re.compile(r"^[ \t]*<!--.*?-->[ \t]*\n?", re.M | re.S)
PICTURES = (".svg", ".png")


class Stage:
    """The folder of sources of Sphinx, and the files that go into the site as they are."""

    def __init__(self, place: pathlib.Path, package: pathlib.Path) -> None:
        self.place, self.extra, self.kept = place / "pages", place / "extra", place / "notebooks"
        for old in place.glob("*"):
            if old != self.kept:
                shutil.rmtree(old)
        self.extra.mkdir(parents=True)
        self.package = package  # folder of the Python package
        self.sources = sources()
        self.folders: set[str] = set()
        self.generated: list[str] = []  # pages that are made from the program, in their order

    def generate(self, pages: dict[str, str]) -> None:
        for name, text in pages.items():
            self.write(name, text)
        self.generated += pages

    def write(self, name: str, text: str) -> None:
        file = self.place / (name + ".md")
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def pages(self) -> None:
        for source, name in self.sources.items():
            self.write(name, front_matter(name) + self.page(source, name))
        self.lists()

    def page(self, source: str, name: str) -> str:
        text = (HOME / source).read_text()
        if source.endswith(".ipynb"):
            text = self.notebook(source, name)
        text = "".join(part if code else self.prose(part, source, name) for code, part in parts(text))
        case = (HOME / source).parent / "case.toml"
        if source.startswith("examples/") and case.exists():
            text += f"\n## The case file\n\n```toml\n{case.read_text()}```\n"
        return text

    def notebook(self, source: str, name: str) -> str:
        """The cells of a notebook as Markdown, each with its outputs."""
        cells = json.loads((HOME / source).read_text())["cells"]
        why_not = notebooks.why_not(self.package)
        outputs = [[]] * len(cells) if why_not else notebooks.outputs(HOME / source, self.package, self.kept)
        made = []
        for number, (cell, shown) in enumerate(zip(cells, outputs), 1):
            text = "".join(cell["source"])
            made.append(text if cell["cell_type"] == "markdown" else f"```python\n{text}\n```")
            if why_not and number == 1:
                made.append(f"The outputs of the cells are missing here, because {why_not} where this page was made.")
            made += [self.output(one, f"{name}-{number}-{i}", name) for i, one in enumerate(shown, 1)]
        made.append(raw_link(relative(self.raw(source), name), "This notebook") + " as a file.\n")
        return "\n\n".join(made)

    def output(self, shown: dict, file: str, name: str) -> str:
        """What a cell prints or returns, or its picture, as a block of HTML."""
        data = shown["data"]
        if shown["kind"] in ("svg", "png"):
            picture = self.extra / (file := f"{file}.{shown['kind']}")
            picture.parent.mkdir(parents=True, exist_ok=True)
            picture.write_bytes(base64.b64decode(data))
            data = f'<img src="{relative(file, name)}" alt="{html.escape(shown["words"])}">'
        elif shown["kind"] == "text":
            data = f"<pre>{html.escape(data)}</pre>"
        return f'``````{{raw}} html\n<div class="output">{data}</div>\n``````'

    def prose(self, text: str, source: str, name: str) -> str:
        """A part of a page without fenced code."""
        text = COMMENT.sub("", text)
        kept: list[str] = []

        def keep(found: re.Match) -> str:
            kept.append(found[0])
            return f"\x00{len(kept) - 1}\x00"

        # Code in running text is left alone. A link may have code as its text.
        text = CODE.sub(keep, text)
        text = LINK.sub(lambda m: self.link(m, source, name), text)
        return re.sub("\x00(\\d+)\x00", lambda m: kept[int(m[1])], text)

    def link(self, found: re.Match, source: str, name: str) -> str:
        picture, words, target = found.groups()
        path, _, anchor = target.partition("#")
        if "://" in target or target.startswith("mailto:") or not path:
            return found[0]
        wanted = os.path.normpath(os.path.join(os.path.dirname(source), path))
        if not (HOME / wanted).exists():
            raise SystemExit(f"{source}: the link to '{target}' leads nowhere")
        page = self.sources.get(wanted) or self.sources.get(f"{wanted}/README.md")
        if page:
            return f"[{words}]({relative(page + '.md', name)}{'#' * bool(anchor)}{anchor})"
        if picture and wanted.endswith(PICTURES):
            copied = self.place / "pictures" / wanted
            copied.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(HOME / wanted, copied)
            return f"![{words}]({relative('pictures/' + wanted, name)})"
        if (HOME / wanted).is_dir():
            if wanted == "examples":
                return f"[{words}]({relative('examples/index.md', name)})"
            self.folders.add(wanted)
            return f"[{words}]({relative('source/' + wanted + '/index.md', name)})"
        return raw_link(relative(self.raw(wanted), name), words)

    def raw(self, wanted: str) -> str:
        """Copies a file of the repository into the site as text; returns its place there."""
        place = f"source/{wanted}.txt"
        copied = self.extra / place
        copied.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(HOME / wanted, copied)
        return place

    def lists(self) -> None:
        for folder in sorted(self.folders):
            name = f"source/{folder}/index"
            files = sorted(f.relative_to(HOME).as_posix() for f in (HOME / folder).rglob("*")
                           if f.is_file() and "__pycache__" not in f.parts)
            lines = [f"- {raw_link(relative(self.raw(f), name), os.path.relpath(f, folder))}"
                     for f in files]
            self.write(name, f"---\norphan: true\n---\n# {folder}\n\nFiles of this folder of the "
                       "repository:\n\n" + "\n".join(lines) + "\n")
        for name, (title, sentence, below) in LISTS.items():
            self.write(name, f"# {title}\n\n{sentence}\n\n" + toctree(self.matching(below), maxdepth=1))

    def matching(self, pattern: str) -> list[str]:
        names = sorted(f.relative_to(self.place).with_suffix("").as_posix()
                       for f in self.place.rglob("*.md"))
        order = [f"howto/{one}" for one in HOWTO] + self.generated
        found = [n for n in names if fnmatch.fnmatch(n, pattern) and not n.endswith("/index")]
        return sorted(found, key=lambda n: order.index(n) if n in order else len(order))

    def navigation(self) -> None:
        """Tables of contents; after all pages are written."""
        for name, below in BELOW.items():
            pages = self.matching(below) if isinstance(below, str) else below
            self.append(name, toctree(pages, hidden=True))
        for caption, entries in NAVIGATION.items():
            pages = []
            for entry in entries:
                pages += self.matching(entry) if "*" in entry else [entry]
            self.append("index", toctree(pages, hidden=True, caption=caption))

    def append(self, name: str, text: str) -> None:
        with (self.place / (name + ".md")).open("a") as out:
            out.write("\n" + text)


def parts(text: str) -> list[tuple[bool, str]]:
    """The text in parts: fenced code and equations (True), and the rest."""
    made: list[tuple[bool, list[str]]] = [(False, [])]
    fence = ""
    for line in text.splitlines(keepends=True):
        found = FENCE.match(line)
        if fence:
            made[-1][1].append(line)
            if found and found[1].startswith(fence) and not line.strip(" `~\n"):
                fence = ""
                made.append((False, []))
        elif found:
            fence = found[1]
            made.append((True, [line]))
        else:
            made[-1][1].append(line)
    return [(code, "".join(lines)) for code, lines in made]


def relative(target: str, page: str) -> str:
    return os.path.relpath(target, os.path.dirname(page) or ".")


def raw_link(target: str, words: str) -> str:
    return f'<a class="source" href="{html.escape(target)}">{words}</a>'


def toctree(pages: list[str], hidden: bool = False, caption: str = "",
            maxdepth: int = 2) -> str:
    options = "".join([":hidden:\n" * hidden, f":caption: {caption}\n" if caption else "",
                       f":maxdepth: {maxdepth}\n"])
    return "```{toctree}\n" + options + "\n" + "".join(f"/{page}\n" for page in pages) + "```\n"
