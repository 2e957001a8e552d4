# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Files of cases."""

from __future__ import annotations

import contextlib
import csv
import io
import os
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from . import _core
from .errors import InputError

__all__ = ["kept", "measurements", "named_folder", "read_text", "temporary"]


def read_text(file: Path) -> str:
    try:
        return file.read_bytes().decode("utf-8", "surrogateescape")
    except OSError as error:
        raise InputError([_core.Fault(os.fspath(file), f"the file cannot be read: {error.strerror}",
                                      "", "no-such-case")]) from None


def named_folder(folder: str | os.PathLike[str]) -> Path:
    """The path of a result folder. Raises InputError for an empty name."""
    if not os.fspath(folder):
        raise InputError([_core.Fault("", "the name of the folder is empty",
                                      'give a name, for instance "results/name"', "no-folder")])
    return Path(folder)


@contextlib.contextmanager
def kept(text: str, file: Path, force: bool) -> Iterator[str]:
    """Path of a case file that stays beside the folder of its campaign. Another file of that name is
    replaced only with `force`. It is removed if the campaign is refused."""
    content = text.encode("utf-8", "surrogateescape")
    try:
        old = file.read_bytes() if file.exists() else None
        if old is not None and old != content and not force:
            raise InputError([_core.Fault(
                os.fspath(file), "the file holds another case, whose campaign is beside it",
                "choose another folder, or force=True", "other-campaign")])
        if old != content:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(content)
    except OSError as error:
        raise InputError([_core.Fault(os.fspath(file), f"cannot be written: {error.strerror}",
                                      "choose another folder", "cannot-write")]) from None
    try:
        yield os.fspath(file)
    except InputError:
        if old is None:
            file.unlink(missing_ok=True)
        elif old != content:
            file.write_bytes(old)
        raise


def measurements(data: object) -> contextlib.AbstractContextManager[str]:
    """Path of a table of measurements: that of a file, or a temporary one with the columns of a data frame or of
    a dict. Raises TypeError for something else."""
    if isinstance(data, (str, os.PathLike)):
        return contextlib.nullcontext(os.fspath(data))
    if isinstance(data, Mapping):
        text = csv_of(data)
    elif hasattr(data, "to_csv"):
        text = data.to_csv(index=False)
    else:
        raise TypeError(f"measurements are a CSV file, a data frame or a dict of columns, not {data!r}")
    return temporary(text, Path.cwd() / "data", "data", ".csv")


def csv_of(columns: Mapping[object, object]) -> str:
    """A table of named columns. Raises TypeError for one that is no column, ValueError for unequal ones."""
    lists = {}
    for name, column in columns.items():
        if isinstance(column, str) or not isinstance(column, Iterable):
            raise TypeError(f"the column {name} of the measurements is a list of values, not {column!r}")
        lists[name] = list(column)
    if len({len(column) for column in lists.values()}) > 1:
        told = ", ".join(f"{name} has {len(column)}" for name, column in lists.items())
        raise ValueError(f"the columns of the measurements have different numbers of values: {told}")
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows([lists, *zip(*lists.values())])
    return out.getvalue()


@contextlib.contextmanager
def temporary(text: str, place: Path, shown: str, suffix: str = ".toml") -> Iterator[str]:
    """Path of a case file that exists for a while, beside `place` where that can be written, since
    files that a case names are relative to it. Faults cite `shown` in its stead."""
    import tempfile

    folder = place.parent if os.access(place.parent, os.W_OK) else None
    handle, path = tempfile.mkstemp(suffix, ".case-", folder)
    try:
        with open(handle, "wb") as out:
            out.write(text.encode("utf-8", "surrogateescape"))
        yield path
    except InputError as error:
        raise InputError([_core.Fault(one.where.replace(path, shown), one.what, one.remedy, one.code)
                          for one in error.faults]) from None
    finally:
        os.unlink(path)
