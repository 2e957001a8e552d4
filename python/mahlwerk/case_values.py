# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The values of a case: read, changed, written."""

from __future__ import annotations

import html
import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Optional, Union

from . import _core, toml
from .case_source import CaseSource, Place
from .check import Origin
from .pages import table_html
from .public import Public

if TYPE_CHECKING:
    from typing_extensions import Self

    from .changes import Changes, Texts
    from .toml import Value

__all__ = ["CaseValues"]


class CaseValues(Public):
    """A complete and valid case, without what it can do."""

    def __init__(self, source: Union[Place, Mapping[str, Value]], changes: Optional[Changes] = None):
        self._set(CaseSource.of(source, changes))

    @classmethod
    def from_text(cls, text: str, folder: Optional[Place] = None) -> Self:
        """A case from the text of a case file; files that it names are relative to `folder`."""
        return cls._of(CaseSource.of_text(text, folder))

    @classmethod
    def _of(cls, source: CaseSource) -> Self:
        made = cls.__new__(cls)
        made._set(source)
        return made

    def _set(self, source: CaseSource) -> None:
        self._resolved = source.resolved()
        self._source = source

    def replace(self, changes: Changes) -> Self:
        """A copy with other values, for instance `case.replace({"mill.speed": "500 rpm"})`; None takes a
        value from the case."""
        return self._of(self._source.changed(changes))

    def without(self, *keys: str) -> Self:
        """A copy without these values or sections, for instance `case.without("powder.mass")`, as --unset
        does on the command line. Raises InputError for a key that the case does not give."""
        return self.replace(dict.fromkeys(keys))

    def update(self, changes: Changes) -> None:
        """Changes several values together."""
        self._set(self._source.changed(changes))

    def __setitem__(self, key: str, value: Optional[Value]) -> None:
        self.update({key: value})

    def __delitem__(self, key: str) -> None:
        """Takes a value or a whole section from the case: `del case["powder.mass"]`."""
        self.update({key: None})

    def __getitem__(self, key: str) -> str:
        """The value of a key as text with its unit, also a default: `case["mill.speed"]`. Notebooks
        complete the keys."""
        return self.origin(key).value

    def origin(self, key: str) -> Origin:
        """The value of a key and its source. Raises KeyError for a key without value."""
        if not isinstance(key, str):
            raise TypeError(f"a key is a text, for instance \"mill.speed\", not {key!r}")
        known = {one.key: one for one in self.origins}
        for name in (key, key.replace("balls.", "balls.1.", 1)):
            if name in known:
                return known[name]
        inside = [name for name in known if name.startswith(f"{key}.")]
        if inside:
            raise KeyError(f"{key} is a section: ask for one of {', '.join(inside)}")
        import difflib

        near = difflib.get_close_matches(key, known, n=1)
        raise KeyError(f"the case has no {key}" + (f"; did you mean {near[0]}?" if near else ""))

    @property
    def origins(self) -> list[Origin]:
        """Every value of the case with its source."""
        return [Origin(*one) for one in self._resolved.origins()]

    @property
    def title(self) -> str:
        return self._resolved.title

    @property
    def file(self) -> Optional[Path]:
        """The case file, or None for a case built in Python."""
        return self._source.file if self._source.in_file else None

    @property
    def text(self) -> str:
        """The resolved case as TOML: every value, followed by its source as a comment."""
        return self._resolved.write()

    def _ipython_key_completions_(self) -> list[str]:
        return [key for key, *_ in _core.keys()]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, CaseValues) and self._resolved == other._resolved

    __hash__ = None  # type: ignore[assignment]
    __iter__ = None  # a case is no sequence

    def __reduce__(self) -> tuple[Callable[[CaseSource], Self], tuple[CaseSource]]:
        return self._of, (self._source,)

    def __repr__(self) -> str:
        return f"<Case {self.title!r}{f' from {self.file}' if self.file else ''}>"

    def _repr_html_(self) -> str:
        rows = [(one.key, one.value, one.source) for one in self.origins]
        return f"<b>{html.escape(self.title)}</b>" + table_html(("key", "value", "source"), rows)

    def save(self, file: Place, *, force: bool = False) -> None:
        """Writes the resolved case as a case file. Raises FileExistsError unless `force`. In another
        folder than that of this case, files that it names are given by their whole paths."""
        text = self._text_for(Path(file).absolute().parent)
        with open(file, "w" if force else "x", encoding="utf-8") as out:
            out.write(text)

    def _text_for(self, folder: Path) -> str:
        """The resolved case for a file in `folder`."""
        own = self._source.file.parent
        if folder.resolve() == own.resolve():
            return self.text
        values = {key: self._value(key) for key in ("mill.file", "jar.file", "run.start_from")}
        whole = {key: os.fspath(own / toml.text_of(value)) for key, value in values.items() if value}
        return self.replace(whole).text if whole else self.text

    def _with_section(self, name: str, content: Optional[Changes]) -> Self:
        return self if content is None else self._of(self._source.with_section(name, content))

    def _value(self, key: str) -> Optional[str]:
        return next((one.value for one in self.origins if one.key == key), None)

    def _titled(self) -> Texts:
        """The changes, with the title of a case that has none: else the name of a file would be it."""
        changes = self._source.changes
        given = next((one for one in self.origins if one.key == "title"), None)
        if self._source.in_file or "title" in changes or (given and not given.source.startswith("d")):
            return changes
        return {**changes, "title": self.title}
