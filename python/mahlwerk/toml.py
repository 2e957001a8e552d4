# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""TOML text of values and nested dicts, for cases that are built in Python."""

from __future__ import annotations

import json
import math
import numbers
import os
import re
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Union

if TYPE_CHECKING:
    import numpy as np

    #: A value of a case: "30 Hz", 3, True, a list of values or a dict of them.
    Value = Union[str, os.PathLike[str], bool, int, float, np.generic, np.ndarray, Sequence["Value"], Mapping[str, "Value"]]

__all__ = ["case_text", "value_text"]


def key_text(key: str) -> str:
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else json.dumps(key, ensure_ascii=False)


def value_text(value: Any) -> str:
    """A value as it is written in a case file. Raises TypeError for a type that TOML lacks."""
    if hasattr(value, "item") and not isinstance(value, (str, bytes)):
        value = value.item() if getattr(value, "ndim", 0) == 0 else value.tolist()
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        number = float(value)
        if math.isinf(number):
            return "inf" if number > 0 else "-inf"
        return "nan" if math.isnan(number) else repr(number)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{key_text(k)} = {value_text(v)}" for k, v in value.items()) + " }"
    if isinstance(value, Sequence) and not isinstance(value, (bytes, bytearray)):
        return "[" + ", ".join(value_text(v) for v in value) + "]"
    raise TypeError(f"a case cannot hold a value of type {type(value).__name__}: {value!r}")


def text_of(quoted: str) -> str:
    """What a quoted text of a resolved case says."""
    return str(json.loads(quoted))


def change_text(value: Any) -> str:
    """A value as `--set key=value` takes it: strings without quotes."""
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    return value_text(value)


def is_table_list(value: Any) -> bool:
    return (isinstance(value, Sequence) and not isinstance(value, (str, bytes)) and len(value) > 0
            and all(isinstance(one, Mapping) for one in value))


def case_text(content: Mapping[str, Any]) -> str:
    """The text of a case: plain values first, then a section for each dict, and one for each dict of
    a list of dicts ([[balls]])."""
    plain, sections = [], []
    for key, value in content.items():
        if isinstance(value, Mapping):
            sections.append(section_text(f"[{key_text(key)}]", value))
        elif is_table_list(value):
            sections += [section_text(f"[[{key_text(key)}]]", one) for one in value]
        else:
            plain.append(f"{key_text(key)} = {value_text(value)}\n")
    return "\n".join(["".join(plain), *sections]).lstrip("\n")


def section_text(heading: str, content: Mapping[str, Any]) -> str:
    return heading + "\n" + "".join(f"{key_text(k)} = {value_text(v)}\n" for k, v in content.items())
