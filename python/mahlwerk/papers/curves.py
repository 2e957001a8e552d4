# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Figures of a quantity over a key: points with intervals, fitted laws, bands, measured values."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Optional

from .. import _core
from .lines import Line, Point, Points, Spot, Where, key_words, same_value
from .measured import Measurement
from .style import COLOURS, DASHES, MARKERS, mathtext, wrapped
from .tables import csv_line
from .verdict import FORMS, fitted_law

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["Curve", "Plot"]

NAN = math.nan
STEPS = 60  # of the curve of a law
LETTERS_OF_HEIGHT = 32  # beside the axes


@dataclass
class Curve:
    """What a panel draws of a campaign."""

    campaign: str
    quantity: str
    against: str
    law: str
    where: Where
    band_over: tuple[str, ...]
    nominal: Mapping[str, str]
    measured: Optional[Measurement]

    def plot(self, points: Points) -> Plot:
        plot = Plot(self, points)
        plot.series = plot.lines_or_bands()
        if self.measured is not None:
            plot.series.append(plot.of_measured(self.measured))
        return plot


@dataclass
class Series:
    """Points, a line or a band of a plot; y, low and high in SI units."""

    kind: str  #: "mean", "law", "band", "measured"
    name: str  #: with marks for symbols
    colour: int = 0
    x: list[float] = field(default_factory=list)
    y: list[float] = field(default_factory=list)
    low: list[float] = field(default_factory=list)
    high: list[float] = field(default_factory=list)
    legend: Optional[str] = None  #: other words there; "": none


class Plot:
    """The series of a panel, on its axes."""

    def __init__(self, curve: Curve, points: Points):
        self.curve, self.points = curve, points
        self.x_unit = points.unit_of_key(curve.against)
        self.mixed = points.mixed(curve.where, curve.against)
        self.y_unit = points.unit(curve.quantity)
        _, self.least, self.most = _core.traits(curve.quantity)
        self.note = ""
        self.series: list[Series] = []

    # Series

    def clipped(self, end: float, value: float = NAN) -> float:
        """An end of an interval in the range of the quantity; a value outside stays in its interval."""
        least, most = min(self.least, value), max(self.most, value)
        return end if math.isnan(end) else min(max(end, least), most)

    def of_points(self, spots: list[Spot], name: str, colour: int) -> Series:
        return Series("mean", name, colour, [s.x for s in spots], [s.value for s in spots],
                      [self.clipped(s.low, s.value) for s in spots],
                      [self.clipped(s.high, s.value) for s in spots])

    def of_law(self, line: Line, colour: int) -> Optional[Series]:
        law = fitted_law(self.curve.law, line) if self.curve.law else None
        if law is None:
            return None
        least, most = min(s.x for s in line.spots), max(s.x for s in line.spots)
        x = [_core.lerp(least, most, i / STEPS) for i in range(STEPS + 1)]
        return Series("law", line.others, colour, x, [law.at(v) for v in x], [NAN] * len(x),
                      [NAN] * len(x), legend=None)

    def words_of_law(self, line: Line, unit: tuple[float, str]) -> str:
        law = fitted_law(self.curve.law, line)
        return (f"{line.others}: " if line.others else "") + _core.law_words(
            FORMS[self.curve.law], law.coefficients, law.reference, law.r_squared, self.curve.against,
            self.x_unit, self.curve.quantity, *unit)

    def of_lines(self, lines: list[Line]) -> list[Series]:
        """Points and laws of each line. In a figure of several lines the curves name them, and a note
        explains the points."""
        alone = len(lines) == 1 and not lines[0].others
        made: list[Series] = []
        for i, line in enumerate(lines):
            law = self.of_law(line, i)
            points = self.of_points(line.spots, line.others, i)
            points.legend = self.words_of_points(lines) if alone else "" if law else line.others
            made += [points] if law is None else [law, points]
        if not alone and lines:
            self.note = "points: " + self.words_of_points(lines)
        self.name_laws(made, lines)
        return made

    def name_laws(self, made: list[Series], lines: list[Line]) -> None:
        unit = self.multiple(made)
        for one in made:
            if one.kind == "law":
                one.name = self.words_of_law(lines[one.colour], unit)

    def words_of_points(self, lines: list[Line]) -> str:
        """ "mean of 5 replicates, bars: 95 % interval"."""
        spots = [s for line in lines for s in line.spots]
        counts = [s.point.value.get("replicates", NAN) for s in spots]
        counts = [c for c in counts if math.isfinite(c)]
        words = "mean"
        if counts and max(counts) == 1:
            words = "one replicate"
        elif counts:
            least, most = min(counts), max(counts)
            words += f" of {least:g} replicates" if least == most else f" of {least:g} to {most:g} replicates"
        return words + (", bars: 95 % interval" if any(s.ci95 > 0 for s in spots) else "")

    def lines_or_bands(self) -> list[Series]:
        curve = self.curve
        if not curve.band_over:
            return self.of_lines(self.points.lines(curve.where, curve.against, curve.quantity))
        made, nominal = [], []
        for i, (others, spots) in enumerate(self.bands()):
            made.append(self.of_band(others, spots, i))
            points = [s for s in spots if self.is_nominal(s.point)]
            if points:
                nominal.append(Line(others, points))
        return made + self.of_lines(nominal)

    def bands(self) -> list[tuple[str, list[Spot]]]:
        """The spots of each combination of the keys that are no free numbers."""
        curve = self.curve
        free = [k for k, key in enumerate(self.points.keys) if key in curve.band_over]
        chosen = self.points.selected(curve.where)
        blank = [replace(p, values=["" if k in free else v for k, v in enumerate(p.values)])
                 for p in chosen]
        original = {id(b): p for b, p in zip(blank, chosen)}
        blanked = Points(self.points.keys, self.points.units, blank, self.points.following)
        return [(line.others, [replace(s, point=original[id(s.point)]) for s in line.spots])
                for line in blanked.lines({}, curve.against, curve.quantity)]

    def is_nominal(self, point: Point) -> bool:
        keys = self.points.keys
        return bool(self.curve.nominal) and all(
            key in keys and same_value(point.values[keys.index(key)], value)
            for key, value in self.curve.nominal.items())

    def of_band(self, others: str, spots: list[Spot], colour: int) -> Series:
        """From the lowest to the highest end of the intervals at each x."""
        words = ", ".join(_core.symbol_of_key(key) or key_words(key) for key in self.curve.band_over)
        made = Series("band", (f"{others}: " if others else "") + f"all values of {words}, with 95 % intervals",
                      colour)
        for s in spots:
            if not math.isfinite(s.x) or not math.isfinite(s.value):
                continue
            half = s.ci95 if math.isfinite(s.ci95) else 0.0
            if not made.x or made.x[-1] != s.x:
                made.x.append(s.x)
                made.y.append(NAN)
                made.low.append(s.value - half)
                made.high.append(s.value + half)
            made.low[-1] = min(made.low[-1], s.value - half)
            made.high[-1] = max(made.high[-1], s.value + half)
        made.low, made.high = [self.clipped(v) for v in made.low], [self.clipped(v) for v in made.high]
        return made

    def of_measured(self, measured: Measurement) -> Series:
        made = Series("measured", f"measured: {measured.name}")
        for one in measured.values:
            value, error = one.numbers(self.y_unit)
            made.x.append(_core.quantity_in(one.at, self.x_unit))
            made.y.append(value)
            made.low.append(max(value - error, self.least))
            made.high.append(min(value + error, self.most))
        return made

    # Numbers

    def multiple(self, series: list[Series]) -> tuple[float, str]:
        """Factor and name of the multiple of the unit for the largest number."""
        numbers = [abs(v) for s in series for v in (*s.y, *(s.high if s.kind == "band" else ()))
                   if math.isfinite(v)]
        return _core.multiple(max(numbers, default=0.0), self.y_unit)

    def csv(self) -> str:
        """The drawn numbers, in SI units."""
        text = csv_line(["series", "kind", _core.column_name(self.curve.against.replace(".", "_"), self.x_unit),
                         *(_core.column_name(name, self.y_unit)
                           for name in (self.curve.quantity, "low", "high"))])
        for s in self.series:
            name = _core.plain_text(s.name)
            text += "".join(csv_line([name, s.kind, *row]) for row in zip(s.x, s.y, s.low, s.high))
        return text

    # Drawing

    def entries(self, letters: int) -> int:
        """Lines of the legend."""
        names = [s.name if s.legend is None else s.legend for s in self.series] + [self.note]
        return sum(len(wrapped(name, letters)) for name in names if name)

    def draw(self, ax: Axes, letters: int) -> None:
        factor, unit = self.multiple(self.series)
        for s in sorted(self.series, key=lambda s: s.kind != "band"):
            self.draw_series(ax, s, factor, self.label(s, letters))
        ax.set_xlabel(mathtext(_core.axis_of_key(self.curve.against, self.x_unit)))
        label = _core.axis_of_quantity(self.curve.quantity, factor, unit)
        ax.set_ylabel(mathtext("\n".join(wrapped(label, LETTERS_OF_HEIGHT))))
        self.set_ticks(ax)
        self.set_limits(ax, factor)

    def label(self, s: Series, letters: int) -> str:
        name = s.name if s.legend is None else s.legend
        return mathtext("\n".join(wrapped(name, letters))) or "_"

    def draw_series(self, ax: Axes, s: Series, factor: float, label: str) -> None:
        colour = COLOURS[s.colour % len(COLOURS)]
        y, low, high = ([v / factor for v in values] for values in (s.y, s.low, s.high))
        if s.kind == "band":
            ax.fill_between(self.places(s.x), low, high, color=colour, alpha=0.25, linewidth=0, label=label)
        elif s.kind == "law":
            ax.plot(s.x, y, color=colour, linestyle=DASHES[s.colour % len(DASHES)], label=label)
        else:
            known = [math.isfinite(a) and math.isfinite(b) for a, b in zip(low, high)]
            bars = [[v - a if k else 0.0 for v, a, k in zip(y, low, known)],
                    [b - v if k else 0.0 for v, b, k in zip(y, high, known)]]
            measured = s.kind == "measured"
            joined = (not measured and not self.curve.law and not self.mixed
                      and all(map(math.isfinite, s.x)))
            ax.errorbar(self.places(s.x), y, yerr=bars, label=label, zorder=4 if measured else 3,
                        color="black" if measured else colour,
                        marker="s" if measured else MARKERS[s.colour % len(MARKERS)],
                        linestyle=DASHES[s.colour % len(DASHES)] if joined else "none", elinewidth=0.8)

    def places(self, x: list[float]) -> list[float]:
        """Numbers; words stand side by side."""
        return x if all(map(math.isfinite, x)) else [float(i) for i in range(len(x))]

    def set_ticks(self, ax: Axes) -> None:
        """Round numbers; words of a key."""
        from matplotlib.ticker import MaxNLocator

        ax.xaxis.set_major_locator(MaxNLocator(7, steps=[1, 2, 5, 10]))
        ax.yaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 5, 10]))
        lines = self.points.lines(self.curve.where, self.curve.against, self.curve.quantity)
        none: list[Spot] = []
        spots = max((line.spots for line in lines), key=len, default=none)
        if spots and any(math.isnan(s.x) for s in spots):
            ax.set_xticks(range(len(spots)), [s.text.strip('"') for s in spots])

    def set_limits(self, ax: Axes, factor: float) -> None:
        """From 0 if the quantity cannot be negative and its values span more than half of the way."""
        ends = [v / factor for s in self.series for v in (*s.y, *s.low, *s.high) if math.isfinite(v)]
        if self.least == 0 and ends and min(ends) < 0.6 * max(ends):
            ax.set_ylim(bottom=0)
