# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Verdicts, and numbers as text."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from .. import _core
from .lines import Line, Spot

__all__ = ["HOLDS", "Law", "Verdict", "fitted_law", "text", "text_of"]

HOLDS = ("yes", "partly", "no", "undecided")  # undecided: the runs do not decide it


@dataclass
class Verdict:
    """What a rule found in the results of a campaign."""

    finding: str  #: sentence with numbers
    holds: str = "undecided"  #: one of HOLDS
    #: Largest relative deviation of the predicted band from measured values; NaN without these.
    deviation: float = math.nan


def text(value: float, ci95: float, unit: str) -> str:
    """A number with its interval and unit: "2.42 ± 0.03 mJ"."""
    return _core.readable(value, ci95, unit, -math.inf, math.inf)


def text_of(spot: Spot, unit: str, quantity: str) -> str:
    """The same; the interval does not leave the range of the quantity."""
    _, least, most = _core.traits(quantity)
    return _core.readable(spot.value, spot.ci95, unit, least, most)


@dataclass
class Law:
    """A law fitted to points, weighted by their intervals (docs/theory/campaigns.md)."""

    form: str  #: "line", "power" or "parabola"
    coefficients: list[float]
    ci95: list[float]
    reference: float  #: of a power law
    r_squared: float

    def at(self, x: float) -> float:
        c = self.coefficients
        if self.form == "power":
            return c[0] * float(x / self.reference) ** c[1]
        return c[0] + x * (c[1] + x * c[2]) if self.form == "parabola" else c[0] + x * c[1]

    @property
    def r_squared_text(self) -> str:
        return f"R² = {self.r_squared:.4f}"


FORMS = {"linear": "line", "power": "power", "quadratic": "parabola"}


def fitted_law(law: str, line: Line) -> Any:
    """The law ("linear", "power", "quadratic") of a line; None if there are too few points."""
    laws = _core.fitted_laws([s.x for s in line.spots], [s.value for s in line.spots],
                             [s.ci95 for s in line.spots])
    return next((Law(*one) for one in laws if one[0] == FORMS[law]), None)
