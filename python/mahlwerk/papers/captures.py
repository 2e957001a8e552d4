# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Captured grains by energy, and the bounds of their number.

The bounds follow from the Hertz contact and from the least and the greatest deformation of a bed
(cap.1, cap.5 to cap.8 in docs/theory/powder.md). No strength of the grains enters. They are computed here
apart from the capture model, from balls, jar and materials, so that they check it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Optional

from .. import _core
from ..result import Result
from .lines import Points, Spot
from .rules import Rule
from .verdict import Verdict

if TYPE_CHECKING:
    from ..case import Case

__all__ = ["CaptureBounds", "Bin", "CapturesInBounds", "bins_of", "counted_bins", "has_bounds"]

GREATEST = 0.362  # D/h for an endless specific energy (cap.8)
ROUNDING = 1e-12


def value(case: Case, key: str) -> Optional[str]:
    """The value of a key as text without quotes; None if the case has none."""
    found = next((one.value for one in case.origins if one.key == key), None)
    return None if found is None else found.strip('"')


def number(case: Case, key: str, unit: str) -> float:
    found = value(case, key)
    return math.nan if found is None else _core.quantity_in(found, unit)


def has_bounds(case: Case) -> bool:
    """Whether the bounds are known: Barrios' bed, and a cylinder."""
    return value(case, "capture.model") == "barrios" and value(case, "jar.kind") == "cylinder"


def compliance(case: Case, body: str) -> float:
    """[m2/N] of a body: E* is the inverse of the sum of both."""
    return (1 - number(case, f"{body}.poisson_ratio", "") ** 2) / number(case, f"{body}.youngs_modulus", "Pa")


class CaptureBounds:
    """Bounds of the number of captured grains of a case."""

    def __init__(self, case: Case):
        self.case = case
        self.size = number(case, "powder.size", "m")
        self._known: dict[tuple[str, str], tuple[float, float]] = {}

    def _radius(self, one: str, other: str) -> float:
        """[m] R* of a pair (cap.3): two balls; a ball in the cylinder, or on one of its ends."""
        ball = 0.5 * number(self.case, f"{one}.diameter", "m")
        if other.startswith("balls."):
            second = 0.5 * number(self.case, f"{other}.diameter", "m")
            return ball * second / (ball + second)
        if other in ("jar.bottom", "jar.top"):
            return ball
        side = 0.5 * number(self.case, "jar.diameter", "m") if other == "jar.side" else math.nan
        return math.sqrt(ball / (1 / ball - 1 / side))

    def _pair(self, one: str, other: str) -> tuple[float, float]:
        if (one, other) not in self._known:
            body = other if other.startswith("balls.") else "jar"
            self._known[one, other] = (self._radius(one, other),
                                       compliance(self.case, one) + compliance(self.case, body))
        return self._known[one, other]

    def at(self, one: str, other: str, energy: float) -> Optional[tuple[float, float]]:
        """Least and greatest number of grains; None for a pair without known bounds."""
        radius, soft = self._pair(one, other)
        if not math.isfinite(radius) or not math.isfinite(self.size):
            return None
        touch = (15 * energy * soft / 8) ** 0.2 * radius ** 0.4

        def grains(deformation: float) -> float:
            depth = self.size * deformation
            spot = touch + math.sqrt(depth * (2 * radius - depth))
            return 1.0 if spot < 0.5 * self.size else 0.25 + 0.75 * (2 * spot / self.size) ** 2
        return grains(0.0), grains(GREATEST)


@dataclass
class Bin:
    """A row of capture.csv."""

    one: str
    other: str
    energy: float
    rate: float
    grains: float
    energy_per_grain: float
    specific_energy: float


def result_at(spot: Spot) -> Optional[Result]:
    """The kept result of a point; None if it has none."""
    folder = spot.point.folder
    return None if folder is None or not (folder / "capture.csv").is_file() else Result(folder)


def bins_of(result: Result) -> list[Bin]:
    table = result.table("capture")
    names: list[str] = list(table.dtype.names or ())

    def column(name: str) -> str:
        return next(one for one in names if one == name or one.startswith(name + "_"))
    columns = [names[0], names[1], "energy_J", column("rate"), "grains", column("energy_per_grain"),
               column("specific_energy")]
    return [Bin(str(row[columns[0]]), str(row[columns[1]]), *(float(row[c]) for c in columns[2:]))
            for row in table]


def counted_bins(bounds: CaptureBounds, bins: list[Bin]) -> tuple[int, int]:
    """Number of bins with known bounds, and of those outside them."""
    counted = outside = 0
    for one in bins:
        ends = bounds.at(one.one, one.other, one.energy)
        if ends is None:
            continue
        counted += 1
        outside += not ends[0] * (1 - ROUNDING) <= one.grains <= ends[1] * (1 + ROUNDING)
    return counted, outside


@dataclass
class CapturesInBounds(Rule):
    """All bins of energy of all pairs and points lie between the bounds."""

    def judge(self, points: Points, campaign: Any = None) -> Verdict:
        counted = outside = places = 0
        for line in points.lines(self.where, "", ""):
            for spot in line.spots:
                places += 1
                result = result_at(spot)
                if result is not None:
                    some, wrong = counted_bins(CaptureBounds(result.case), bins_of(result))
                    counted, outside = counted + some, outside + wrong
        if counted == 0:
            return Verdict("no collision captured grains")
        found = (f"{outside} of {counted} bins of energy lie outside the bounds, over {places} points and "
                 "all pairs")
        return Verdict(found, "yes" if outside == 0 else "partly" if outside < counted else "no")
