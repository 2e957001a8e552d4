# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Measured values: the band of a prediction over all assumed keys beside them."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

from .. import _core
from .lines import Line, Points, Spot, same_value
from .rules import Rule
from .verdict import Verdict, text

__all__ = ["STATUSES", "Agreement", "MeasuredValue", "Measurement"]

STATUSES = ("verified", "quoted", "unverified")
FEW = 6  # comparisons that are told one by one
WIDE = 2  # a band over more than this factor decides nothing


@dataclass
class MeasuredValue:
    at: str  #: value of the key, "70 rpm"; empty without a key
    text: str  #: "83 W"
    error: str  #: half-width of its interval: "4 W"

    def numbers(self, unit: str) -> tuple[float, float]:
        """Value and half-width in a unit. Raises ValueError."""
        return _core.quantity_in(self.text, unit), _core.quantity_in(self.error, unit)


@dataclass
class Measurement:
    """Measured values of a quantity, for instance the power of a mill against its speed."""

    name: str
    source: str  #: where the numbers stand: page, table or figure
    status: str  #: "verified": read in the source; "quoted": in a work that quotes it; "unverified"
    values: list[MeasuredValue]
    error_is: str = ""  #: what the errors are
    at: str = ""  #: line of the paper's file


@dataclass
class Comparison:
    """A measured value beside the band of the prediction."""

    at: str
    value: float
    error: float
    low: float
    high: float
    complete: bool  #: every value of the band has an interval

    @property
    def deviations(self) -> tuple[float, float]:
        return self.low / self.value - 1, self.high / self.value - 1

    @property
    def largest(self) -> float:
        return max(abs(self.low / self.value - 1), abs(self.high / self.value - 1))

    @property
    def agrees(self) -> bool:
        return self.low <= self.value + self.error and self.high >= self.value - self.error

    @property
    def wide(self) -> bool:
        return self.low <= 0 or self.high > WIDE * self.low


def percent(share: float) -> str:
    return f"{100 * share:+.0f} %"


def short_text(at: str) -> str:
    """The value of the key; of a list, as `velocities`, its first number."""
    return at.lstrip('[" ').partition('"')[0].partition(",")[0].partition("]")[0] \
        if at.startswith("[") else at


def relative(line: Line, base: str) -> Line:
    """The points of a line over that at the value `base` of the key, with the interval of the ratio.
    Empty if there is no such point. Its own ratio is exactly 1."""
    zero = next((s for s in line.spots if same_value(s.text, base)), None)
    if zero is None:
        return Line(line.others)
    spots = []
    for s in line.spots:
        ratio = s.value / zero.value
        half = math.hypot(s.ci95, ratio * zero.ci95) / abs(zero.value)
        spots.append(Spot(s.point, s.text, s.x, ratio, 0.0 if s is zero else half))
    return Line(line.others, spots, line.keys, line.values)


@dataclass
class Agreement(Rule):
    """The band of the prediction meets the interval of every measured value. The keys other than
    `against` are those that the source does not give."""

    measured: Measurement = field(default_factory=lambda: Measurement("", "", "", []))
    relative_to: str = ""

    def values(self) -> list[str]:
        return [self.relative_to] if self.relative_to else []

    def judge(self, points: Points, campaign: Any = None) -> Verdict:
        lines = points.lines(self.where, self.against, self.quantity)
        if not lines:
            return Verdict("no such point was run")
        unit = points.unit(self.quantity)
        if self.relative_to:
            unit, lines = "", [relative(line, self.relative_to) for line in lines]
        spots = [s for line in lines for s in line.spots]
        all_of = [compared(value.at, *value.numbers(unit), spots) for value in self.measured.values]
        for one in all_of:
            if not one.low <= one.high or not one.complete:
                return Verdict(f"no predicted interval at {one.at}")
        return self.verdict(all_of, summary(all_of, unit))

    def verdict(self, all_of: list[Comparison], found: str) -> Verdict:
        if self.measured.status == "unverified":
            return Verdict(found + "; the measured values are unverified and give no verdict")
        deviation = max(one.largest for one in all_of)
        agree = sum(one.agrees for one in all_of)
        if agree == 0:
            return Verdict(found, "no", deviation)
        if any(one.wide for one in all_of):
            return Verdict(found + "; the assumed values change the prediction by more than a factor of 2",
                           "undecided", deviation)
        return Verdict(found, "yes" if agree == len(all_of) else "partly", deviation)


def compared(at: str, value: float, error: float, spots: list[Spot]) -> Comparison:
    there = [s for s in spots if not at or same_value(s.text, at)]
    return Comparison(at, value, error, min((s.low for s in there), default=math.inf),
                      max((s.high for s in there), default=-math.inf),
                      all(math.isfinite(s.low) and math.isfinite(s.high) for s in there))


def prediction(one: Comparison, unit: str) -> str:
    """ "53 to 88 W (-24 % to +25 %)"; one number if both ends round to it."""
    low, shown = _core.readable_parts(one.low, math.nan, unit, one.value)
    high, _ = _core.readable_parts(one.high, math.nan, unit, one.value)
    close = "" if shown in ("", "°") else " "
    first, last = map(percent, one.deviations)
    if low == high:
        return f"{low}{close}{shown} ({first})"
    return f"{low} to {high}{close}{shown} ({first} to {last})"


def summary(all_of: list[Comparison], unit: str) -> str:
    """Each comparison if there are few; else how many agree, and the range of deviations."""
    if len(all_of) <= FEW:
        return "; ".join((f"{short_text(one.at)}: " if one.at else "")
                         + f"measured {text(one.value, one.error, unit)}, predicted {prediction(one, unit)}"
                         for one in all_of)
    agree = sum(one.agrees for one in all_of)
    low = min(all_of, key=lambda one: one.deviations[0])
    high = max(all_of, key=lambda one: one.deviations[1])
    return (f"{agree} of {len(all_of)} measured values in the band; deviations from "
            f"{percent(low.deviations[0])} at {short_text(low.at)} to {percent(high.deviations[1])} at "
            f"{short_text(high.at)}")
