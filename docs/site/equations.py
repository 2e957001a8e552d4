# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Sphinx extension: equations with their labels, and links from citations to them.

An equation is a ```math fence of TeX that ends with its label, \\tag{geo.1} (or two, \\tag{geo.1, geo.2}). In tables and
running text a label is **(geo.1)**. The label is set to the right and is the target of every citation, (geo.1),
(geo.1, geo.2) or (geo.1 to geo.3), in running text.
"""
import pathlib
import re

from docutils import nodes
from docutils.transforms import Transform

TAG = re.compile(r"\s*\\tag\{([a-z]{3}\.\d+(?:, [a-z]{3}\.\d+)*)\}\s*$")
WRITTEN = re.compile(r"\\tag\{([a-z]{3}\.\d+(?:, [a-z]{3}\.\d+)*)\}|\*\*\(([a-z]{3}\.\d+)\)\*\*")
MARKED = re.compile(r"\(([a-z]{3}\.\d+)\)")
CITATION = re.compile(r"(?<![\w./-])([a-z]{3}\.\d+)(?!\.?\w)")

PUNCTUATION = tuple(".,:;)?!")
WORD_JOINER = "\u2060"

NO_CITATIONS = (nodes.literal, nodes.literal_block, nodes.math, nodes.math_block, nodes.reference, nodes.title, nodes.raw,
                nodes.comment)


def written(folder: pathlib.Path) -> dict[str, str]:
    """Label: page of each equation."""
    found = {}
    for file in folder.rglob("*.md"):
        page = file.relative_to(folder).with_suffix("").as_posix()
        for tags, mark in WRITTEN.findall(file.read_text()):
            for label in (tags or mark).split(", "):
                found[label] = page
    return found


def set_equation(node: nodes.literal_block) -> None:
    """The TeX as a block of MathJax, its labels beside it: they stay in sight where a long equation scrolls."""
    text = node.astext().strip()
    tags = TAG.search(text)
    tex = TAG.sub("", text)
    box = nodes.container("", nodes.math_block(tex, tex, nowrap=False, number=None, label=None), classes=["equation"])
    for label in tags[1].split(", ") if tags else []:
        box += nodes.inline("", f"({label})", ids=[f"eq-{label}"], classes=["label"])
    node.replace_self(box)


class Equations(Transform):
    default_priority = 500

    def apply(self) -> None:
        env = self.document.settings.env
        places = env.app.equation_places
        for node in list(self.document.findall(nodes.literal_block)):
            if node.get("language") == "math":
                set_equation(node)
        for node in list(self.document.findall(nodes.math)):  # no new line between a symbol and the comma that follows
            after = node.next_node(descend=False, siblings=True)
            if isinstance(after, nodes.Text) and after.astext()[:1] in PUNCTUATION:
                after.parent.replace(after, nodes.Text(WORD_JOINER + after.astext()))
        for node in self.document.findall(nodes.strong):  # in tables and running text
            if found := MARKED.fullmatch(node.astext()):
                node["ids"].append(f"eq-{found[1]}")
                node["classes"].append("label")
        for node in list(self.document.findall(nodes.Text)):
            if "label" not in node.parent.get("classes", []) and not any(
                    isinstance(up, NO_CITATIONS) for up in ancestors(node)):
                self.cite(node, places, env)

    def cite(self, node: nodes.Text, places: dict[str, str], env) -> None:
        text, made, done = node.astext(), [], 0
        for found in CITATION.finditer(text):
            if found[1] not in places:
                continue
            made.append(nodes.Text(text[done:found.start()]))
            uri = env.app.builder.get_relative_uri(env.docname, places[found[1]])
            made.append(nodes.reference("", found[1], internal=True, classes=["eq"],
                                        refuri=f"{uri}#eq-{found[1]}"))
            done = found.end()
        if made:
            node.parent.replace(node, [*made, nodes.Text(text[done:])])


def ancestors(node: nodes.Node):
    while node.parent is not None:
        node = node.parent
        yield node


def scan(app) -> None:
    app.equation_places = written(pathlib.Path(app.srcdir))


class Doors(Transform):
    """The first table of the first page is set as cards, one for each column."""
    default_priority = 510

    def apply(self) -> None:
        if self.document.settings.env.docname != "index":
            return
        for table in list(self.document.findall(nodes.table))[:1]:
            rows = [list(row.findall(nodes.entry)) for row in table.findall(nodes.row)]
            cards = [nodes.container("", *[child for entry in column for child in entry.children],
                                     classes=["door"]) for column in zip(*rows)]
            table.replace_self(nodes.container("", *cards, classes=["doors"]))


def setup(app) -> dict:
    app.connect("builder-inited", scan)
    app.add_transform(Equations)
    app.add_transform(Doors)
    return {"parallel_read_safe": True, "parallel_write_safe": True, "version": "1"}
