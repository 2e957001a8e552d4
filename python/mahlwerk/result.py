# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Results of a run, just computed or read from a result folder."""

from __future__ import annotations

import html
import json
import math
import os
from collections.abc import Callable, Mapping
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _core
from .errors import InputError
from .files import named_folder
from .frames import frames_in
from .pages import Page, table_html
from .public import Public
from .quantities import Influence, Notice, Quantity, correlated, nan_if_none, notices_of
from .records import array_of_records
from .tables import Tables, dataset_of, frame_of, of_columns

if TYPE_CHECKING:
    import numpy as np
    import pandas as pd
    import xarray as xr
    from uncertainties import UFloat

    from .case import Case
    from .citation import Citation
    from .plots import ResultPlots

__all__ = ["Result"]


class Result(Public):
    """What a run gave: quantities, tables, collision records, plots.

    `Result(folder)` opens a result folder; `Case.run` returns one.

    >>> result = case.run()
    >>> result["collision_rate"].value, result["collision_rate"].ci95
    >>> result.frame("spectrum")[["energy_low_J", "rate_lost_per_s"]]
    """

    def __init__(self, folder: Union[str, os.PathLike[str]]):
        self.folder: Optional[Path] = Path(folder).absolute()
        self._ran: Any = None
        self._state: dict[str, Any] = {}
        if not (self.folder / "summary.json").is_file():
            raise InputError([_core.Fault(os.fspath(folder), "there is no summary.json: the folder is not a result",
                                          "give the folder that `mahlwerk run` wrote", "no-result")])

    @classmethod
    def of_run(cls, ran: Any, folder: Optional[Path], origin: Path) -> Result:
        """`origin`: the folder to which file names of the case are relative."""
        made = cls.__new__(cls)
        made.folder = None if folder is None else folder.absolute()
        made._ran, made._state = ran, {"origin": origin}
        return made

    # Numbers

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The content of summary.json."""
        if self._ran is not None:
            return json.loads(self._ran.summary_json())
        if self.folder is None:
            return self._state["summary"]
        return summary_in(self.folder)

    @property
    def about(self) -> dict[str, Any]:
        """How the result was made: version, engine, seed, replicates, assumed and unverified values."""
        return self.summary["_about"]

    @cached_property
    def quantities(self) -> dict[str, Quantity]:
        """Every quantity by its name in summary.json."""
        replicates = int(self.summary.get("replicates", {}).get("value") or 0)
        return {name: Quantity.of(name, told, replicates)
                for name, told in self.summary.items() if not name.startswith("_")}

    @property
    def key_quantities(self) -> list[str]:
        """Names of the quantities that are asked for first; print() shows them."""
        return list(self.summary.get("_key_quantities", []))

    @property
    def groups(self) -> dict[str, list[str]]:
        """The names of all quantities under the headings of the report."""
        return {one["heading"]: one["quantities"] for one in self.summary.get("_groups", [])}

    @property
    def sensitivity(self) -> list[Influence]:
        """What each assumed value does, the largest influence on the power first; empty if no run was
        made for that (docs/theory/statistics.md, "Assumed values")."""
        return [Influence(one["key"], one["value"], (one["range"][0], one["range"][1]), one["source"],
                          {name: (nan_if_none(ends[0]), nan_if_none(ends[1]))
                           for name, ends in one["at_ends"].items()})
                for one in self.summary.get("_sensitivity", {}).get("keys", [])]

    def assumed_range(self, name: str) -> Optional[tuple[float, float]]:
        """Least and largest value of a key quantity over the assumed values; None if there is none."""
        ends = [v for one in self.sensitivity for v in one.at_ends.get(name, ())
                if math.isfinite(v)]
        value = self[name].value
        return (min(*ends, value), max(*ends, value)) if ends and math.isfinite(value) else None

    __iter__ = None  # a result is no sequence

    def __getitem__(self, name: str) -> Quantity:
        if not isinstance(name, str):
            raise TypeError(f"a quantity has a name, for instance \"collision_rate\", not {name!r}")
        try:
            return self.quantities[name]
        except KeyError:
            import difflib

            near = difflib.get_close_matches(name, self.quantities, n=1)
            raise KeyError(f"the result has no quantity {name}"
                           + (f"; did you mean {near[0]}?" if near else "")) from None

    def __contains__(self, name: object) -> bool:
        return name in self.quantities

    @property
    def title(self) -> str:
        return self.about["title"]

    @property
    def engine(self) -> str:
        """The engine that ran: "event", "soft" or "lammps"."""
        return self.about["engine"]

    @property
    def regime(self) -> str:
        """Regime of the charge ("cascading", "cataracting", ...), or ""."""
        return self.about["regime"]

    @property
    def complete(self) -> bool:
        """Whether every replicate ran to its end."""
        return self.about["complete"]

    @property
    def notices(self) -> list[Notice]:
        return notices_of(self.about)

    @property
    def warnings(self) -> list[Notice]:
        """Why the result must be used with care; see the documentation's page of warnings."""
        return [one for one in self.notices if one.warns]

    @property
    def text(self) -> str:
        """The resolved case as TOML."""
        if self.folder is not None:  # where the files that it names are, too
            return (self.folder / "case.resolved.toml").read_text(encoding="utf-8")
        return self._state["text"] if self._ran is None else self._ran.resolved_case()

    @property
    def case(self) -> Case:
        """The case that ran, with every value that was used."""
        from .case import Case

        return Case.from_text(self.text, self.folder or self._state.get("origin"))

    # Tables

    @cached_property
    def tables(self) -> Mapping[str, np.ndarray]:
        """Every table as a numpy structured array, by the name of its CSV file without ".csv"."""
        if self._ran is not None:
            return Tables({name: partial(of_columns, columns) for name, (_, columns) in self._ran.tables().items()})
        if self.folder is None:
            return self._state["tables"]
        return Tables.in_folder(self.folder)

    def table(self, name: str) -> np.ndarray:
        """A table, for instance "spectrum", "timeseries", "replicates", "wall_map"."""
        try:
            return self.tables[name]
        except KeyError:
            raise KeyError(f"the result has no table {name}; it has {', '.join(self.tables)}") from None

    def frame(self, name: Optional[str] = None) -> pd.DataFrame:
        """A table as a pandas frame; without a name, the quantities."""
        if name is not None:
            return frame_of(self.table(name))
        import pandas as pd

        parts = ["name", "value", "ci95", "ci95_time", "unit", "about"]
        return pd.DataFrame([[getattr(q, part) for part in parts] for q in self.quantities.values()],
                            columns=parts).set_index("name")

    def dataset(self, name: str, **choice: Union[str, float]) -> xr.Dataset:
        """A table as an xarray dataset over its bins: the middles of a map, a spectrum or a series are its
        coordinates. `choice` selects rows by words: `result.dataset("wall_map", part="side")`. Raises
        ValueError for a choice that is missing; ImportError without xarray."""
        return dataset_of(self.table(name), choice)

    def ufloats(self, *names: str) -> tuple[UFloat, ...]:
        """These quantities as numbers of the package uncertainties that depend on each other as their values in
        the replicates do, so that what they have in common cancels:

        >>> power, drawn = result.ufloats("dissipated_power", "drawn_power")
        >>> power / drawn

        Raises ValueError for a quantity without a value in each of at least two replicates; ImportError
        without the package.
        """
        table = self.table("replicates")
        columns = {name: _core.column_name(name, self[name].unit) for name in names}
        if any(one not in (table.dtype.names or ()) for one in columns.values()) or len(table) < 2:
            raise ValueError(f"{', '.join(names)}: not each has values in at least two replicates")
        return correlated([self[name] for name in names], [table[one] for one in columns.values()])

    def _ipython_key_completions_(self) -> list[str]:
        return list(self.quantities)

    def collisions(self, replicate: int = 1) -> np.ndarray:
        """The collision records of a replicate as a structured array; its fields are described by
        `mahlwerk.record_columns()`. Records in memory are not copied. Needs collisions=True of
        `Case.run`, or [observe] collisions of the case."""
        if self._ran is not None and self._ran.replicates_with_records:
            return array_of_records(self._ran.records(replicate))
        if "records" in self._state and 1 <= replicate <= len(self._state["records"]):
            return self._state["records"][replicate - 1]
        file = None if self.folder is None else self.folder / "collisions.h5"
        if file is None or not file.is_file():
            raise InputError([_core.Fault(
                "", "the result has no collision records",
                "run the case with collisions=True, or with [observe] collisions = true into a folder",
                "no-records")])
        return array_of_records(_core.read_records(file, replicate))

    def frames(self, replicate: int = 1) -> np.ndarray:
        """The balls at the times of [observe] frames, a row for each ball and time: time_s, id, x_m, ... in the frame
        of the jar (docs/formats.md, frames-1.xyz). Raises InputError if the run kept none."""
        return frames_in(self.folder, replicate)

    # Pictures and pages

    @property
    def plot(self) -> ResultPlots:
        """Plots with matplotlib: `result.plot.spectrum()`, ..."""
        from .plots import ResultPlots

        return ResultPlots(self)

    @property
    def report(self) -> str:
        """The page report.html as text."""
        if self._ran is not None:
            return self._ran.report_page()
        if self.folder is None:
            return self._state["report"]
        return (self.folder / "report.html").read_text(encoding="utf-8")

    def page(self) -> Page:
        """The page report.html, for a notebook or a file."""
        return Page(self.report)

    def cite(self) -> Citation:
        """Methods paragraph and references of the models that this run used, as `mahlwerk cite`. A
        result in memory whose case names files must be saved first. Raises InputError."""
        import tempfile

        from .citation import Citation
        from .commands import command

        if self.folder is not None:
            return Citation.of(command(["cite"], case=os.fspath(self.folder)))
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "summary.json").write_text(json.dumps(self.summary), encoding="utf-8")
            Path(folder, "case.resolved.toml").write_text(self.text, encoding="utf-8")
            return Citation.of(command(["cite"], case=folder))

    def save(self, folder: Union[str, os.PathLike[str]], *, force: bool = False) -> None:
        """Writes a result folder, the same as the command line, with the collision records that are in
        memory. Raises InputError."""
        if self._ran is None:
            raise InputError([_core.Fault(os.fspath(folder), "this result is not in memory: it cannot be saved",
                                          "copy its folder", "no-result")])
        self._ran.save(named_folder(folder), force)
        self.folder = Path(folder).absolute()

    def _over_assumed(self, name: str) -> str:
        ends = self.assumed_range(name)
        if ends is None:
            return ""
        low, high = (self[name].of_value(end).text() for end in ends)
        return f"  ({low} to {high} over assumed values)"

    def __repr__(self) -> str:
        said = "" if self.complete else ", incomplete"
        return f"<Result {self.title!r}, {self.engine} engine{said}>"

    def __str__(self) -> str:
        lines = [repr(self), ""]
        lines += [f"{name:<34} {self[name].text()}{self._over_assumed(name)}"
                  for name in self.key_quantities]
        lines += [f"\n{one.severity}: {one.text}" for one in self.notices]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        rows = [(q.name, q.text(), q.about) for q in self.quantities.values()
                if math.isfinite(q.value)]
        told = "".join(f"<p><b>{one.severity}:</b> {html.escape(one.text)}</p>"
                       for one in self.warnings)
        return (f"<b>{html.escape(self.title)}</b>{told}<details><summary>all quantities</summary>"
                f"{table_html(('quantity', 'value', 'meaning'), rows)}</details>{self.page()._repr_html_()}")

    def __reduce__(self) -> tuple[Callable[..., Result], tuple[object]]:
        count = self._ran.replicates_with_records if self._ran is not None else 0
        if self.folder is not None and (count == 0 or (self.folder / "collisions.h5").is_file()):
            return Result, (self.folder,)
        state = self._state if self._ran is None else {
            "origin": self._state["origin"],
            "summary": self.summary, "text": self.text, "tables": dict(self.tables),
            "report": self.report,
            "records": [self.collisions(i + 1).copy() for i in range(count)]}
        return restored, (state,)


def summary_in(folder: Path) -> dict[str, Any]:
    try:
        made = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        return {**made, "_about": made["_about"]}
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise InputError([_core.Fault(
            os.fspath(folder / "summary.json"), f"the file is damaged or cannot be read: {error}",
            "run the case again", "no-result")]) from None


def restored(state: dict[str, Any]) -> Result:
    made = Result.__new__(Result)
    made.folder, made._ran, made._state = None, None, state
    return made
