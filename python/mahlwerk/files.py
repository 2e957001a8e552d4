# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Files of cases."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path

from . import _core
from .errors import InputError

__all__ = ["keep", "read_text", "temporary"]


def read_text(file: Path) -> str:
    try:
        return file.read_bytes().decode("utf-8", "surrogateescape")
    except OSError as error:
        raise InputError([_core.Fault(os.fspath(file), f"the file cannot be read: {error.strerror}",
                                      "", "no-such-case")]) from None


def keep(file: Path, text: str) -> None:
    """Writes the case of a campaign beside its folder; an equal file is left alone."""
    if file.exists() and file.read_text(encoding="utf-8") == text:
        return
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    except OSError as error:
        raise InputError([_core.Fault(os.fspath(file), f"cannot be written: {error.strerror}",
                                      "choose another folder", "cannot-write")]) from None


@contextlib.contextmanager
def temporary(text: str, place: Path) -> Iterator[str]:
    """Path of a case file that exists for a while, beside `place` where that can be written, since
    files that a case names are relative to it. Faults cite `place` in its stead."""
    import tempfile

    folder = place.parent if os.access(place.parent, os.W_OK) else None
    handle, path = tempfile.mkstemp(".toml", ".case-", folder)
    try:
        with open(handle, "w", encoding="utf-8") as out:
            out.write(text)
        yield path
    except InputError as error:
        shown = os.path.relpath(place)
        raise InputError([_core.Fault(one.where.replace(path, shown), one.what, one.remedy, one.code)
                          for one in error.faults]) from None
    finally:
        os.unlink(path)
