# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Rules by which a statement about a campaign holds (docs/papers.md, "When a check holds")."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from .. import _core
from .lines import Line, Points, Spot, Where, key_words, same_value
from .verdict import HOLDS, Verdict, fitted_law, text, text_of

__all__ = ["Alike", "Bound", "Compare", "Linear", "Maximum", "PowerLaw", "Regime", "Rule", "Trend"]

FEW = 4  # combinations of the other keys that are told one by one


@dataclass
class Rule:
    """A statement about a quantity of a campaign. Points that differ in other keys than `against` are
    judged line by line."""

    campaign: str
    quantity: str = ""
    against: str = ""
    where: Where = field(default_factory=dict)

    def values(self) -> list[str]:
        """The values of `against` that the rule names."""
        return []

    def line(self, points: Points, line: Line) -> Verdict:
        raise NotImplementedError

    def judge(self, points: Points, campaign: Any = None) -> Verdict:
        """The verdict over all lines: that of each if they agree, else partly."""
        lines = points.lines(self.where, self.against, self.quantity)
        if not lines:
            return Verdict("no such point was run")
        each = [self.line(points, line) for line in lines]
        holds = {one.holds for one in each}
        verdict = holds.pop() if len(holds) == 1 else "partly"
        if len(each) > FEW:
            return Verdict(counted(each), verdict)
        return Verdict("; ".join((f"{line.others}: " if line.others else "") + one.finding
                                 for line, one in zip(lines, each)), verdict)

    def told(self, points: Points, spot: Spot) -> str:
        return text_of(spot, points.unit(self.quantity), self.quantity)

    @property
    def key(self) -> str:
        return key_words(self.against)


def counted(verdicts: list[Verdict]) -> str:
    counts = [(one, sum(v.holds == one for v in verdicts)) for one in HOLDS]
    said = ", ".join(f"{one} in {count}" for one, count in counts if count)
    return f"{said} of {len(verdicts)} combinations of the other keys"


def all_known(spots: list[Spot], least: int) -> bool:
    return len(spots) >= least and all(s.known for s in spots)


@dataclass
class Trend(Rule):
    """The quantity rises, or falls, at each step by more than both intervals."""

    rises: bool = True

    def line(self, points: Points, line: Line) -> Verdict:
        s = line.spots
        if not all_known(s, 2):
            return Verdict("no intervals to compare")

        def clear(a: Spot, b: Spot) -> bool:
            return b.above(a) if self.rises else a.above(b)

        steps = list(zip(s, s[1:]))
        unclear = [f"{a.text} to {b.text}" for a, b in steps if not clear(a, b)]
        good = len(steps) - len(unclear)
        found = (f"{self.told(points, s[0])} at {self.key} {s[0].text}, {self.told(points, s[-1])} at "
                 f"{s[-1].text}; {'rises' if self.rises else 'falls'} by more than both intervals at "
                 f"{good} of {len(steps)} steps")
        if unclear and good:
            found += ", not from " + ", ".join(unclear)
        if not unclear:
            return Verdict(found, "yes")
        return Verdict(found, "partly" if clear(s[0], s[-1]) else "no")


def ratio(a: Spot, b: Spot) -> tuple[float, float]:
    """The ratio b/a with its half-width; NaN where it is not known."""
    if not (a.known and b.known and a.value > 0):
        return math.nan, math.nan
    r = b.value / a.value
    return r, math.hypot(b.ci95, r * a.ci95) / a.value


@dataclass
class Compare(Rule):
    """The quantity is larger, or smaller, at the second value of the key than at the first."""

    first: str = ""
    second: str = ""
    larger: bool = True

    def values(self) -> list[str]:
        return [self.first, self.second]

    def line(self, points: Points, line: Line) -> Verdict:
        a = next((s for s in reversed(line.spots) if same_value(s.text, self.first)), None)
        b = next((s for s in reversed(line.spots) if same_value(s.text, self.second)), None)
        if a is None or b is None:
            return Verdict("not run at both values")
        times, half = ratio(a, b)
        found = f"{self.told(points, a)} at {self.key} {a.text}, {self.told(points, b)} at {b.text}"
        if math.isfinite(times):
            found += f": {text(times, half, '')} times"
        larger, smaller = b.above(a), a.above(b)
        if not larger and not smaller:
            return Verdict(found + "; the intervals overlap")
        return Verdict(found, "yes" if larger == self.larger else "no")


@dataclass
class Alike(Rule):
    """The largest value over the smallest is at most 1 + `within`."""

    within: float = 0.1

    def line(self, points: Points, line: Line) -> Verdict:
        s = line.spots
        if not all_known(s, 2):
            return Verdict("no intervals to compare")
        least = min(s, key=lambda spot: spot.value)
        most = max(reversed(s), key=lambda spot: spot.value)
        times, half = ratio(least, most)
        found = (f"{self.told(points, least)} at {self.key} {least.text} to {self.told(points, most)} at "
                 f"{most.text}: {text(times, half, '')} times")
        if times + half <= 1 + self.within:
            return Verdict(found, "yes")
        return Verdict(found, "no" if times - half > 1 + self.within else "undecided")


@dataclass
class Regime(Rule):
    """The charge is in this regime at all points."""

    word: str = ""

    def line(self, points: Points, line: Line) -> Verdict:
        found, last = "", None
        for s in line.spots:
            now = s.point.regime
            if now == last:
                found += f", {s.text}" if s.text else ""
            else:
                found += ("; " if found else "") + (now or "none") + (
                    f" at {self.key} {s.text}" if s.text else "")
            last = now
        good = sum(s.point.regime == self.word for s in line.spots)
        if good == len(line.spots):
            return Verdict(found, "yes")
        return Verdict(found, "partly" if good else "no")


@dataclass
class Bound(Rule):
    """The quantity is above, or below, a number at all points by more than its interval."""

    bound: str = ""
    above: bool = True

    def line(self, points: Points, line: Line) -> Verdict:
        limit = _core.bound_in(self.bound, points.unit(self.quantity))
        good = bad = 0
        for s in line.spots:
            above, below = s.low > limit, s.high < limit
            good += above if self.above else below
            bad += below if self.above else above
        found = ", ".join(self.told(points, s) + (f" at {s.text}" if s.text else "")
                          for s in line.spots)
        if good == len(line.spots):
            return Verdict(found, "yes")
        if good:
            return Verdict(found, "partly")
        return Verdict(found, "no" if bad == len(line.spots) else "undecided")


@dataclass
class PowerLaw(Rule):
    """The exponent of a fitted power law is `exponent`, within a tolerance; or it is "above" or
    "below" it."""

    exponent: float = 1.0
    within: float = 0.1
    side: str = ""

    def line(self, points: Points, line: Line) -> Verdict:
        law = fitted_law("power", line)
        if law is None:
            return Verdict("too few points for a fit")
        p, half = law.coefficients[1], law.ci95[1]
        found = f"exponent {text(p, half, '')}, {law.r_squared_text}"
        if not math.isfinite(half):
            return Verdict(found)
        if self.side:
            off = (p - self.exponent) * (1 if self.side == "above" else -1)
            return Verdict(found, "undecided" if abs(off) <= half else "yes" if off > 0 else "no")
        off = abs(p - self.exponent)
        if off + half <= self.within:
            return Verdict(found, "yes")
        return Verdict(found, "no" if off - half > self.within else "undecided")


@dataclass
class Linear(Rule):
    """The slope is significant, and the curvature with its interval at most `within`."""

    direction: str = ""  #: "rises", "falls", or either
    within: float = 0.1

    def line(self, points: Points, line: Line) -> Verdict:
        law = fitted_law("linear", line)
        if law is None:
            return Verdict("too few points for a fit")
        slope, half = law.coefficients[1], law.ci95[1]
        curved, ci95 = curvature(line)
        number, _ = _core.readable_parts(100 * curved, 100 * ci95, "", 0)
        found = (f"{text(slope, half, points.unit(self.quantity))} for each "
                 f"{points.unit_of_key(self.against) or '1'}, {law.r_squared_text}; the middle deviates by "
                 f"{number} % of the rise from a line through the ends"
                 + ("" if abs(curved) > ci95 else ", no significant curvature"))
        if not math.isfinite(ci95) or not abs(slope) > half:
            return Verdict(found)
        if self.direction and slope * (-1 if self.direction == "falls" else 1) < 0:
            return Verdict(found, "no")
        if abs(curved) + ci95 <= self.within:
            return Verdict(found, "yes")
        return Verdict(found, "no" if abs(curved) - ci95 > self.within else "undecided")


def bend(line: Line) -> float:
    """Deviation of a fitted parabola from its chord at the middle of the points, over its rise."""
    law = fitted_law("quadratic", line)
    if law is None:
        return math.nan
    least, most = min(s.x for s in line.spots), max(s.x for s in line.spots)
    half = 0.5 * (most - least)
    return -law.coefficients[2] * half * half / abs(law.at(most) - law.at(least))


def curvature(line: Line) -> tuple[float, float]:
    """The bend with the half-width that follows from the intervals of the points: each moves the fit
    by its own part, and the parts are independent."""
    value, squares = bend(line), 0.0
    for i, spot in enumerate(line.spots):
        moved = Spot(spot.point, spot.text, spot.x, spot.value + spot.ci95, spot.ci95)
        part = bend(Line(spots=[*line.spots[:i], moved, *line.spots[i + 1:]])) - value
        squares += part * part
    return value, math.sqrt(squares)


@dataclass
class Maximum(Rule):
    """Every point that may be the largest, by its interval, lies in a range of the key."""

    first: str = ""
    second: str = ""

    def values(self) -> list[str]:
        return [self.first, self.second]

    def line(self, points: Points, line: Line) -> Verdict:
        s = line.spots
        if not all_known(s, 3) or not all(math.isfinite(spot.x) for spot in s):
            return Verdict("no intervals to compare")
        best = max(s, key=lambda spot: spot.value)
        candidates = [spot for spot in s if not best.above(spot)]
        x_of: Callable[[str], float] = lambda value: next(
            (spot.x for spot in s if same_value(spot.text, value)), math.nan)
        low, high = sorted((x_of(self.first), x_of(self.second)))
        inside = sum(low <= spot.x <= high for spot in candidates)
        found = f"largest at {self.key} {best.text}: {self.told(points, best)}"
        if len(candidates) > 1:
            found += f"; within the intervals anywhere from {candidates[0].text} to {candidates[-1].text}"
        if inside == len(candidates):
            return Verdict(found, "yes")
        return Verdict(found, "undecided" if inside else "no")
