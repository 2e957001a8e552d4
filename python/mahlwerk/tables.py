# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Tables of results as numpy structured arrays and pandas frames."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

if TYPE_CHECKING:
    import numpy as np
    import pandas as pd
    import xarray as xr

__all__ = ["Tables", "array_of", "dataset_of", "frame_of", "of_columns", "on_grid", "read_csv"]


def frame_of(array: np.ndarray) -> pd.DataFrame:
    """A pandas frame with a column for each field of a structured array."""
    try:
        import pandas as pd
    except ImportError:
        raise ImportError("a frame needs pandas: install python3-pandas, or use the arrays") from None
    return pd.DataFrame(columns_of(array), copy=False)


def dataset_of(array: np.ndarray, choice: Mapping[str, Union[str, float]]) -> xr.Dataset:
    """A table as an xarray dataset over its axes (axes_of); `choice` selects rows by the values of columns."""
    for name, wanted in choice.items():
        if name not in (array.dtype.names or ()):
            raise ValueError(f"the table has no column {name!r}")
        known, array = array[name], array[array[name] == wanted]
        if not len(array):
            raise ValueError(f"no row has {name} = {wanted!r}; there are {', '.join(map(str, sorted(set(known))))}")
    columns = {name: values for name, values in columns_of(array).items() if name not in choice}
    for name, values in columns.items():
        if values.dtype.kind == "U" and len(set(values)) > 1:
            raise ValueError(f"choose one {name}: {', '.join(sorted(set(values)))}")
    axes, data = axes_of({name: values for name, values in columns.items() if values.dtype.kind != "U"})
    return on_grid(axes, {name: (values, {}) for name, values in data.items()}, {**choice})


def axes_of(columns: dict[str, np.ndarray]) -> tuple[dict[str, np.ndarray], dict[str, np.ndarray]]:
    """The axes of a table and its other columns: the middles of bins, "x_low_m" and "x_high_m"; the coordinates
    "x_m" and "y_m"; else the first column."""
    lows = [name for name in columns if "_low_" in name and name.replace("_low_", "_high_") in columns]
    if lows:
        axes = {name.replace("_low_", "_"): (columns[name] + columns[name.replace("_low_", "_high_")]) / 2
                for name in lows}
        used = {*lows, *(name.replace("_low_", "_high_") for name in lows)}
    else:
        used = {"x_m", "y_m"} & set(columns) or {next(iter(columns))}
        axes = {name: columns[name] for name in sorted(used)}
    return axes, {name: values for name, values in columns.items() if name not in used}


def on_grid(axes: Mapping[str, np.ndarray], data: Mapping[str, tuple[np.ndarray, dict[str, str]]],
            attributes: Mapping[str, object]) -> xr.Dataset:
    """Columns over the grid of their axes; over "point" if two rows have the same place or the grid would have
    more than four times as many cells as there are rows. Cells without a row are NaN."""
    import numpy as np

    try:
        import xarray as xr
    except ImportError:
        raise ImportError("a dataset needs xarray: install python3-xarray, or use frames") from None
    places = {name: np.unique(values, return_inverse=True) for name, values in axes.items()}
    shape = tuple(len(known) for known, _ in places.values())
    rows = len(next(iter(axes.values())))
    cells = np.ravel_multi_index([index for _, index in places.values()], shape) if rows else np.empty(0, int)
    if len(np.unique(cells)) < rows or np.prod(shape) > 4 * rows:
        return xr.Dataset({name: ("point", values, about) for name, (values, about) in data.items()},
                          {name: ("point", values) for name, values in axes.items()}, attributes)
    grids = {}
    for name, (values, about) in data.items():
        words = values.dtype.kind == "U"
        grid = np.full(int(np.prod(shape)), "" if words else np.nan, values.dtype if words else float)
        grid[cells] = values
        grids[name] = (list(axes), grid.reshape(shape), about)
    return xr.Dataset(grids, {name: known for name, (known, _) in places.items()}, attributes)


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


class Tables(Mapping[str, "np.ndarray"]):
    """Tables by their names, each made when it is first used. A session shows the names alone."""

    def __init__(self, made_by: Mapping[str, Callable[[], np.ndarray]]):
        self._made_by = made_by
        self._made: dict[str, np.ndarray] = {}

    @classmethod
    def in_folder(cls, folder: Path) -> Tables:
        """Those of a result folder."""
        return cls({file.stem: partial(read_csv, file) for file in sorted(folder.glob("*.csv"))})

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self._made:
            self._made[name] = self._made_by[name]()
        return self._made[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._made_by)

    def __len__(self) -> int:
        return len(self._made_by)

    def _ipython_key_completions_(self) -> list[str]:
        return list(self)

    def __repr__(self) -> str:
        return f"<Tables {', '.join(self)}>"
