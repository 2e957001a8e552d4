# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Sphinx extension: docstrings of the Python package, and pages of the C++ interface, as the site wants them.

A docstring lists arguments as lines `name   meaning`, which may continue in indented lines. They become
a list. `code` in single backticks becomes code. On pages of C++, breathe nests everything in namespaces,
once for each header: their contents stay, the boxes and the warnings of their repetition go.
"""
import logging
import re

from sphinx import addnodes

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
    lines[:] = rewritten(lines)


class RepeatedNamespace(logging.Filter):
    def filter(self, record: logging.LogRecord) -> bool:
        text = record.getMessage()
        return not ("Duplicate C++ declaration" in text
                    and re.search(r"Declaration is '\.\. cpp:type:: \w+'", text))


def flatten_namespaces(app, tree) -> None:
    for one in list(tree.findall(addnodes.desc)):
        if one.get("domain") == "cpp" and one[0].astext().startswith("namespace "):
            one.replace_self(list(one[-1].children))


def setup(app) -> dict:
    app.connect("autodoc-process-docstring", process)
    app.connect("doctree-read", flatten_namespaces)
    # First, before the filters that count warnings.
    for handler in logging.getLogger("sphinx").handlers:
        handler.filters.insert(0, RepeatedNamespace())
    return {"parallel_read_safe": True, "parallel_write_safe": True, "version": "1"}
