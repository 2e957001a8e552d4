# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Quantities and maps that functions of a paper.py compute from the results of a campaign."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .. import _core
from ..errors import InputError
from ..result import Result
from .lines import Points
from .pictures import Picture, Pictures, draw_scale
from .tables import csv_line

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["Computed", "Maps", "add_computed"]


def asked(line: str, compute: Callable[[Result], Any], result: Result) -> Any:
    """What a function of a paper says of a result. Raises InputError with the line that names it."""
    try:
        return compute(result)
    except Exception as error:
        name = getattr(compute, "__name__", compute)
        raise InputError([_core.Fault(line, f"{name} fails for {result.folder}: {error}",
                                      "correct the function; finished runs are kept", "bad-paper")]) from error


@dataclass
class Computed:
    """A quantity that a function gives for each point."""

    campaign: str
    name: str
    compute: Callable[[Result], tuple[float, float]]  #: value and half-width of its interval, in the unit
    unit: str
    line: str


def add_computed(computed: Iterable[Computed], points: Points) -> None:
    """Adds the quantities to all points; NaN where a point has no result."""
    for one in computed:
        points.units[one.name] = one.unit
        for point in points.points:
            value, half = math.nan, math.nan
            if point.folder is not None and (point.folder / "summary.json").is_file():
                value, half = map(float, asked(one.line, one.compute, Result(point.folder)))
            point.value[one.name], point.ci95[one.name] = value, half


@dataclass
class Maps(Pictures):
    """Maps of a field over the jar seen along its axis, one for each point."""

    compute: Callable[[Result], tuple[Any, float]]  #: field[x, y], and the width of a cell [m]
    line: str

    def pictures(self, points: Points) -> list[list[Picture]]:
        made: list[list[Picture]] = []
        for line in points.lines(self.where, "", ""):
            for folder in (spot.point.folder for spot in line.spots):
                if folder is not None and (folder / "summary.json").is_file():
                    field, cell = asked(self.line, self.compute, Result(folder))
                    made.append([Map(self, {"field": field, "cell_m": cell}, {}, line.others)])
        return made


class Map(Picture):
    """The map of a point: light where the field is large."""

    def csv(self) -> str:
        cell, field = self.film["cell_m"], self.film["field"]
        return "x_m,y_m,value\n" + "".join(
            csv_line([cell * (i + 0.5), cell * (j + 0.5), float(value)])
            for i, row in enumerate(field) for j, value in enumerate(row))

    def draw(self, ax: Axes) -> None:
        field = self.film["field"]
        x, y = (0.5 * self.film["cell_m"] * count for count in field.shape)
        ax.imshow(field.T, origin="lower", extent=(-x, x, -y, y), cmap="gray", interpolation="nearest")
        ax.set_aspect("equal")
        ax.set_axis_off()
        draw_scale(ax, max(x, y))
