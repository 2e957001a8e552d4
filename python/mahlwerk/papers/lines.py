# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The points of a campaign, grouped into lines along a key."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional

from .. import _core

if TYPE_CHECKING:
    from ..campaign import Campaign

__all__ = ["Line", "Point", "Points", "Spot", "Where", "same_value"]

NAN = math.nan
Where = Mapping[str, tuple[str, ...]]  #: swept keys, each with its allowed values


def same_value(one: str, other: str) -> bool:
    """Whether two texts are the same value of a key: "10 mm" and "0.01 m"."""
    return one == other or _core.same_value(one, other)


def number_in(text: str, unit: str) -> float:
    """The value of a text in a unit; NaN if it is not a quantity of that dimension."""
    try:
        return _core.quantity_in(text, unit)
    except ValueError:
        return NAN


@dataclass
class Point:
    """A point of a campaign: its values of the swept keys as texts, and its results."""

    values: list[str]
    value: dict[str, float]  #: by quantity, in SI units
    ci95: dict[str, float]
    regime: str = ""
    folder: Optional[Path] = None


@dataclass
class Spot:
    """A quantity at one value of a key."""

    point: Point
    text: str = ""  #: the key's value: "10 mm"
    x: float = NAN  #: its number, in the unit of the first point
    value: float = NAN
    ci95: float = NAN

    @property
    def low(self) -> float:
        return self.value - self.ci95

    @property
    def high(self) -> float:
        return self.value + self.ci95

    @property
    def known(self) -> bool:
        """Whether there are a value and an interval."""
        return math.isfinite(self.value) and math.isfinite(self.ci95)

    def above(self, other: Spot) -> bool:
        """Whether the interval is above the other's, without overlap."""
        return self.low > other.high


@dataclass
class Line:
    """Points that differ in one key only, or in keys that vary together with it."""

    others: str = ""  #: values of the other keys, "friction 0.5, ratio -2"; may be empty
    spots: list[Spot] = field(default_factory=list)
    keys: list[str] = field(default_factory=list)  #: of `others`
    values: list[str] = field(default_factory=list)


def key_words(key: str) -> str:
    """Name of a key in a sentence: "rolling friction" for contact.rolling_friction."""
    return key.rpartition(".")[2].replace("_", " ")


@dataclass
class Points:
    """The points of a campaign with the names of its keys and the units of its quantities."""

    keys: list[str]
    units: dict[str, str]  #: by quantity
    points: list[Point]
    following: frozenset[str] = frozenset()  #: keys that vary together with another

    def unit_of_key(self, key: str) -> str:
        """The unit that all values of a key share; empty for words and other keys."""
        if key not in self.keys:
            return ""
        at = self.keys.index(key)
        read = [_core.number_text(p.values[at]) for p in self.points]
        units = {rest for _, rest in read}
        numbers = all(math.isfinite(number) for number, _ in read)
        return units.pop() if numbers and len(units) == 1 else ""

    def unit(self, quantity: str) -> str:
        return self.units.get(quantity, "")

    def selected(self, where: Where) -> list[Point]:
        def fits(point: Point) -> bool:
            return all(key in self.keys and any(same_value(v, point.values[self.keys.index(key)])
                                                for v in values) for key, values in where.items())
        return [p for p in self.points if fits(p)]

    def words_of(self, key: int) -> str:
        """Name of a key, with its section if another key has the same last word."""
        last = key_words(self.keys[key])
        if sum(key_words(one) == last for one in self.keys) == 1:
            return last
        return self.keys[key].replace(".", " ").replace("_", " ")

    def mixed(self, where: Where, against: str) -> bool:
        """Whether other keys vary with `against` without corresponding to it, so that neighbouring
        points have nothing in common."""
        chosen = self.selected(where)
        if against not in self.keys:
            return False
        axis = self.keys.index(against)
        return any(k != axis and varies_with(chosen, self.keys, axis, k, self.following)
                   and len({p.values[k] for p in chosen}) > 1 and not side_by_side(chosen, axis, k)
                   for k in range(len(self.keys)))

    def lines(self, where: Where, against: str, quantity: str) -> list[Line]:
        """The points that `where` selects, grouped into lines along `against` (empty: each point is
        a line). By ascending number of the key; words in the order of the campaign."""
        chosen = self.selected(where)
        axis = self.keys.index(against) if against in self.keys else None
        others = distinguishing_keys(chosen, self.keys, axis, self.following)
        unit = "" if axis is None or not chosen else _core.number_text(chosen[0].values[axis])[1]
        lines: dict[str, Line] = {}
        for p in chosen:
            label = ", ".join(f"{self.words_of(k)} {p.values[k]}" for k in others)
            spot = Spot(p, value=p.value.get(quantity, NAN), ci95=p.ci95.get(quantity, NAN))
            if axis is not None:
                spot.text, spot.x = p.values[axis], number_in(p.values[axis], unit)
            line = lines.setdefault(label, Line(label, [], [self.keys[k] for k in others],
                                                [p.values[k] for k in others]))
            line.spots.append(spot)
        for line in lines.values():
            if not any(math.isnan(s.x) for s in line.spots):
                line.spots.sort(key=lambda s: s.x)
        return list(lines.values())


def side_by_side(points: Iterable[Point], a: int, b: int) -> bool:
    """Whether the values of two keys correspond one to one, and there are several."""
    of_a: dict[str, set[str]] = {}
    of_b: dict[str, set[str]] = {}
    for p in points:
        of_a.setdefault(p.values[a], set()).add(p.values[b])
        of_b.setdefault(p.values[b], set()).add(p.values[a])
    return len(of_a) > 1 and all(len(s) == 1 for s in (*of_a.values(), *of_b.values()))


def given_by(points: Iterable[Point], axis: int, k: int) -> bool:
    """Whether each value of the axis has one value of the other key."""
    of_axis: dict[str, set[str]] = {}
    for p in points:
        of_axis.setdefault(p.values[axis], set()).add(p.values[k])
    return all(len(s) == 1 for s in of_axis.values())


def varies_with(points: list[Point], names: list[str], axis: int, k: int,
                following: frozenset[str]) -> bool:
    """Whether a key varies with the axis."""
    together = names[k] in following or names[axis] in following
    return (k == axis or side_by_side(points, axis, k)
            or (together and given_by(points, axis, k)))


def distinguishing_keys(points: list[Point], names: list[str], axis: Optional[int],
                        following: frozenset[str]) -> list[int]:
    """Keys that distinguish lines: they vary, and neither vary with the axis nor correspond to an
    earlier key."""
    keys: list[int] = []
    for k in range(len(names)):
        varies = len({p.values[k] for p in points}) > 1
        followed = any(side_by_side(points, before, k) for before in keys)
        with_axis = axis is not None and varies_with(points, names, axis, k, following)
        if varies and not followed and not with_axis:
            keys.append(k)
    return keys


def points_of(campaign: Campaign) -> Points:
    """The points of a campaign's folder."""
    keys, quantities = campaign.keys, campaign.quantities
    names, rows = campaign._ask("SELECT * FROM results")
    place = {name: i for i, name in enumerate(names)}

    def text(row: Any, column: str, unit: str) -> str:
        cell = row[place[column]]
        if cell is None or isinstance(cell, str):
            return cell or ""
        number = _core.shortest(cell)
        return f"{number} {unit}" if unit else number

    def numbers(row: Any, part: int) -> dict[str, float]:
        cells = {name: row[place[told[part]]] for name, told in quantities.items()}
        return {name: NAN if cell is None else float(cell) for name, cell in cells.items()}

    points = [Point([text(row, k.column, k.unit if k.numeric else "") for k in keys],
                    numbers(row, 2), numbers(row, 3), row[place["regime"]] or "",
                    campaign.folder / row[place["folder"]] if row[place["folder"]] else None)
              for row in rows]
    return Points([k.key for k in keys], {name: told[0] for name, told in quantities.items()}, points,
                  frozenset(k.key for k in keys if k.follows))
