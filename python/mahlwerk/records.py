# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Collision records as numpy structured arrays."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from . import _core

if TYPE_CHECKING:
    import numpy as np

__all__ = ["array_of_records", "observer", "record_columns"]


def record_columns() -> dict[str, tuple[str, str]]:
    """Unit and meaning of each field of the collision records."""
    return {name: (unit, about) for name, unit, about, _, _ in _core.record_columns()}


def array_of_records(buffer: _core.RecordBuffer) -> np.ndarray:
    """The records as an array that shares their memory and keeps it alive; it cannot be changed."""
    import numpy as np

    columns = _core.record_columns()
    kind = np.dtype({"names": [c[0] for c in columns],
                     "formats": ["<i4" if c[4] else "<f8" for c in columns],
                     "offsets": [c[3] for c in columns], "itemsize": _core.record_size})
    return np.frombuffer(buffer, kind)  # type: ignore[call-overload]


def observer(function: Callable[[np.ndarray, int], object]) -> Callable[[_core.RecordBuffer, int], object]:
    """`function(records, replicate)` as the compiled module calls it."""
    if not callable(function):
        raise TypeError(f"an observer is a function of records and replicate, not {function!r}")
    return lambda buffer, replicate: function(array_of_records(buffer), replicate)
