# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The text of a case, its place and the changes to it: what a case is read from."""

from __future__ import annotations

import contextlib
import os
import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Optional, Union

from . import _core, toml
from .changes import cited, merged, plain
from .errors import InputError
from .files import kept, named_folder, read_text, temporary

if TYPE_CHECKING:
    from .changes import Changes, Texts
    from .toml import Value

__all__ = ["CaseSource", "Place"]

Place = Union[str, "os.PathLike[str]"]


def without_section(text: str, name: str) -> str:
    """The text of a case file without a section and those inside it."""
    heading = r"^[ \t]*\[\[?[ \t]*{}[ \t]*\]\]?[ \t]*(?:#[^\n]*)?$"
    begin, other = heading.format(rf"{name}(?:\.[^\n\]]*)?"), heading.format(r"[\w.-]+")
    return re.sub(rf"{begin}.*?(?={other}|\Z)", "", text, flags=re.MULTILINE | re.DOTALL)


@dataclass(frozen=True)
class CaseSource:
    text: str
    file: Path  # files that the case names are relative to its folder
    in_file: bool  # whether the text was read from `file`
    shown: str  # the name of the case in messages
    changes: Texts

    @classmethod
    def of(cls, source: Union[Place, Mapping[str, Value]], changes: Optional[Changes]) -> CaseSource:
        """That of a case file, of a folder with one case, or of a dict of sections."""
        changed = merged({}, changes or {})
        if isinstance(source, Mapping):
            return cls(toml.case_text(source), Path.cwd() / "case", False, "case", changed)
        if not isinstance(source, (str, os.PathLike)):
            hint = "; its case is `.case`" if hasattr(source, "quantities") else ""
            raise TypeError(f"a case is a file, a folder or a dict of sections, not {source!r}{hint}")
        files = _core.case_files(os.fspath(source))
        if len(files) > 1:
            raise InputError([_core.Fault(
                os.fspath(source), f"the folder contains {len(files)} cases, Case takes one",
                "name one of its files", "one-case")])
        file = Path(files[0]).absolute()
        return cls(read_text(file), file, True, os.fspath(files[0]), changed)

    @classmethod
    def of_text(cls, text: str, folder: Optional[Place]) -> CaseSource:
        return cls(text, Path(folder or "").absolute() / "case", False, "case", {})

    def resolved(self) -> _core.ResolvedCase:
        """The case with every value. Faults cite the name that was given."""
        return cited(self.file, self.shown, lambda: _core.read_case(*self.parts()))

    def parts(self) -> tuple[bytes, str, list[tuple[str, Optional[str]]]]:
        """The text, the file and the changes, from which `_core.run` reads the case with other values."""
        return (self.text.encode("utf-8", "surrogateescape"), os.fspath(self.file),
                list(self.changes.items()))

    def changed(self, changes: Changes) -> CaseSource:
        made = merged(self.changes, changes)
        changed_before = {plain(key) for key in self.changes}
        in_text = None
        for key in [key for key, value in made.items() if value is None and plain(key) in changed_before]:
            in_text = in_text if in_text is not None else set(_core.keys_in_text(self.text))
            if plain(key) not in in_text:  # the value came from an earlier change alone
                del made[key]
        return replace(self, changes=made)

    def with_section(self, name: str, content: Changes) -> CaseSource:
        """This source, with a section added to its text."""
        changes = dict(self.changes)
        text = self.text
        if changes.get(name, "") is None:  # it was taken from the case
            text = without_section(text, name)
            del changes[name]
        if re.search(rf"^\s*\[\s*{name}\s*[].]", text, re.MULTILINE):
            raise InputError([_core.Fault(self.shown, f"the case has a [{name}] already",
                                          f'call without it, or take it from the case: case.without("{name}")',
                                          "bad-override")])
        text = text.rstrip("\n") + "\n\n" + toml.section_text(f"[{name}]", content)
        over = content.get("over", content)
        varied = {plain(key) for key in over} if isinstance(over, Mapping) else set()
        changes = {k: v for k, v in changes.items() if plain(k) not in varied}
        return replace(self, text=text, in_file=False, changes=changes)

    def result_folder(self, out: Optional[Place], suffix: str) -> Path:
        """The result folder: `out`, or the one that the command line takes."""
        if out is not None:
            return named_folder(out)
        if not self.in_file:
            raise InputError([_core.Fault(
                "", "no folder is given for the results",
                'give a folder, for instance out="results/name"', "no-folder")])
        file = self.file.resolve()
        name = file.parent.name if file.stem == "case" else file.stem
        return Path("results") / (name + suffix)

    def as_file(self, place: Optional[Path] = None,
                force: bool = False) -> contextlib.AbstractContextManager[str]:
        """Path of a case file with this text, without the changes: `file` itself if that is
        unchanged, a file that stays beside the results in `place`, or a temporary one."""
        if self.in_file and self._unchanged():
            return contextlib.nullcontext(os.fspath(self.file))
        if place is not None:
            return kept(self.text, place.parent / (place.name + ".case.toml"), force)
        return temporary(self.text, self.file, self.shown)

    def as_resolved_file(self, resolved: str) -> contextlib.AbstractContextManager[str]:
        """Path of a case file with the changes in it: a temporary one with the text `resolved`, if
        there are any."""
        if self.in_file and not self.changes and self._unchanged():
            return contextlib.nullcontext(os.fspath(self.file))
        return temporary(resolved, self.file, self.shown)

    def _unchanged(self) -> bool:
        try:
            return read_text(self.file) == self.text
        except InputError:
            return False
