# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Tables of results as numpy structured arrays and pandas frames."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    import pandas as pd

__all__ = ["array_of", "frame_of", "of_columns", "read_csv"]


def frame_of(array: np.ndarray) -> pd.DataFrame:
    """A pandas frame with a column for each field of a structured array."""
    try:
        import pandas as pd
    except ImportError:
        raise ImportError("a frame needs pandas: install python3-pandas, or use the arrays") from None
    return pd.DataFrame(columns_of(array), copy=False)


def columns_of(array: np.ndarray) -> dict[str, np.ndarray]:
    """The fields of a structured array, each copied to an array of its own."""
    import numpy as np

    made = {name: np.empty(len(array), array.dtype[name]) for name in array.dtype.names or ()}
    block = 4096  # records of a block stay in the cache while their fields are copied
    for begin in range(0, len(array), block):
        part = array[begin:begin + block]
        for name, values in made.items():
            values[begin:begin + block] = part[name]
    return made


def of_columns(columns: Sequence[tuple[str, str, str, Any]]) -> np.ndarray:
    """A structured array of columns with name, unit, meaning and values: bytes of doubles, or words."""
    import numpy as np

    values = [np.frombuffer(v, "<f8") if isinstance(v, bytes) else np.array(v, str)
              for *_, v in columns]
    made = np.empty(len(values[0]), [(c[0], v.dtype) for c, v in zip(columns, values)])
    for (name, *_), v in zip(columns, values):
        made[name] = v
    return made


def read_csv(file: Path) -> np.ndarray:
    """A table written by Mahlwerk, or another CSV table with one heading line. Columns of words become text; an empty cell of a number is NaN."""
    with open(file, newline="", encoding="utf-8") as lines:
        rows = list(csv.reader(lines, skipinitialspace=True))
    return array_of(rows[0], rows[1:])


def array_of(names: Sequence[str], rows: Sequence[Sequence[Any]]) -> np.ndarray:
    """A structured array; a column is a number if all its cells are numbers or empty."""
    import numpy as np

    columns = [column(cells) for cells in zip(*rows)] if rows else [np.empty(0) for _ in names]
    made = np.empty(len(rows), [(name, values.dtype) for name, values in zip(names, columns)])
    for name, values in zip(names, columns):
        made[name] = values
    return made


def column(cells: Sequence[Any]) -> np.ndarray:
    import numpy as np

    if all(isinstance(cell, int) for cell in cells):
        return np.array(cells)
    try:
        return np.array([float("nan") if cell in ("", None) else float(cell) for cell in cells])
    except ValueError:
        return np.array(["" if cell is None else str(cell) for cell in cells])
