# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""What a film, a sound, a power log, a weighed jar or a drop test says of a mill."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

from . import toml
from .case import Case
from .case_source import Place
from .changes import checked_threads
from .commands import command
from .functions import as_case
from .pages import table_html
from .progress import Progress
from .public import Public

if TYPE_CHECKING:
    from .commands import Option
    from .functions import AnyCase
    from .toml import Value

__all__ = ["Finding", "Measurement"]


class Finding(NamedTuple):
    """A number of a measurement with its 95 % interval."""

    key: str  #: of a case that takes it: "mill.arm"; "" for a number that is no key
    label: str
    value: float
    low: float
    high: float
    unit: str  #: of SI; "" for none

    def __float__(self) -> float:
        return self.value

    def __str__(self) -> str:
        from . import _core

        return _core.readable(self.value, self.high - self.value, self.unit or "1", -float("inf"), float("inf"))


class Measurement(Public):
    """Numbers of a mill, each with its interval. A function of `mahlwerk.measure` returns one.

    >>> drop = mahlwerk.measure.drop("examples/measure/drop-heights.csv")
    >>> drop["contact.restitution"].value, drop["contact.restitution"].low
    >>> damped = case.replace(drop.changes)
    """

    def __init__(self, kind: str, options: Mapping[str, Option]):
        self._kind = kind
        self._options: dict[str, Any] = dict(options)
        self.data: dict[str, Any] = self._told()  #: as `mahlwerk measure --json` prints it

    def _told(self, **more: Option) -> dict[str, Any]:
        return command(["measure", self._kind], **{**self._options, **more})

    @property
    def title(self) -> str:
        return self.data["title"]

    @property
    def findings(self) -> list[Finding]:
        """Every number, also those that are no key of a case."""
        return [Finding(one["key"] or "", one["label"], one["value"], one["low"], one["high"], one["unit"])
                for one in self.data["values"]]

    def __getitem__(self, name: str) -> Finding:
        """The number of a key ("mill.arm") or of a label. Raises KeyError."""
        found = self.findings
        for one in found:
            if name in (one.key, one.label):
                return one
        raise KeyError(f"the measurement has no {name}; it has {', '.join(one.key or one.label for one in found)}")

    def _ipython_key_completions_(self) -> list[str]:
        return [one.key or one.label for one in self.findings]

    @property
    def changes(self) -> dict[str, str]:
        """The measured keys of a case, for `case.replace` and `Case(..., changes)`."""
        return {one.key: f"{one.value:.12g} {one.unit}".rstrip() for one in self.findings if one.key}

    @property
    def remarks(self) -> list[str]:
        """What the intervals contain and what was left out."""
        return self.data["remarks"]

    @property
    def next(self) -> str:
        """What to measure next: the value whose range changes the energy of hits most."""
        return self.data["next"]

    def save_entry(self, file: Place, *, force: bool = False) -> Path:
        """Writes the mill or the jar as an entry of a catalogue (`--entry`). After `film` and `jar` alone: others
        raise TypeError."""
        self._told(entry=os.fspath(file), force=force)
        return Path(file)

    def add_to(self, table: Place, conditions: Optional[Mapping[str, Value]] = None) -> Path:
        """Appends the measurement as a row to a table for `Case.fit` (`--data`), with its conditions:
        `power.add_to("power.csv", {"mill.frequency": "25 Hz"})`. After `sound`, `power` and `drop` alone: others
        raise TypeError."""
        self._told(data=os.fspath(table), set={key: toml.change_text(value)
                                               for key, value in (conditions or {}).items()})
        return Path(table)

    def calibrate(self, case: AnyCase, out: Optional[Place] = None, *, force: bool = False) -> Case:
        """The case with the measured values and draws from their intervals in [uncertainty], written into the
        folder `out` as calibrated.toml (`--case`)."""
        case = as_case(case)
        place = case._source.result_folder(out, "-measured")
        with case._source.as_file() as target:
            self._told(case=target, set=case._titled(), out=os.fspath(place), force=force)
        return Case(place / "calibrated.toml")

    def next_by_runs(self, case: AnyCase, *, threads: int = 0, progress: Progress = None) -> str:
        """What to measure next, found by runs of the case at the ends of the ranges of its assumed values
        (`--next`): seconds to minutes."""
        import tempfile

        case = as_case(case)
        with tempfile.TemporaryDirectory() as folder, case._source.as_file() as target:
            return command(["measure", self._kind], **self._options, case=target, set=case._titled(), next=True,
                           out=os.path.join(folder, "measured"), threads=checked_threads(threads),
                           progress=progress)["next"]

    def __str__(self) -> str:
        lines = [f"{one.label:<34} {one}{f'  {one.key}' if one.key else ''}" for one in self.findings]
        return "\n".join([self.title, "", *lines, "", *self.remarks, self.next])

    def __repr__(self) -> str:
        return f"<Measurement {self.title!r}>"

    def _repr_html_(self) -> str:
        return table_html(["", "value", "key"], [[one.label, str(one), one.key] for one in self.findings])


def texts(files: Union[Place, list[Place], tuple[Place, ...]]) -> list[str]:
    """The paths of one file or of several."""
    return [os.fspath(one) for one in (files if isinstance(files, (list, tuple)) else [files])]
