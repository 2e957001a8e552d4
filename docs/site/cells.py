# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Sphinx extension: cells of tables with many columns are marked by the length of their text.

A browser makes columns as narrow as a word before a table scrolls. The style sheet gives marked cells a least width on
narrow screens. Two columns have room there.
"""
from docutils import nodes
from sphinx.transforms import SphinxTransform

MARKS = {60: "long", 10: "some"}  # more characters than: class


class MarkedCells(SphinxTransform):
    default_priority = 840

    def apply(self, **_) -> None:
        for row in self.document.findall(nodes.row):
            for cell in row.children if len(row) > 2 else ():
                cell["classes"] += [mark for least, mark in MARKS.items() if len(cell.astext()) > least][:1]


def setup(app) -> dict:
    app.add_transform(MarkedCells)
    return {"parallel_read_safe": True, "parallel_write_safe": True, "version": "1"}
