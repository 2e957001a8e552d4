# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The surrogate of a campaign: results between its settings, without runs."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Union

from . import toml
from .commands import command
from .public import Public

if TYPE_CHECKING:
    from .toml import Value

__all__ = ["Prediction", "Surrogate"]


class Prediction(NamedTuple):
    """A quantity at a setting. `low` and `high` are the ends of the 95 % interval of its mean over replicates."""

    value: float
    low: float
    high: float
    unit: str
    #: root mean square error of settings of the campaign predicted from the others, over the spread
    hold_out_error: float


class Surrogate(Public):
    """Mean and interval of quantities over the swept keys of a campaign. `Surrogate(file)` opens a file that
    `mahlwerk surrogate` or `Campaign.surrogate` wrote.

    >>> mill = campaign.surrogate("mill.json")
    >>> mill({"mill.frequency": "10.5 Hz"})["dissipated_power"].value
    """

    def __init__(self, file: Union[str, os.PathLike[str]]):
        self.file = Path(file)
        #: what the file knows: title, digest, settings, keys with their ranges, hold-out errors, notices
        self.data: dict[str, Any] = command(["ask"], file=os.fspath(file))

    @property
    def keys(self) -> dict[str, tuple[str, str]]:
        """The range of each key, as in the campaign: {"mill.speed": ("200 rpm", "800 rpm")}."""
        return {key: (one["from"], one["to"]) for key, one in self.data["keys"].items()}

    def __call__(self, setting: Mapping[str, Value], quantities: Iterable[str] = ()) -> dict[str, Prediction]:
        """The quantities (default: all of the file) at a setting, which gives every key. Raises InputError outside
        the range of the campaign: a surrogate does not extrapolate."""
        if not setting:
            raise ValueError(f"a setting gives {', '.join(self.keys)}")
        asked = command(["ask"], file=os.fspath(self.file), quantity=list(quantities),
                        set={key: toml.change_text(value) for key, value in setting.items()})
        return {name: Prediction(one["value"], one["low"], one["high"], one["unit"], one["hold_out_error"])
                for name, one in asked["quantities"].items()}

    def __repr__(self) -> str:
        return f"<Surrogate of {self.data['title']!r}, {self.data['settings']} settings>"
