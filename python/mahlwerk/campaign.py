# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Campaigns: many runs over the values of some keys."""

from __future__ import annotations

import html
import os
from collections.abc import Iterable, Iterator
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Union

from . import _core
from .errors import InputError
from .pages import Page, table_html
from .public import Public
from .result import Result
from .tables import array_of, frame_of, on_grid

if TYPE_CHECKING:
    import numpy as np
    import pandas as pd
    import xarray as xr

    from .plots import CampaignPlots
    from .surrogate import Surrogate

__all__ = ["Campaign", "SweptKey"]


class SweptKey(NamedTuple):
    """A key that varies."""

    key: str
    unit: str  #: of the numbers in its column; "" for words
    column: str  #: name of its column
    numeric: bool
    follows: bool  #: varies together with another key


class Campaign(Public):
    """The runs of a case with [sweep]. `Campaign(folder)` opens a campaign's folder or its
    campaign.sqlite, also while it runs; `Case.sweep` returns one.

    >>> campaign = case.sweep({"mill.frequency": ["10 Hz", "11 Hz", "12 Hz", "13 Hz"]}, out="results/speeds")
    >>> campaign.frame()[["mill.frequency_Hz", "dissipated_power_W"]]
    >>> campaign[0]  # the result of the first point
    """

    def __init__(self, folder: Union[str, os.PathLike[str]]):
        place = Path(folder).absolute()
        self.folder = place.parent if place.suffix == ".sqlite" else place
        self._store = self.folder / "campaign.sqlite" if place.suffix != ".sqlite" else place
        if not self._store.is_file():
            raise InputError([_core.Fault(os.fspath(folder), "there is no campaign.sqlite: the folder is not a campaign",
                                          "give the folder that `mahlwerk sweep` wrote",
                                          "no-campaign")])

    def _ask(self, sql: str) -> tuple[list[str], list[Any]]:
        import sqlite3

        try:
            store = sqlite3.connect(f"{self._store.resolve().as_uri()}?mode=ro", uri=True, timeout=30)
            try:
                found = store.execute(sql)
                return [one[0] for one in found.description], found.fetchall()
            finally:
                store.close()
        except sqlite3.DatabaseError as error:
            raise InputError([_core.Fault(os.fspath(self._store),
                                          f"the store is damaged or cannot be read: {error}",
                                          "run the campaign again", "store")]) from None

    @property
    def title(self) -> str:
        return dict(self._ask("SELECT key, value FROM campaign")[1]).get("title", "")

    @property
    def keys(self) -> list[SweptKey]:
        """The keys that vary."""
        _, rows = self._ask('SELECT key, unit, "column", "numeric", follows FROM swept ORDER BY position')
        return [SweptKey(key, unit, column, bool(numeric), bool(follows))
                for key, unit, column, numeric, follows in rows]

    @property
    def quantities(self) -> dict[str, tuple[str, str, str, str]]:
        """Unit, meaning, column and column of the half-width of each quantity."""
        _, rows = self._ask('SELECT name, unit, about, "column", ci95_column FROM quantities '
                            "ORDER BY position")
        return {name: (unit, about, column, ci95) for name, unit, about, column, ci95 in rows}

    @cached_property
    def table(self) -> np.ndarray:
        """One row a point: the varied keys, the state of the run, and every quantity with its
        half-width. Open the campaign again to see what a running campaign has added."""
        return array_of(*self._ask("SELECT * FROM results"))

    def frame(self) -> pd.DataFrame:
        """`table` as a pandas frame."""
        return frame_of(self.table)

    def dataset(self) -> xr.Dataset:
        """Every quantity and its half-width ("dissipated_power", "dissipated_power_ci95") as an xarray dataset
        over the swept keys; over "point" where the points are no grid. Raises ImportError without xarray."""
        axes = {one.key: self.column(one.key) for one in self.keys if not one.follows}
        data = {one.key: (self.column(one.key), {"units": one.unit}) for one in self.keys if one.follows}
        for name, (unit, about, column, ci95) in self.quantities.items():
            for called, known in ((name, column), (name + "_ci95", ci95)):
                if known in (self.table.dtype.names or ()):
                    data[called] = (self.table[known], {"units": unit, "long_name": about})
        made = on_grid(axes, data, {"title": self.title})
        for one in self.keys:
            made[one.key].attrs["units"] = one.unit
        return made

    def column(self, name: str) -> np.ndarray:
        """The values of a key ("mill.speed") or a quantity ("dissipated_power"), by point."""
        return self.table[self.column_name(name)]

    def key_of(self, name: str) -> str:
        """The key that a name stands for: itself, or that of a column."""
        return next((one.key for one in self.keys if one.column == name), name)

    def column_name(self, name: str) -> str:
        if name in (self.table.dtype.names or ()):
            return name
        for one in self.keys:
            if one.key == name:
                return one.column
        found = self.quantities.get(name)
        if found is None:
            import difflib

            near = difflib.get_close_matches(name, [k.key for k in self.keys] + list(self.quantities), n=1)
            raise KeyError(f"the campaign has no key or quantity {name}"
                           + (f"; did you mean {near[0]}?" if near else ""))
        return found[2]

    def unit(self, name: str) -> str:
        """Unit of a key or quantity; "1" or "" for none."""
        return next((one.unit for one in self.keys if name in (one.key, one.column)),
                    self.quantities.get(name, ("",))[0])

    @property
    def warnings(self) -> list[tuple[int, str, str]]:
        """(point, code, text) of every warning, points counted from 1."""
        return self._ask("SELECT p.point, n.code, n.text FROM notices n JOIN points p ON p.hash = n.hash "
                         "WHERE n.severity != 'note' ORDER BY p.point, n.position")[1]

    @property
    def failed(self) -> list[tuple[int, str]]:
        """(point, reason) of every run that physics stopped."""
        return self._ask("SELECT p.point, r.message FROM points p JOIN runs r ON r.hash = p.hash "
                         "WHERE r.status = 'failed' ORDER BY p.point")[1]

    def __len__(self) -> int:
        return len(self.table)

    def __getitem__(self, index: int) -> Result:
        """The result of a point, from 0. Raises InputError if its folder was not kept."""
        count = len(self)
        if not -count <= index < count:
            raise IndexError(f"the campaign has {count} points")
        folder = str(self.table["folder"][index])
        if folder in ("", "nan"):
            raise InputError([_core.Fault(
                os.fspath(self.folder), f"the run of point {index % count + 1} has no result folder",
                "it has not run, or only its numbers were kept (--results summary)", "no-result")])
        return Result(self.folder / folder)

    def __iter__(self) -> Iterator[Result]:
        return (self[i] for i in range(len(self)))

    def surrogate(self, out: Union[str, os.PathLike[str]], quantities: Iterable[str] = (), *,
                  force: bool = False) -> Surrogate:
        """Writes the file `out` with the results between the settings, as `mahlwerk surrogate`, and opens it.
        `quantities`: default those that the page of the campaign shows; `force`: replaces an existing file."""
        from .commands import command
        from .surrogate import Surrogate

        command(["surrogate"], folder=os.fspath(self.folder), out=os.fspath(out),
                quantity=list(quantities), force=force)
        return Surrogate(out)

    def page(self) -> Page:
        """The page campaign.html, for a notebook or a file."""
        return Page((self.folder / "campaign.html").read_text(encoding="utf-8"))

    @property
    def plot(self) -> CampaignPlots:
        """Plots with matplotlib: `campaign.plot.curve(x, y)`, `campaign.plot.map(x, y, quantity)`."""
        from .plots import CampaignPlots

        return CampaignPlots(self)

    def __repr__(self) -> str:
        return f"<Campaign {self.title!r}, {len(self)} points in {os.fspath(self.folder)}>"

    def _repr_html_(self) -> str:
        keys = [one.column for one in self.keys]
        shown = keys + [c for c in ("status", "dissipated_power_W", "collision_rate_per_s",
                                    "regime", "warnings") if c in self.table.dtype.names]
        rows = [[row[c] if isinstance(row[c], str) else f"{row[c]:.4g}" for c in shown]
                for row in self.table]
        return f"<b>{html.escape(self.title)}</b>" + table_html(shown, rows)
