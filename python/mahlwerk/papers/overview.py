# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The checks of several sets of measured data side by side."""

from __future__ import annotations

import html
import math
from dataclasses import dataclass

from .. import _core
from .measured import Agreement
from .page import PaperResult
from .tables import csv_line, markdown_cell
from .verdict import HOLDS

__all__ = ["Row", "overview_csv", "overview_markdown", "overview_page", "rows_of", "score"]

CLOSE = 0.1  # [1] deviation of a set that is called exact


@dataclass
class Row:
    folder: str  #: name of the set
    title: str
    says: str  #: what was measured
    found: str
    status: str  #: "verified", "quoted", "unverified"; empty without measured values
    holds: str
    deviation: float  #: [1] largest of the band; NaN without measured values

    @property
    def percent(self) -> str:
        return f"{100 * self.deviation:.0f} %" if math.isfinite(self.deviation) else ""


def rows_of(result: PaperResult, folder: str) -> list[Row]:
    return [Row(folder, result.paper.title, check.says, verdict.finding,
                check.rule.measured.status if isinstance(check.rule, Agreement) else "", verdict.holds,
                verdict.deviation)
            for check, verdict in zip(result.paper.checks, result.verdicts)]


def score(rows: list[Row]) -> str:
    sets = {row.folder for row in rows}
    judged = {row.folder for row in rows if row.holds != "undecided"}
    exact = sorted({row.folder for row in rows if row.status != "unverified" and row.deviation <= CLOSE})
    counts = [(one, sum(row.holds == one for row in rows)) for one in HOLDS]
    said = ", ".join(f"{one} {count}" for one, count in counts if count)
    named = f": {', '.join(exact)}" if exact else ""
    return (f"{len(sets)} sets of measured data, {len(judged)} with a verdict. Of {len(rows)} claims: {said}. "
            f"In {len(exact)} sets a whole band lies within {100 * CLOSE:.0f} % of the measured values{named}.")


def overview_markdown(rows: list[Row]) -> str:
    text = ("| set | measured | measured and predicted | agrees | largest deviation | numbers |\n"
            "|---|---|---|---|---|---|\n")
    for row in rows:
        text += (f"| [{row.folder}](../validation/{row.folder}/README.md) | {markdown_cell(row.says)} | "
                 f"{markdown_cell(row.found)} | {row.holds} | {row.percent} | {row.status} |\n")
    return text


def overview_csv(rows: list[Row]) -> str:
    return csv_line(["set", "measured", "found", "agrees", "largest_deviation", "numbers"]) + "".join(
        csv_line([row.folder, row.says, row.found, row.holds,
                  f"{row.deviation:.4g}" if math.isfinite(row.deviation) else "", row.status]) for row in rows)


def overview_page(rows: list[Row]) -> str:
    body = (f'<p class="lead">{html.escape(score(rows))}</p>\n<div class="wide"><table>\n<thead><tr><th>Set</th>'
            "<th>Measured</th><th>Measured and predicted</th><th>Agrees</th><th class=\"n\">Largest deviation</th>"
            "<th>Numbers</th></tr></thead>\n<tbody>\n")
    for row in rows:
        body += (f'<tr><td><a href="../{html.escape(row.folder)}/paper.html">{html.escape(row.title)}</a></td>'
                 f"<td>{html.escape(row.says)}</td><td>{html.escape(row.found)}</td><td><b>{row.holds}</b></td>"
                 f'<td class="n">{row.percent}</td><td>{row.status}</td></tr>\n')
    return _core.page("Measured mills and predictions", body + "</tbody></table></div>\n",
                      f"Mahlwerk {_core.version}.")
