# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""What a paper writes: its page, and its checks as text, Markdown and CSV."""

from __future__ import annotations

import base64
import html
from dataclasses import dataclass, field
from typing import Any

from .. import _core
from .figures import MadeFigure
from .paper import Check, Paper, Table
from .tables import MadeTable, csv_line, markdown_cell
from .verdict import HOLDS, Verdict

__all__ = ["PaperResult", "checks_csv", "checks_markdown", "checks_text", "page", "paper_data"]


@dataclass
class PaperResult:
    """A paper with the results of its campaigns."""

    paper: Paper
    verdicts: list[Verdict]  #: by check
    figures: list[MadeFigure]
    tables: list[tuple[Table, MadeTable]]
    seconds: dict[str, float]  #: [s] of CPU time by campaign
    changed: list[str]  #: overrides of the campaigns' settings, "run.time = 2 s"
    warnings: str  #: lines for the terminal
    boxes: str  #: of warnings and notes on the page
    notices: list[Any] = field(default_factory=list)  #: the same as JSON

    def judged(self, own: bool) -> list[tuple[Check, Verdict]]:
        return [(c, v) for c, v in zip(self.paper.checks, self.verdicts) if c.own == own]

    @property
    def has_own(self) -> bool:
        return any(check.own for check in self.paper.checks)

    def why(self, check: Check) -> str:
        """Explanations apply to the original settings."""
        return "" if self.changed else check.why

    @property
    def changes(self) -> str:
        return f"Run with {', '.join(self.changed)}, unlike the campaigns of the paper." if self.changed else ""

    def score_of(self, own: bool) -> str:
        """Counts by verdict: "Of 3 claims: yes 2, no 1."."""
        those = self.judged(own)
        counts = [(one, sum(v.holds == one for _, v in those)) for one in HOLDS]
        said = ", ".join(f"{one} {count}" for one, count in counts if count)
        what = ("statement" if own else "claim") + ("" if len(those) == 1 else "s") + (" of ours" if own else "")
        return f"Of {len(those)} {what}: {said}."

    @property
    def score(self) -> str:
        return self.score_of(False) + (f" {self.score_of(True)}" if self.has_own else "")


def paper_data(result: PaperResult) -> dict[str, Any]:
    """The verdicts with the head of every study: paper.json."""
    claims = [{"figure": check.figure, "says": check.says, "own": check.own, "found": verdict.finding,
               "holds": verdict.holds, "why": result.why(check)}
              for check, verdict in zip(result.paper.checks, result.verdicts)]
    return {"study": "paper", "mahlwerk": _core.version, "title": result.paper.title,
            "case": result.paper.folder.name, "claims": claims, "cpu_seconds": result.seconds,
            "remarks": [line for line in (result.score, result.changes) if line], "notices": result.notices}


def checks_csv(result: PaperResult) -> str:
    text = csv_line(["figure", "the_paper_says", "we_find", "holds", "why", "own"])
    for check, verdict in zip(result.paper.checks, result.verdicts):
        text += csv_line([check.figure, check.says, verdict.finding, verdict.holds, result.why(check),
                          "yes" if check.own else "no"])
    return text


def checks_markdown(result: PaperResult) -> str:
    parts = []
    for own in (False, True):
        if not result.judged(own):
            continue
        rows = [f"| figure | {'we say' if own else 'the paper says'} | we find | holds | why |\n"
                "|---|---|---|---|---|\n"]
        for check, verdict in result.judged(own):
            cells = (check.figure, check.says, verdict.finding, verdict.holds, result.why(check))
            rows.append("| " + " | ".join(map(markdown_cell, cells)) + " |\n")
        parts.append("".join(rows))
    return "\n".join(parts)


def checks_text(result: PaperResult) -> str:
    """The checks for the terminal."""
    text = ""
    for own in (False, True):
        if own and result.has_own:
            text += "\nstatements of ours, not of the paper:\n"
        for check, verdict in result.judged(own):
            text += f"{check.figure:<6} {verdict.holds:<14} {check.says}\n{'':22}{verdict.finding}\n"
            if result.why(check):
                text += f"{'':22}why: {result.why(check)}\n"
    told = f"{text}\n{result.score}\n"
    if result.changes:
        told += result.changes + "\n"
    return told + (f"\n{result.warnings}" if result.warnings else "")


def cells(row: list[str], tag: str = "td") -> str:
    return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in row) + "</tr>\n"


def wide_table(heads: list[str], rows: str) -> str:
    return (f'<div class="wide"><table>\n<thead>{cells(heads, "th").strip()}</thead>\n<tbody>\n{rows}</tbody>'
            "</table></div>\n")


def checks_table(result: PaperResult, own: bool) -> str:
    rows = ""
    for check, verdict in result.judged(own):
        said = [html.escape(text) for text in (check.figure, check.says, verdict.finding)]
        rows += "<tr>" + "".join(f"<td>{text}</td>" for text in (
            *said, f"<b>{verdict.holds}</b>", html.escape(result.why(check)))) + "</tr>\n"
    return wide_table(["Figure", "We say" if own else "The paper says", "We find", "Holds", "Why"], rows)


def picture(figure: MadeFigure, svg: bytes) -> str:
    """The figure as an image within the page: names in one drawing do not meet those of another."""
    data = base64.b64encode(svg).decode("ascii")
    number, caption = html.escape(figure.number), html.escape(figure.caption)
    return (f'<figure>\n<img style="max-width:100%;height:auto" alt="Figure {number}" src="data:image/svg+xml;base64,{data}">\n'
            f"<figcaption><b>Figure {number}.</b> {caption}</figcaption>\n</figure>\n")


def table_sections(result: PaperResult) -> str:
    body = ""
    for table, made in result.tables:
        about = f" {table.about}" if table.about else ""
        body += (f"<h3>{html.escape(table.title)}</h3>\n"
                 + wide_table(made.heads, "".join(map(cells, made.rows)))
                 + f"<p><small>{html.escape(made.note + about)}</small></p>\n")
    return f"<h2>Tables</h2>\n{body}" if body else ""


def campaigns_table(result: PaperResult) -> str:
    rows = "".join(f'<tr><td><a href="{name}/campaign.html">{name}</a></td>'
                   f'<td class="n">{seconds:.2g} s</td></tr>\n' for name, seconds in result.seconds.items())
    return wide_table(["Campaign", "CPU time"], rows)


def page(result: PaperResult, svg: dict[str, bytes]) -> str:
    """paper.html: figures, and each check with its finding. `svg`: the figures by file."""
    paper = result.paper
    body = f'<p class="lead">{html.escape(paper.source)}. {html.escape(result.score)}</p>\n'
    if result.changed:
        body += f'<div class="box warn"><p>{html.escape(result.changes)}</p></div>\n'
    body += result.boxes
    if paper.about:
        body += f'<section class="box"><p>{html.escape(paper.about)}</p></section>\n'
    if result.judged(False):
        body += "<h2>Claims of the paper and findings</h2>\n" + checks_table(result, False)
    if result.has_own:
        body += "<h2>Statements of ours, not of the paper</h2>\n" + checks_table(result, True)
    body += ("<p><small>± is the 95 % confidence half-width over independent replicates. Every number in "
             '"We find" is from the runs of this folder; docs/papers.md has the rules by which a claim '
             "holds.</small></p>\n<h2>Figures</h2>\n")
    body += "".join(picture(one, svg[one.file]) for one in result.figures if not one.empty)
    body += table_sections(result) + "<h2>Campaigns</h2>\n" + campaigns_table(result)
    whole = _core.two_digits(sum(result.seconds.values()))
    return _core.page(paper.title, body, f"Mahlwerk {_core.version}, {whole} s of CPU time.")
