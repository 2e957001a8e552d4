# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Commands of the command line in this process, and what they report as Python values."""

from __future__ import annotations

import json
import warnings
from os import PathLike
from typing import TYPE_CHECKING, Any, Union

from . import _core
from .errors import InputError, Interrupted, RunError
from .progress import Progress, shown

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    #: A value of an option of the command line.
    Option = Union[None, bool, int, float, str, PathLike[str], Sequence[str], Mapping[str, Union[str, None]]]

__all__ = ["command"]

BAD_INPUT, STOPPED, INTERRUPTED = 2, 3, 130


def command(words: Union[str, list[str]], *, progress: Progress = False,
            refusal_is_result: bool = False, **options: Option) -> Any:
    """Runs any command of the command line and returns what it prints with --json (docs/formats.md), for those
    that have no function of their own.

    >>> mahlwerk.command("list", category="units")[0]

    `words` are the command and its subcommand. `options` have the names of the command line: case="." of
    CASE, jar_kind="sphere" of --jar-kind, in_=... of --in; set={key: text}, in which None is --unset. Its faults are
    raised: InputError, RunError or Interrupted, by its exit code; its warnings become UserWarning.
    `refusal_is_result`: what the command prints beside exit code 2 is returned.
    """
    words = words.split() if isinstance(words, str) else words
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
