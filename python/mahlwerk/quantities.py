# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Parts of a result: its numbers, its notices, and what its assumed values do."""

from __future__ import annotations

import math
from collections.abc import Sequence
from types import ModuleType
from typing import TYPE_CHECKING, Any, NamedTuple, NoReturn, Optional

from . import _core
from .public import Public

if TYPE_CHECKING:
    import numpy as np
    from uncertainties import UFloat

__all__ = ["Influence", "Notice", "Quantity"]

NORMAL95 = 1.959963984540054  # two-sided 95 % quantile of the normal distribution


class Notice(NamedTuple):
    """A note or warning that accompanies a result."""

    code: str  #: heading on the documentation's page of warnings
    severity: str  #: "note", "warning" or "invalid"
    text: str

    @property
    def warns(self) -> bool:
        return self.severity != "note"


def notices_of(told: dict[str, Any]) -> list[Notice]:
    """The notices that a study or a summary tells."""
    return [Notice(one["code"], one["severity"], one["text"]) for one in told["notices"]]


class Influence(NamedTuple):
    """What an assumed value of a case does to the key quantities."""

    key: str  #: "contact.restitution"
    value: str  #: that was assumed
    range: tuple[str, str]  #: ends of the range in which it may lie
    source: str
    at_ends: dict[str, tuple[float, float]]  #: values of the key quantities there, in SI units


class Quantity(Public):
    """A number of a result. `float(quantity)` is its value; `quantity.ufloat()` computes with its error.

    >>> power = result["dissipated_power"]
    >>> power.value, power.interval, power.standard_error
    """

    __slots__ = ("name", "value", "ci95", "unit", "about", "ci95_time", "label", "range", "replicates")

    def __init__(self, name: str, value: Optional[float], ci95: Optional[float], unit: str,
                 about: str, ci95_time: Optional[float] = None, label: str = "",
                 range: tuple[float, float] = (-math.inf, math.inf), replicates: int = 0):
        self.name = name
        self.value = nan_if_none(value)  #: mean over replicates; NaN if the run does not give one
        self.ci95 = nan_if_none(ci95)  #: half-width of the 95 % confidence interval over replicates
        self.unit = unit  #: "1" for a number without unit
        self.about = about
        self.ci95_time = nan_if_none(ci95_time)  #: the same from the scatter over time
        self.label = label or name.replace("_", " ")  #: its name in tables and on axes
        self.range = range  #: the least and the largest value that it can have
        self.replicates = replicates  #: number of replicates behind `ci95`; 0 if not known

    @classmethod
    def of(cls, name: str, told: dict[str, Any], replicates: int = 0) -> Quantity:
        """The quantity as summary.json tells it."""
        return cls(name, told["value"], told.get("ci95"), told["unit"], told["about"],
                   told.get("ci95_time"), told.get("label", ""),
                   (told.get("least", -math.inf), told.get("most", math.inf)), replicates)

    @property
    def half_width(self) -> float:
        """Half-width to show: over replicates, else over time, else NaN."""
        return self.ci95 if math.isfinite(self.ci95) else self.ci95_time

    @property
    def interval(self) -> tuple[float, float]:
        """Ends of the 95 % interval, cut at the range of the quantity; NaN without half-width."""
        if math.isnan(self.half_width):
            return math.nan, math.nan
        return (max(self.value - self.half_width, self.range[0]), min(self.value + self.half_width, self.range[1]))

    @property
    def standard_error(self) -> float:
        """Standard error of the value: the half-width over the 95 % quantile of Student's t for the replicates
        (sta.2), of the normal distribution where the half-width is from the scatter over time. NaN without
        half-width."""
        over_replicates = math.isfinite(self.ci95) and self.replicates > 1
        return self.half_width / (_core.student95(self.replicates - 1) if over_replicates else NORMAL95)

    def ufloat(self) -> UFloat:
        """The quantity as a number of the package uncertainties, for arithmetic with its standard error:
        `2 * result["dissipated_power"].ufloat()`. Quantities of one result depend on each other:
        `Result.ufloats` keeps that. Raises ValueError without half-width; ImportError without the package."""
        if math.isnan(self.standard_error):
            raise ValueError(f"{self.name} has no half-width: it needs a value and at least two replicates")
        return uncertainties().ufloat(self.value, self.standard_error, self.name)

    def __float__(self) -> float:
        return self.value

    def __format__(self, form: str) -> str:
        """As text, or its value in a format of numbers: f"{power}", f"{power:.3f}"."""
        return format(self.value, form) if form else str(self)

    def _no_operator(self, *_: object) -> NoReturn:
        raise TypeError(f"{self.name} has an error: compute with its value, float(q), or with both, q.ufloat(); "
                        "with several quantities of a result use result.ufloats(...)")

    __add__ = __radd__ = __sub__ = __rsub__ = __mul__ = __rmul__ = __truediv__ = __rtruediv__ = _no_operator
    __pow__ = __rpow__ = __neg__ = __abs__ = __lt__ = __le__ = __gt__ = __ge__ = __round__ = _no_operator

    def text(self) -> str:
        """Value, half-width and unit as the program prints them: "136 ± 15 /s"."""
        return _core.readable(self.value, self.half_width, self.unit or "1", *self.range)

    def of_value(self, value: float) -> Quantity:
        """The same quantity with another value, which is known exactly."""
        return Quantity(self.name, value, 0.0, self.unit, self.about, None, self.label, self.range,
                        self.replicates)

    def __str__(self) -> str:
        return self.text()

    def __repr__(self) -> str:
        return f"<{self.name} {self.text()}>"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Quantity) and all(
            same(getattr(self, part), getattr(other, part)) for part in self.__slots__)

    __hash__ = None  # type: ignore[assignment]


def uncertainties() -> ModuleType:
    """The package, which is optional."""
    try:
        import uncertainties as package
    except ImportError:
        raise ImportError("numbers with errors need the package uncertainties: install python3-uncertainties, or "
                          "use `standard_error`") from None
    return package


def correlated(quantities: Sequence[Quantity], values: Sequence[np.ndarray]) -> tuple[UFloat, ...]:
    """Numbers with errors that depend on each other as the `values` of the quantities in the replicates do.
    Raises ValueError if one of these is missing; ImportError without the package uncertainties."""
    import numpy as np

    names = [one.name for one in quantities]
    rows = np.array(values, float)
    if not np.isfinite(rows).all():
        raise ValueError(f"{', '.join(names)}: not each has a value in every replicate")
    errors = np.array([one.standard_error for one in quantities])
    with np.errstate(invalid="ignore"):  # a quantity that is the same in each replicate
        correlation = np.nan_to_num(np.atleast_2d(np.corrcoef(rows)))
    return uncertainties().correlated_values([one.value for one in quantities],
                                             correlation * np.outer(errors, errors), tags=names)


def nan_if_none(value: Optional[float]) -> float:
    return math.nan if value is None else float(value)


def same(one: Any, other: Any) -> bool:
    return one == other or (isinstance(one, float) and isinstance(other, float)
                            and math.isnan(one) and math.isnan(other))
