# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""What there is: entries of the catalogue, keys and units of a case file, quantities of a result."""

from __future__ import annotations

from typing import Any, Optional, TypedDict, Union

from .commands import command

__all__ = ["CatalogueName", "KeyInfo", "QuantityInfo", "UnitInfo", "catalogue", "describe", "list_keys",
           "list_quantities", "list_units"]


class CatalogueName(TypedDict):
    """A line of `mahlwerk list`."""

    room: str  # "mills"
    name: str
    title: str
    unverified: bool  # whether a value has a weak source


class KeyInfo(TypedDict):
    """A key of a case file. Other entries are those of `mahlwerk list keys --json` (docs/formats.md)."""

    key: str  # "mill.frequency"
    kind: Optional[str]  # of the mill, jar or model that has the key; None: all
    type: str  # "quantity", "number", "integer", "text", ...
    unit: Optional[str]
    least: Optional[float]
    most: Optional[float]
    default: Optional[str]
    words: list[str]  # that the key may have
    required: bool
    about: str


class UnitInfo(TypedDict):
    """A unit that a value may have: its value in SI units is `factor` times the number plus `offset`."""

    unit: str
    si: str
    factor: float
    offset: float


class QuantityInfo(TypedDict):
    """A quantity that a result may have."""

    name: str
    unit: str
    about: str
    label: str
    heading: str
    only: str  # which cases have it; "" for all
    series: bool  # whether the table "timeseries" has it


def describe(name: str) -> Union[dict[str, Any], list[dict[str, Any]]]:
    """Every value of a catalogue entry with its source, as `mahlwerk describe`, or the keys of a
    section or kind with unit, range, default and meaning.

    >>> mahlwerk.describe("retsch-mm400")["title"]
    """
    return command(["describe"], name=name)


def catalogue(category: str = "", word: str = "") -> list[CatalogueName]:
    """The names in the catalogue: "mills", "jars", "materials", "media", or all; with `word` those that
    have it in their name or title.

    >>> [one["name"] for one in mahlwerk.catalogue("mills", "retsch")]
    """
    return command(["list"], category=category, word=word)


def list_keys(word: str = "") -> list[KeyInfo]:
    """The keys of a case file, as `mahlwerk list keys`; with `word` those that have it in their name or meaning. A
    key of several kinds has an entry for each.

    >>> [(one["key"], one["unit"]) for one in mahlwerk.list_keys("frequency")]
    >>> len(mahlwerk.list_keys("no such word"))
    """
    made: list[KeyInfo] = []
    for part in command(["list"], category="keys"):
        for key in part["keys"]:
            name = ".".join(filter(None, (part["section"], key["key"])))
            if word.lower() in f"{name} {key['about']}".lower():
                key.update(key=name, kind=part["kind"])
                made.append(key)
    return made


def list_units() -> list[UnitInfo]:
    """The units of a case file, as `mahlwerk list units`."""
    return command(["list"], category="units")


def list_quantities(word: str = "") -> list[QuantityInfo]:
    """The quantities of a result, as `mahlwerk list quantities`; with `word` those that have it in their name or
    meaning.

    >>> [one["name"] for one in mahlwerk.list_quantities("power")]
    """
    return [one for one in command(["list"], category="quantities")
            if word.lower() in f"{one['name']} {one['label']} {one['about']}".lower()]
