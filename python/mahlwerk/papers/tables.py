# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Tables of a paper."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

from .. import _core
from .captures import Bin, CaptureBounds, bins_of, counted_bins, result_at
from .lines import Line, Points, Where, key_words
from .verdict import text

__all__ = ["CapturedTable", "MadeTable", "QuantityTable", "csv_line", "markdown", "markdown_cell"]

NAN = math.nan


@dataclass
class MadeTable:
    """A table with its cells as text, and its numbers as CSV."""

    heads: list[str] = field(default_factory=list)
    rows: list[list[str]] = field(default_factory=list)
    csv: str = ""
    note: str = ""


def csv_cell(cell: Any) -> str:
    if isinstance(cell, str):
        return _core.csv_cell(cell)
    return _core.shortest(cell) if math.isfinite(cell) else ""


def csv_line(cells: list[Any]) -> str:
    return ",".join(csv_cell(cell) for cell in cells) + "\n"


def markdown_cell(cell: str) -> str:
    return cell.replace("|", "\\|")


def markdown(table: MadeTable) -> str:
    def line(cells: list[str]) -> str:
        return "".join(f"| {markdown_cell(cell)} " for cell in cells) + "|\n"
    return line(table.heads) + "|---" * len(table.heads) + "|\n" + "".join(map(line, table.rows))


@dataclass
class QuantityTable:
    """Mean and interval of a quantity: a row for each combination of the other keys."""

    campaign: str
    quantity: str
    against: str
    where: Where
    ratio: bool = False  #: a column with the last value over the first

    def made(self, points: Points, campaign: Any = None) -> MadeTable:
        lines = points.lines(self.where, self.against, self.quantity)
        if not lines:
            return MadeTable()
        unit = points.unit(self.quantity)
        columns = list(dict.fromkeys(s.text for line in lines for s in line.spots))
        names = [*lines[0].keys, self.against, _core.column_name(self.quantity, unit),
                 _core.column_name(self.quantity + "_ci95", unit)]
        made = MadeTable([*lines[0].keys, *columns, *["last over first"] * self.ratio],
                         [self.row(line, columns, unit) for line in lines], csv_line(names))
        for line in lines:
            for value in columns:
                spot = next((s for s in line.spots if s.text == value), None)
                if spot is not None:
                    made.csv += csv_line([*line.values, value, spot.value, spot.ci95])
        label, _, _ = _core.traits(self.quantity)
        made.note = f"{label} against {key_words(self.against)}; ± is the 95 % confidence half-width."
        return made

    def row(self, line: Line, columns: list[str], unit: str) -> list[str]:
        cells = list(line.values)
        for value in columns:
            spot = next((s for s in line.spots if s.text == value), None)
            cells.append("-" if spot is None else text(spot.value, spot.ci95, unit))
        if self.ratio:
            first, last = line.spots[0].value, line.spots[-1].value
            ratio = last / first if first > 0 else NAN
            cells.append(f"{ratio:.2f}" if math.isfinite(ratio) else "-")
        return cells


@dataclass
class Strength:
    """A point with its bins of the pair of a table."""

    text: str  #: its value of `against`: "1000 J/kg"
    bounds: CaptureBounds
    all_bins: list[Bin]
    bins: list[Bin]

    def nearest(self, energy: float) -> Any:
        """The bin nearest to an energy, on a logarithmic scale; None without collisions."""
        return min(self.bins, key=lambda b: abs(math.log(b.energy / energy)), default=None)

    def rate(self, energy: float) -> float:
        """[1/s] Collisions in the decade around an energy."""
        return sum(b.rate for b in self.bins if abs(math.log10(b.energy / energy)) < 0.5)


@dataclass
class CapturedTable:
    """Grains that a collision captures, by energy, between their bounds."""

    campaign: str
    one: str  #: the pair, as in capture.csv
    other: str
    against: str
    energies: list[str]  #: a row for the decade around each
    where: Where
    quantity: str = ""

    def strengths(self, points: Points) -> list[Strength]:
        """The selected points, by descending value of `against`."""
        found = []
        for spot in reversed((points.lines(self.where, self.against, "") or [Line()])[0].spots):
            result = result_at(spot)
            if result is None:
                continue
            bins = bins_of(result)
            found.append(Strength(spot.text, CaptureBounds(result.case), bins,
                                  [b for b in bins if (b.one, b.other) == (self.one, self.other)]))
        return found

    def row(self, strengths: list[Strength], energy: float) -> list[float]:
        """Numbers for the decade around an energy; empty without collisions of this pair."""
        middle = strengths[len(strengths) // 2]
        at = middle.nearest(energy)
        ends = None if at is None else middle.bounds.at(self.one, self.other, at.energy)
        if ends is None:
            return []
        near = [one.nearest(energy) for one in strengths]
        return [at.energy, middle.rate(energy), ends[0], *(NAN if b is None else b.grains for b in near),
                ends[1], at.energy_per_grain, at.specific_energy]

    def made(self, points: Points, campaign: Any = None) -> MadeTable:
        strengths = self.strengths(points)
        if not strengths:
            return MadeTable()
        middle = strengths[len(strengths) // 2].text
        names = ["energy_J", "rate_per_s", "lower_bound", *(f"grains at {s.text}" for s in strengths),
                 "upper_bound", "energy_per_grain_J", "specific_energy_J_per_kg"]
        made = MadeTable(["energy of a hit", "hits/s in its decade", "lower bound of N",
                          *(f"N at {s.text}" for s in strengths), "upper bound of N",
                          f"energy per grain at {middle}", "per mass"], [], csv_line(names))
        for energy in self.energies:
            row = self.row(strengths, _core.si_value(energy))
            if row:
                made.rows.append(captured_cells(row))
                made.csv += csv_line(row)
        counts = [counted_bins(s.bounds, s.all_bins) for s in strengths]
        made.note = (f"N is the number of captured grains, {self.one} with {self.other}. "
                     f"{sum(c[1] for c in counts)} of {sum(c[0] for c in counts)} bins of energy lie outside "
                     "the bounds.")
        return made


def captured_cells(row: list[float]) -> list[str]:
    return [text(row[0], NAN, "J"), f"{row[1]:.3g}",
            *(f"{v:.0f}" if math.isfinite(v) else "-" for v in row[2:-2]),
            text(row[-2], NAN, "J"), text(1e-3 * row[-1], NAN, "J/g")]
