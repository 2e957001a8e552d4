# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Sphinx extension: docstrings of the Python package, and pages of the C++ interface, as the site wants them.

A docstring lists arguments as lines `name   meaning`, which may continue in indented lines. They become
a list. `code` in single backticks becomes code. On pages of C++, breathe nests everything in namespaces,
once for each header: their contents stay, the boxes and the warnings of their repetition go.
"""
import logging
import re

from docutils import nodes
from sphinx import addnodes
from sphinx.transforms import SphinxTransform

ARGUMENT = re.compile(r"^([a-z_]+) {2,}(\S.*)$")


def rewritten(lines: list[str]) -> list[str]:
    made: list[str] = []
    inside = False
    for line in lines:
        found = ARGUMENT.match(line)
        if found:
            if not inside and made and made[-1].strip():
                made.append("")
            made.append(f"- ``{found[1]}``: {found[2]}")
            inside = True
        elif inside and line.startswith(" "):
            made.append("  " + line.strip())
        else:
            if inside and line.strip():
                made.append("")
            inside = inside and not line.strip()
            made.append(line)
    return [re.sub(r"(?<![`:\w])`([^`\n]+)`(?!`)", r"``\1``", line) for line in made]


def process(app, what, name, obj, options, lines) -> None:
    if lines and re.fullmatch(r"Alias for field number \d+", lines[0]):
        lines[:] = []  # of a field that needs no words beside its name
    lines[:] = rewritten(lines)


class RepeatedNamespace(logging.Filter):
    def filter(self, record: logging.LogRecord) -> bool:
        text = record.getMessage()
        return not ("Duplicate C++ declaration" in text
                    and re.search(r"Declaration is '\.\. cpp:type:: \w+'", text))


class FlatNamespaces(SphinxTransform):
    default_priority = 840  # before the domains take entries of the index

    def apply(self, **_) -> None:
        seen: set[str] = set()
        for one in list(self.document.findall(addnodes.desc)):
            if one.get("domain") != "cpp" or not one[0].astext().startswith("namespace "):
                continue
            before = one.parent[one.parent.index(one) - 1]
            if isinstance(before, addnodes.index):
                before.parent.remove(before)
            places = [i for i in one[0]["ids"] if i not in seen]
            seen.update(places)
            anchors = "".join(f'<span id="{i}"></span>' for i in places)
            one.replace_self([nodes.raw("", anchors, format="html"), *one[-1].children])


def setup(app) -> dict:
    app.connect("autodoc-process-docstring", process)
    app.add_transform(FlatNamespaces)
    # First, before the filters that count warnings.
    for handler in logging.getLogger("sphinx").handlers:
        handler.filters.insert(0, RepeatedNamespace())
    return {"parallel_read_safe": True, "parallel_write_safe": True, "version": "1"}
