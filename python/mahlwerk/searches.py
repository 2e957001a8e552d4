# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Results of fit, optimise, match, compare and of wear over time."""

from __future__ import annotations

import json
import os
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

from . import _core
from .errors import InputError
from .pages import Page
from .public import Public
from .quantities import Notice, nan_if_none, notices_of
from .result import Result
from .tables import frame_of, read_csv

if TYPE_CHECKING:
    import numpy as np
    import pandas as pd

    from .case import Case

__all__ = ["Comparison", "Fit", "Match", "Optimum", "WearEvolution"]


class Found(Public):
    """A folder with numbers as JSON, a table and a page."""

    numbers, rows, html = "", "", ""

    @property
    def known_by(self) -> str:
        """The file that such a folder always has."""
        return self.numbers

    def __init__(self, folder: Union[str, os.PathLike[str]]):
        self.folder = Path(folder)
        if not (self.folder / self.known_by).is_file():
            raise InputError([_core.Fault(
                os.fspath(folder), f"there is no {self.known_by} in the folder",
                "give the folder that the command wrote", "no-result")])

    @cached_property
    def data(self) -> dict[str, Any]:
        """All numbers, as the command prints them with --json."""
        return json.loads((self.folder / self.numbers).read_text(encoding="utf-8"))

    @cached_property
    def table(self) -> np.ndarray:
        """The table of the folder as a structured array."""
        return read_csv(self.folder / self.rows)

    def frame(self) -> pd.DataFrame:
        """`table` as a pandas frame."""
        return frame_of(self.table)

    @property
    def report(self) -> str:
        """The page as text."""
        return (self.folder / self.html).read_text(encoding="utf-8")

    def page(self) -> Page:
        """The page of the command, for a notebook or a file."""
        return Page(self.report)

    def _case(self, name: str) -> Case:
        from .case import Case

        return Case(self.folder / name)

    def _repr_html_(self) -> str:
        return self.page()._repr_html_()


class Remarks(Found):
    @property
    def remarks(self) -> list[str]:
        """How certain the answer is."""
        return self.data["remarks"]

    @property
    def notices(self) -> list[Notice]:
        return notices_of(self.data)


class Fit(Found):
    """Parameters of a case fitted to measurements."""

    numbers, rows, html = "fit.json", "fit.csv", "fit.html"

    @property
    def parameters(self) -> dict[str, dict[str, Any]]:
        """The fitted parameters: "value", "low" and "high" of the 95 % interval, "unit", "determined", ..."""
        return self.data["numbers"]

    @property
    def case(self) -> Case:
        """The case with the fitted values; after a calibration with their [uncertainty]."""
        calibrated = (self.folder / "calibrated.toml").is_file()
        return self._case("calibrated.toml" if calibrated else "fitted.toml")

    @cached_property
    def posterior(self) -> np.ndarray:
        """After a calibration: draws of the keys from their posterior, as a structured array."""
        return read_csv(self.folder / "posterior.csv")

    def __repr__(self) -> str:
        found = ", ".join(f"{key} = {one['value']:.4g} {one['unit']}" for key, one in self.parameters.items())
        return f"<Fit {found} in {os.fspath(self.folder)}>"


class Optimum(Remarks):
    """The best settings that a search found."""

    numbers, rows, html = "optimise.json", "settings.csv", "optimise.html"

    @property
    def best(self) -> dict[str, str]:
        """The best setting tried: value of each key. Empty if every setting failed or broke a limit."""
        if not self.data["best"]:
            return {}
        return {key: one["best"] for key, one in self.data["keys"].items()}

    @property
    def value(self) -> float:
        """The quantity at the best setting: mean over its replicates. NaN if there is none."""
        return float(self.data["best"]["mean"]["value"]) if self.data["best"] else float("nan")

    @property
    def case(self) -> Case:
        """The case at the best setting."""
        return self._case("best.toml")

    def __repr__(self) -> str:
        return f"<Optimum {self.data['quantity']} = {self.value:.4g} {self.data['unit']} at {self.best}>"


class Match(Remarks):
    """Settings of mill B that do what mill A does."""

    numbers, rows, html = "match.json", "settings.csv", "match.html"

    @property
    def best(self) -> dict[str, str]:
        """The best setting of mill B: value of each key."""
        search = self.data["search"]
        return {key: one["best"] for key, one in search["keys"].items()} if search["best"] else {}

    @property
    def a(self) -> Result:
        """The result of mill A, the target."""
        return Result(self.folder / "a")

    @property
    def b(self) -> Result:
        """The result of mill B at its best setting."""
        return Result(self.folder / "b")

    @property
    def case(self) -> Case:
        """Mill B at its best setting."""
        return self._case("best.toml")

    def __repr__(self) -> str:
        return f"<Match {self.best}, overlap of the spectra {self.data['overlap']:.2f}>"


class Comparison(Found):
    """One case run by both engines."""

    numbers, rows, html = "compare.json", "compare.csv", "compare.html"
    known_by = "compare.csv"  # older versions wrote no compare.json

    @property
    def event(self) -> Result:
        return Result(self.folder / "event")

    @property
    def soft(self) -> Result:
        return Result(self.folder / "soft")

    def __repr__(self) -> str:
        return f"<Comparison in {os.fspath(self.folder)}>"


class WearEvolution(Found):
    """Shapes and ball sizes of a mill over the time of operation. `table` has a row for each stage."""

    numbers, rows, html = "wear_evolution.json", "wear_evolution.csv", "wear_evolution.html"

    @property
    def complete(self) -> bool:
        """Whether the wear was followed to the end of its time."""
        return self.data["complete"]

    @property
    def lives(self) -> dict[str, tuple[float, bool]]:
        """Of each profile: its life in s, NaN if it does not wear, and whether that is extrapolated."""
        return {one["profile"]: (nan_if_none(one["time_s"]), one["extrapolated"]) for one in self.data["lives"]}

    @property
    def notices(self) -> list[Notice]:
        return notices_of(self.data)

    @cached_property
    def profiles(self) -> np.ndarray:
        """The sections of bars and lifters: a row for each corner and stage."""
        return read_csv(self.folder / "wear_profile.csv")

    @cached_property
    def ball_sizes(self) -> np.ndarray:
        """A row for each size and stage."""
        return read_csv(self.folder / "wear_ball_sizes.csv")

    @cached_property
    def spectra(self) -> np.ndarray:
        """Impact energies: a row for each bin and stage."""
        return read_csv(self.folder / "wear_spectra.csv")

    def profile(self, stage: int, part: str = "lifters") -> np.ndarray:
        """The corners of a profile in a stage: x and y in m, from its own axis. `stage` may count from the
        end: -1. Raises KeyError where there are none."""
        number = range(len(self))[stage]
        rows = self.profiles
        found = rows[(rows["stage"] == number) & (rows["part"] == part)]
        if not len(found):
            raise KeyError(part)
        import numpy

        return numpy.column_stack([found["x_m"], found["y_m"]])

    def __len__(self) -> int:
        """The number of stages."""
        return self.data["stages"]

    def __getitem__(self, stage: int) -> Result:
        """The result of the run of a stage, which may count from the end."""
        return Result(self.folder / f"stage-{range(len(self))[stage]:03}")

    def __repr__(self) -> str:
        return f"<WearEvolution of {len(self)} stages in {os.fspath(self.folder)}>"
