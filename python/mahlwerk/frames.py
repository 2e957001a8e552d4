# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The balls at regular times, from the files of [observe] frames."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Optional

from . import _core
from .errors import InputError

if TYPE_CHECKING:
    import numpy as np

__all__ = ["frames_in"]

COLUMNS = {"pos": "{}_m", "radius": "radius_m", "velo": "velocity_{}_m_per_s", "angular_velocity": "spin_{}_rad_per_s",
           "forces": "force_{}_N", "orientation": "orientation_{}"}


def frames_in(folder: Optional[Path], replicate: int) -> np.ndarray:
    """The rows of frames-N.xyz. Raises InputError if there is no such file or it is damaged."""
    import numpy as np

    file = None if folder is None else folder / f"frames-{replicate}.xyz"
    if file is None or not file.is_file():
        raise InputError([_core.Fault(
            os.fspath(file or ""), f"the result has no frames of replicate {replicate}",
            'run the case into a folder with "observe.frames", for instance "1 ms", and frames_format "xyz" or "both"',
            "no-result")])
    names: list[str] = []
    parts = []
    try:
        with open(file, encoding="utf-8") as lines:
            for time, names, rows in blocks(lines):
                numbers = np.array(" ".join(rows).split(), float).reshape(len(rows), -1)
                parts.append(np.column_stack([np.full(len(rows), time), numbers]))
        kind = [(name, "<i8" if name in ("id", "species", "body") else "<f8") for name in ["time_s", *names]]
        whole = np.concatenate(parts) if parts else np.empty((0, len(kind)))
        made = np.empty(len(whole), kind)
        for column, (name, _) in enumerate(kind):
            made[name] = whole[:, column]
    except (ValueError, IndexError) as error:
        raise InputError([_core.Fault(os.fspath(file), f"the file is damaged: {error}", "run the case again",
                                      "no-result")]) from None
    return made


def blocks(lines: Iterator[str]) -> Iterator[tuple[float, list[str], list[str]]]:
    """Time, names of the columns and rows of each frame."""
    for count in lines:
        keys = next(lines, "")
        time = re.search(r'\bTime="?([^" ]+)', keys)
        properties = re.search(r'Properties="?([^" \n]+)', keys)
        if not (time and properties):
            raise ValueError("a frame has no Time or no Properties")
        yield float(time[1]), names_of(properties[1]), list(islice(lines, int(count)))


def names_of(properties: str) -> list[str]:
    """Names with units of id:I:1:pos:R:3:..."""
    words = properties.split(":")
    made = []
    for name, width in zip(words[::3], words[2::3]):
        pattern = COLUMNS.get(name, name)
        made += [pattern.format(axis) for axis in "xyzw"[:int(width)]] if int(width) > 1 else [pattern]
    return made
