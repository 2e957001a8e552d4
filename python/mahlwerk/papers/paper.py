# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""What a paper.py states: campaigns, figures, measured values, tables and checks."""

from __future__ import annotations

import runpy
import sys
import traceback
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Optional, Union

from .. import _core
from ..errors import InputError
from .captures import CapturesInBounds
from .computed import Computed, Maps
from .curves import Curve
from .lines import Where
from .measured import STATUSES, Agreement, MeasuredValue, Measurement
from .pictures import Pictures
from .rules import Alike, Bound, Compare, Linear, Maximum, PowerLaw, Regime, Rule, Trend
from .tables import CapturedTable, QuantityTable

__all__ = ["Check", "Figure", "Paper", "PaperCampaign", "Table", "read_paper"]

At = Optional[Mapping[str, Any]]  #: { "mill.ratio": [-3, -2], "contact.friction": 0.5 }


def text_of(value: Any) -> str:
    """A value of a key as [sweep] has it: 0.5, "10 mm"."""
    return value if isinstance(value, str) else repr(value)


def selector(at: At) -> Where:
    return {key: tuple(map(text_of, value if isinstance(value, (list, tuple)) else [value]))
            for key, value in (at or {}).items()}


def one_of(word: str, name: str, words: Sequence[str]) -> str:
    if word not in words:
        raise ValueError(f"{name} is one of {', '.join(words)}, not {word!r}")
    return word


def calling_line() -> str:
    """File and line of the paper from which this module was called."""
    frame = sys._getframe(1)
    while frame.f_back is not None and frame.f_code.co_filename == __file__:
        frame = frame.f_back
    return f"{frame.f_code.co_filename}:{frame.f_lineno}"


@dataclass
class Figure:
    """A panel of a figure. Those with the same number, as "6a", "6b" and "6", are panels of one."""

    number: str
    title: str
    drawing: Union[Curve, Pictures]
    about: str
    line: str


@dataclass
class Check:
    """A statement and the rule that judges it."""

    figure: str
    says: str
    rule: Rule
    why: str
    own: bool  #: a statement of ours, not of the paper
    line: str


@dataclass
class Table:
    name: str  #: of its files
    title: str
    content: Union[QuantityTable, CapturedTable]
    about: str
    line: str


class PaperCampaign:
    """A campaign of a paper: the case file NAME.toml with [sweep] beside paper.py. Its methods say
    what is drawn, tabled or checked of it. `against` is a key of [sweep]; the points that differ in
    other keys are lines of their own. `at` selects points by values of keys."""

    def __init__(self, name: str):
        self.name = name

    # Drawings

    def curve(self, quantity: str, *, against: str, law: str = "", at: At = None,
              band_over: Sequence[str] = (), nominal: Optional[Mapping[str, Any]] = None,
              measured: Optional[Measurement] = None) -> Curve:
        """A quantity over a key with 95 % intervals, and a fitted `law`: "linear", "power" or
        "quadratic". `band_over`: free numbers, over whose values one band is drawn; `nominal`: their
        values that are drawn as points."""
        if law:
            one_of(law, "law", ("linear", "power", "quadratic"))
        return Curve(self.name, quantity, against, law, selector(at), tuple(band_over),
                     {key: text_of(value) for key, value in (nominal or {}).items()}, measured)

    def trajectories(self, *, at: At = None, seen_from: str = "carrier") -> Pictures:
        """Paths of the balls at each point over three periods of the mill, seen from the "carrier" (the
        disc of a planetary mill) or the "jar"."""
        return Pictures(self.name, "trajectories", selector(at),
                        one_of(seen_from, "seen_from", ("carrier", "jar")))

    def snapshots(self, *, at: At = None, seen_from: str = "carrier") -> Pictures:
        """Balls and grains at the end of this time."""
        return Pictures(self.name, "snapshots", selector(at),
                        one_of(seen_from, "seen_from", ("carrier", "jar")))

    def maps(self, compute: Callable[[Any], tuple[Any, float]], *, at: At = None) -> Maps:
        """Maps of a field over the jar. `compute(result)` gives it for each point: an array by x and y, and
        the width of a cell in m."""
        return Maps(self.name, "maps", selector(at), "jar", compute, calling_line())

    # Tables

    def table(self, quantity: str, *, against: str, at: At = None, ratio: bool = False) -> QuantityTable:
        """A row for each combination of the other keys; the values of `against` are the columns.
        `ratio`: a column with the last value over the first."""
        return QuantityTable(self.name, quantity, against, selector(at), ratio)

    def captured(self, other: str, *, one: str = "balls.1", against: str, energies: Iterable[str],
                 at: At = None) -> CapturedTable:
        """Grains that a collision of the pair `one`, `other` captures, a row for the decade around each
        energy."""
        energies = list(energies)
        if not all(_core.si_value(energy) > 0 for energy in energies):
            raise ValueError("an energy is above 0")
        return CapturedTable(self.name, one, other, against, energies, selector(at))

    # Rules of checks

    def rises(self, quantity: str, *, against: str, at: At = None) -> Rule:
        """It rises from each value of the key to the next by more than both intervals."""
        return Trend(self.name, quantity, against, selector(at), True)

    def falls(self, quantity: str, *, against: str, at: At = None) -> Rule:
        return Trend(self.name, quantity, against, selector(at), False)

    def is_linear(self, quantity: str, *, against: str, direction: str = "", within: float = 0.1,
                  at: At = None) -> Rule:
        """A straight line that "rises" or "falls", whose curvature is at most `within` of its rise."""
        if direction:
            one_of(direction, "direction", ("rises", "falls"))
        return Linear(self.name, quantity, against, selector(at), direction, positive(within))

    def follows_power(self, quantity: str, *, against: str, exponent: float, within: float = 0.1,
                      at: At = None) -> Rule:
        """The exponent of a fitted power law is `exponent` within a tolerance."""
        return PowerLaw(self.name, quantity, against, selector(at), float(exponent), positive(within))

    def exponent_above(self, quantity: str, *, against: str, exponent: float, at: At = None) -> Rule:
        return PowerLaw(self.name, quantity, against, selector(at), float(exponent), side="above")

    def exponent_below(self, quantity: str, *, against: str, exponent: float, at: At = None) -> Rule:
        return PowerLaw(self.name, quantity, against, selector(at), float(exponent), side="below")

    def larger(self, quantity: str, *, against: str, first: Any, second: Any, at: At = None) -> Rule:
        """It is larger at the second value of the key than at the first."""
        return Compare(self.name, quantity, against, selector(at), text_of(first), text_of(second), True)

    def smaller(self, quantity: str, *, against: str, first: Any, second: Any, at: At = None) -> Rule:
        return Compare(self.name, quantity, against, selector(at), text_of(first), text_of(second), False)

    def is_alike(self, quantity: str, *, against: str, within: float = 0.1, at: At = None) -> Rule:
        """The largest value over the smallest is at most 1 + `within`."""
        return Alike(self.name, quantity, against, selector(at), positive(within))

    def regime(self, word: str, *, against: str = "", at: At = None) -> Rule:
        """The charge is in this regime at all points; `against` orders them in the text."""
        return Regime(self.name, "", against, selector(at), one_of(word, "regime", REGIMES))

    def above(self, bound: Any, quantity: str, *, against: str = "", at: At = None) -> Rule:
        """It is above the bound ("3 mJ") at all points by more than its interval."""
        return self._bound(bound, quantity, against, at, True)

    def below(self, bound: Any, quantity: str, *, against: str = "", at: At = None) -> Rule:
        return self._bound(bound, quantity, against, at, False)

    def _bound(self, bound: Any, quantity: str, against: str, at: At, above: bool) -> Rule:
        _core.si_value(text_of(bound))  # raises ValueError for what is no quantity
        return Bound(self.name, quantity, against, selector(at), text_of(bound), above)

    def largest_between(self, first: Any, second: Any, quantity: str, *, against: str,
                        at: At = None) -> Rule:
        """Its maximum lies between two values of the key."""
        return Maximum(self.name, quantity, against, selector(at), text_of(first), text_of(second))

    def agrees_with(self, measured: Measurement, quantity: str, *, against: str = "",
                    relative_to: Any = "", at: At = None) -> Rule:
        """The band over all keys but `against` meets the interval of each measured value.
        `relative_to`: the value of `against` whose quantity is the unit."""
        return Agreement(self.name, quantity, against, selector(at), measured, text_of(relative_to))

    def captures_within_bounds(self, *, at: At = None) -> Rule:
        """The numbers of captured grains lie between the bounds that need no strength of the grains."""
        return CapturesInBounds(self.name, "", "", selector(at))


REGIMES = ("cascading", "cataracting", "centrifuging", "rigid", "resting", "rolling",
           "rolling on the wall", "sliding", "slumping", "surging", "circling", "bouncing", "pinned",
           "stationary", "irregular")


def positive(number: float) -> float:
    if not number > 0:
        raise ValueError(f"a tolerance is above 0, not {number}")
    return float(number)


@dataclass
class Paper:
    """A paper, or a set of measured data: its figures, tables and checks, in the order of the file.

    >>> paper = Paper(title="The vertical vibration mill", source="Chen et al. 2016")
    >>> frequency = paper.campaign("frequency")  # frequency.toml beside this file
    >>> paper.check("6b", "the energy of a collision grows with the square of the frequency",
    ...             frequency.follows_power("energy_normal_mean", against="mill.frequency", exponent=2))
    """

    title: str
    source: str
    about: str = ""
    licence: str = ""  #: of the measured data
    quick: bool = True  #: part of `mahlwerk papers --quick`
    figures: list[Figure] = field(default_factory=list, init=False)
    checks: list[Check] = field(default_factory=list, init=False)
    tables: list[Table] = field(default_factory=list, init=False)
    measurements: list[Measurement] = field(default_factory=list, init=False)
    computed: list[Computed] = field(default_factory=list, init=False)
    folder: Path = field(default=Path(), init=False)

    def campaign(self, name: str) -> PaperCampaign:
        """The campaign of the case file NAME.toml beside paper.py."""
        if not name or set(name) & set("/\\"):
            raise ValueError(f"{name!r} is not the name of a campaign: name the case file beside this one, "
                             "without .toml")
        return PaperCampaign(name)

    def quantity(self, campaign: PaperCampaign, name: str,
                 compute: Callable[[Any], tuple[float, float]], *, unit: str = "") -> str:
        """A quantity that the program does not give. `compute(result)` gives it for each point, with the
        half-width of its interval, in `unit`; `result` is a mahlwerk.Result. Returns its name."""
        if not name.isidentifier():
            raise ValueError(f"{name!r} is not the name of a quantity: use letters, digits and _")
        self.computed.append(Computed(campaign.name, name, compute, unit, calling_line()))
        return name

    def figure(self, number: str, title: str, drawing: Union[Curve, Pictures], *,
               about: str = "") -> None:
        """A panel of figure `number` of the paper."""
        self.figures.append(Figure(number, title, drawing, about, calling_line()))

    def check(self, figure: str, says: str, rule: Rule, *, why: str = "", own: bool = False) -> None:
        """A statement of the paper about a figure, and the rule that judges it. `own`: a statement of
        ours."""
        self.checks.append(Check(figure, says, rule, why, own, calling_line()))

    def table(self, name: str, title: str, content: Union[QuantityTable, CapturedTable], *,
              about: str = "") -> None:
        """A table, on the page and as tables/NAME.md and NAME.csv."""
        if not name or set(name) & set("/\\."):
            raise ValueError(f"{name!r}: the name of a table is a file name without its ending")
        self.tables.append(Table(name, title, content, about, calling_line()))

    def measured(self, name: str, *, source: str, status: str, values: Iterable[Sequence[str]],
                 error_is: str = "") -> Measurement:
        """Measured values: rows of the value of a key, the value and the half-width of its interval, as
        in ("70 rpm", "83 W", "4 W"); or ("83 W", "4 W") without a key. `status`: "verified" (read in
        the source), "quoted" (in a work that quotes it) or "unverified"."""
        rows = [tuple(row) for row in values]
        if not rows or {len(row) for row in rows} not in ({2}, {3}):
            raise ValueError('a measured value is ("70 rpm", "83 W", "4 W") or ("83 W", "4 W")')
        made = [MeasuredValue(*("", *row)[-3:]) for row in rows]
        for value in made:
            _core.si_value(value.text), _core.si_value(value.error)
        self.measurements.append(Measurement(name, source, one_of(status, "status", STATUSES), made,
                                             error_is, calling_line()))
        return self.measurements[-1]

    @property
    def campaigns(self) -> list[str]:
        """Names of the campaigns that are drawn, checked or tabled, in the order of first mention."""
        return list(dict.fromkeys([*(f.drawing.campaign for f in self.figures),
                                   *(c.rule.campaign for c in self.checks),
                                   *(t.content.campaign for t in self.tables)]))

    def without(self, campaigns: Sequence[str]) -> None:
        """Leaves out the figures, checks and tables of some campaigns."""
        self.figures = [f for f in self.figures if f.drawing.campaign not in campaigns]
        self.checks = [c for c in self.checks if c.rule.campaign not in campaigns]
        self.tables = [t for t in self.tables if t.content.campaign not in campaigns]


def read_paper(file: Path) -> Paper:
    """Runs a paper.py and returns its `paper`. Raises InputError with the line of the fault."""
    def refused(where: str, what: str, remedy: str) -> InputError:
        return InputError([_core.Fault(where, what, remedy, "bad-paper")])
    try:
        made = runpy.run_path(str(file)).get("paper")
    except SyntaxError as error:
        raise refused(f"{file}:{error.lineno}", error.msg, "correct the line") from None
    except InputError:
        raise
    except Exception as error:
        lines = [one.lineno for one in traceback.extract_tb(error.__traceback__)
                 if one.filename == str(file)]
        raise refused(f"{file}:{lines[-1]}" if lines else str(file), f"{error}",
                      "docs/papers.md lists what a paper states") from None
    if not isinstance(made, Paper):
        raise refused(str(file), "the file makes no `paper`",
                      'write paper = Paper(title="...", source="...") at its top')
    made.folder = file.parent
    return made
