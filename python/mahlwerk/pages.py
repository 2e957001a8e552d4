# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""HTML for notebooks."""

from __future__ import annotations

import html
from collections.abc import Iterable

__all__ = ["framed", "table_html"]


def table_html(heading: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    def line(tag: str, cells: Iterable[str]) -> str:
        return "<tr>" + "".join(f"<{tag} style='text-align:left'>{html.escape(str(c))}</{tag}>"
                                for c in cells) + "</tr>"

    return "<table>" + line("th", heading) + "".join(line("td", row) for row in rows) + "</table>"


def framed(page: str) -> str:
    """A whole page as part of another, with its own scripts and styles."""
    content = html.escape(page, quote=True)
    return f'<iframe srcdoc="{content}" style="width:100%;height:640px;border:0"></iframe>'
