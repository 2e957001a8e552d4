# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The first answers for a mill in a few words."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

from . import toml
from .case import Case
from .changes import checked_threads
from .commands import command
from .pages import table_html
from .progress import Progress
from .public import Public
from .quantities import Notice, notices_of

if TYPE_CHECKING:
    from .toml import Value

__all__ = ["Band", "Cause", "Estimate", "estimate"]


class Cause(NamedTuple):
    """An assumed value that makes a band wide."""

    key: str  #: "contact.restitution"
    range: tuple[str, str]  #: ends of the range in which it may lie
    at_ends: tuple[float, float]  #: the quantity there, in its unit


class Band(NamedTuple):
    """A quantity and the band in which it lies: over each assumed value alone, and over replicates."""

    value: float
    low: float
    high: float
    unit: str
    causes: list[Cause]  #: beyond chance, the largest first

    def __float__(self) -> float:
        return self.value


class Estimate(Public):
    """Power, hits, their energy and the dose, by name: `estimate["dissipated_power"].low`."""

    def __init__(self, data: dict[str, Any], changes: Mapping[str, Value]):
        self.data = data  #: as `mahlwerk estimate --json` prints it
        self._changes = changes

    @property
    def title(self) -> str:
        return self.data["title"]

    @property
    def bands(self) -> dict[str, Band]:
        return {name: Band(one["value"], one["low"], one["high"], one["unit"],
                           [Cause(c["key"], (c["range"][0], c["range"][1]), (c["at_ends"][0], c["at_ends"][1]))
                            for c in one["causes"]])
                for name, one in self.data["quantities"].items()}

    def __getitem__(self, name: str) -> Band:
        return self.bands[name]

    def _ipython_key_completions_(self) -> list[str]:
        return list(self.bands)

    @property
    def notices(self) -> list[Notice]:
        return notices_of(self.data)

    @property
    def case(self) -> Case:
        """The case that was run, to change and to run whole."""
        return Case.from_text(self.data["toml"]).replace(self._changes)

    def __repr__(self) -> str:
        power = self["dissipated_power"]
        return f"<Estimate of {self.title!r}: {power.low:.3g} to {power.high:.3g} {power.unit}>"

    def _repr_html_(self) -> str:
        return table_html(["", "best guess", "from", "to", "unit", "wide because of"],
                          [[name.replace("_", " "), f"{b.value:.3g}", f"{b.low:.3g}", f"{b.high:.3g}", b.unit,
                            ", ".join(f"{c.key} {c.range[0]} to {c.range[1]}" for c in b.causes[:2])]
                           for name, b in self.bands.items()])


def estimate(mill: str, *, balls: Union[str, Iterable[str]], jar: Optional[str] = None,
             material: Optional[str] = None, frequency: Optional[str] = None, speed: Optional[str] = None,
             powder: Optional[str] = None, time: Optional[str] = None, set: Optional[Mapping[str, Value]] = None,
             threads: int = 0, progress: Progress = False) -> Estimate:
    """Estimates power, hits and dose of a mill of the catalogue, each with its band, as `mahlwerk estimate`.

    >>> found = mahlwerk.estimate("MM 400", jar="25ml", material="ZrO2", balls="2x10mm", frequency="30Hz",
    ...                           time="1h", powder="200mg")
    >>> found["dissipated_power"].low, found["dissipated_power"].high

    `balls`: number, mass or filling and diameter, or a list of them. `powder`: a mass, or "10:1". `set`: values of
    other keys. Raises InputError.
    """
    if not isinstance(balls, Iterable):
        raise TypeError(f"balls are texts, for instance \"2x10mm\", not {balls!r}")
    words = [balls] if isinstance(balls, str) else list(balls)
    told = command(["estimate"], mill=mill, balls=words, jar=jar, material=material, frequency=frequency,
                   speed=speed, powder=powder, time=time, threads=checked_threads(threads), progress=progress,
                   set={key: toml.change_text(value) for key, value in (set or {}).items()})
    return Estimate(told, set or {})
