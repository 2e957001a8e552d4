# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""What is known of a case before it runs."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, NamedTuple

from .pages import table_html

if TYPE_CHECKING:
    from .quantities import Quantity

__all__ = ["Check", "Origin"]


class Origin(NamedTuple):
    """A value of a case and where it comes from."""

    key: str
    value: str  #: as written in a case file, with its unit
    source: str  #: "case.toml:9", "--set mill.speed", "catalogue ...", "default: ..."
    assumed: bool  #: a default that nobody chose
    unverified: bool  #: the source in the catalogue is weak
    range: tuple[str, str] | None = None  #: plausible range of an assumed value of the catalogue


class Check(NamedTuple):
    """What follows from a case, before it runs."""

    derived: dict[str, Quantity]  #: filling, critical speed, run time ...
    notes: list[str]  #: the choice of the engine, unusual values
    assumed: list[Origin]  #: defaults that nobody chose

    def __repr__(self) -> str:
        return f"<Check: {len(self.derived)} derived quantities, {len(self.notes)} notes, {len(self.assumed)} assumed values>"

    def __str__(self) -> str:
        lines = [f"{name:<24} {one}" for name, one in self.derived.items()] + ["", *self.notes, "", "assumed:"]
        return "\n".join(lines + [f"{one.key:<24} {one.value:<14} {one.source}" for one in self.assumed])

    def _repr_html_(self) -> str:
        rows = [(name, q.text(), q.about) for name, q in self.derived.items()]
        notes = "".join(f"<p>{html.escape(note)}</p>" for note in self.notes)
        return table_html(("quantity", "value", "meaning"), rows) + notes
