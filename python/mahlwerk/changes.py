# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Changes of values, and where their faults are said to be."""

from __future__ import annotations

import numbers
import os
import re
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Optional, TypeVar

from . import _core, toml
from .errors import InputError

if TYPE_CHECKING:
    #: Values by their keys; None takes a value from the case.
    Changes = Mapping[str, Optional[toml.Value]]
    Texts = Mapping[str, Optional[str]]

Found = TypeVar("Found")

__all__ = ["checked_threads", "cited", "merged", "plain"]


def checked_threads(threads: int) -> int:
    if not isinstance(threads, numbers.Integral):
        raise TypeError(f"threads is a whole number, not {threads!r}")
    if not 0 <= threads <= 4096:
        raise ValueError(f"threads is from 1 to 4096, or 0 for all cores, not {threads}")
    return int(threads)


def merged(old: Texts, new: Changes) -> dict[str, Optional[str]]:
    """Changes of which the last counts; None takes a value from the case. "balls.1.x" and "balls.x" name
    the same value. A dict gives values of a section: {"contact": {"friction": 0.3}}."""
    made = dict(old)
    for key, value in single_values(new):
        for other in [one for one in made if plain(one) == plain(key)]:
            del made[other]
        made[key] = None if value is None else toml.change_text(value)
    return made


def single_values(changes: Changes) -> Iterator[tuple[str, Optional[toml.Value]]]:
    for key, value in changes.items():
        if not isinstance(key, str):
            raise TypeError(f"a key is a text, for instance \"mill.speed\", not {key!r}")
        if isinstance(value, Mapping) and "." not in key:
            yield from ((f"{key}.{name}", one) for name, one in value.items())
        else:
            yield key, value


def plain(key: str) -> str:
    return re.sub(r"^(balls|parts)\.0*1\.", r"\1.", key)


def cited(file: Path, shown_file: str, work: Callable[[], Found]) -> Found:
    """What `work` returns. Its faults cite `shown_file` in place of `file`."""
    try:
        return work()
    except InputError as error:
        raise InputError([_core.Fault(one.where.replace(os.fspath(file), shown_file), one.what,
                                      one.remedy, one.code) for one in error.faults]) from None
