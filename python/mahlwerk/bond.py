# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Bond's grindability test of a simulated mill and a rock."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple, Optional

from .pages import table_html
from .public import Public
from .quantities import Notice, Quantity, notices_of
from .tables import frame_of

if TYPE_CHECKING:
    import numpy as np
    import pandas as pd

__all__ = ["BondTest", "LargestBall"]


class LargestBall(NamedTuple):
    """The largest ball of a full-scale mill, by two rules."""

    mill_diameter: float  #: inner diameter of the mill in m
    mill_speed: float  #: share of its critical speed
    bond: float  #: diameter in m by Bond's rule (bnd.4)
    azzaroni: float  #: diameter in m by Azzaroni's rule (bnd.5)


class BondTest(Public):
    """Work index, grams per turn and cycles of Bond's test. `Case.bond_test` and `mahlwerk.bond_test` return one."""

    def __init__(self, data: dict[str, Any], replicates: int = 0):
        self.data = data  #: as `mahlwerk bond-test --json` prints it
        self._replicates = replicates

    @property
    def work_index(self) -> Quantity:
        """Bond's work index in kWh/t (bnd.3), with its half-width over replicates."""
        told = self.data["work_index"]
        return Quantity("work_index", told["value"], told["ci95"], told["unit"], "work index of Bond's test (bnd.3)",
                        range=(0, float("inf")), replicates=self._replicates)

    @property
    def grams_per_turn(self) -> float:
        """Undersize per turn of the mill in g: mean of the last three cycles."""
        return float(self.data["g_per_turn"])

    @property
    def f80(self) -> float:
        """Size in m below which 80 % of the feed are."""
        return float(self.data["f80_m"])

    @property
    def p80(self) -> float:
        """Size in m below which 80 % of the product are."""
        return float(self.data["p80_m"])

    @property
    def steady(self) -> bool:
        """Whether the grams per turn of the last cycles agree, as the test demands."""
        return bool(self.data["steady"])

    @cached_property
    def table(self) -> np.ndarray:
        """The cycles as a structured array: turns, fed_g, product_g, g_per_turn, circulating_load, p80_m, ..."""
        import numpy

        cycles = self.data["cycles"]
        kind = [(name, float) for name in (cycles[0] if cycles else ())]
        return numpy.array([tuple(one[name] for name, _ in kind) for one in cycles], dtype=kind)

    def frame(self) -> pd.DataFrame:
        """`table` as a pandas frame."""
        return frame_of(self.table)

    @property
    def largest_ball(self) -> Optional[LargestBall]:
        """The largest ball of the full-scale mill; None if the call gave no `mill_diameter`."""
        told = self.data.get("largest_ball")
        return LargestBall(told["mill_diameter_m"], told["mill_speed"], told["bond_m"],
                           told["azzaroni_m"]) if told else None

    @property
    def notices(self) -> list[Notice]:
        return notices_of(self.data)

    def __repr__(self) -> str:
        said = "" if self.steady else ", not steady"
        return f"<BondTest: work index {self.work_index}, {len(self.data['cycles'])} cycles{said}>"

    def _repr_html_(self) -> str:
        names = list(self.data["cycles"][0]) if self.data["cycles"] else []
        return f"<b>work index {self.work_index}</b>" + table_html(
            ["cycle", *names], [[str(i + 1), *(f"{one[name]:.4g}" for name in names)]
                                for i, one in enumerate(self.data["cycles"])])
