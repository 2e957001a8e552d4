# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Commands of the command line in this process, and what they report as Python values."""

from __future__ import annotations

import json
import warnings
from typing import Any, TypedDict, Union

from . import _core
from .errors import InputError, Interrupted, RunError
from .progress import Progress, shown

__all__ = ["command", "describe", "catalogue"]

BAD_INPUT, STOPPED, INTERRUPTED = 2, 3, 130


def command(words: list[str], *, progress: Progress = False,
            refusal_is_result: bool = False, **options: Any) -> Any:
    """Runs a command and returns what it prints with --json. `options` have the names of the command
    line: case="." of CASE, jar_kind="sphere" of --jar-kind, in_=... of --in; set={key: text}. Its faults are raised: InputError,
    RunError or Interrupted, by its exit code; its warnings become UserWarning. `refusal_is_result`:
    what the command prints beside exit code 2 is returned."""
    with shown(progress) as show:
        code, text, faults, told = _core.command(
            words, {name.rstrip("_"): value for name, value in options.items()}, show)
    for one in told:
        warnings.warn(str(one), stacklevel=3)
    if code == BAD_INPUT and not (refusal_is_result and text):
        raise InputError(faults or [_core.Fault("", "the input was refused", "", "")])
    if code == STOPPED:
        raise RunError("\n".join(map(str, faults)) or "physics stopped a run")
    if code == INTERRUPTED:
        raise Interrupted("\n".join(map(str, faults)) or "interrupted")
    if code not in (0, BAD_INPUT):
        raise RuntimeError(f"{' '.join(words)} ended with code {code}")
    return json.loads(text) if text else None


class CatalogueName(TypedDict):
    """A line of `mahlwerk list`."""

    room: str  # "mills"
    name: str
    title: str
    unverified: bool  # whether a value has a weak source


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
