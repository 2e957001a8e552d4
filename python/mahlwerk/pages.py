# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""HTML for notebooks."""

from __future__ import annotations

import html
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Union

__all__ = ["Page", "framed", "table_html"]


class Page:
    """A page of the program: shown as such in a notebook, as text by str(), in a file by save()."""

    def __init__(self, text: str):
        self.text = text

    def save(self, file: Union[str, os.PathLike[str]]) -> Path:
        """Writes the page, which needs no other file, and returns its path."""
        Path(file).write_text(self.text, encoding="utf-8")
        return Path(file)

    def __str__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        return framed(self.text)


def table_html(heading: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    def line(tag: str, cells: Iterable[str]) -> str:
        return "<tr>" + "".join(f"<{tag} style='text-align:left'>{html.escape(str(c))}</{tag}>"
                                for c in cells) + "</tr>"

    return "<table>" + line("th", heading) + "".join(line("td", row) for row in rows) + "</table>"


def framed(page: str) -> str:
    """A whole page as part of another, with its own scripts and styles."""
    content = html.escape(page, quote=True)
    return f'<iframe srcdoc="{content}" style="width:100%;height:640px;border:0"></iframe>'
