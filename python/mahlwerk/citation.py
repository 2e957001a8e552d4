# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""What a publication cites that used a run."""

from __future__ import annotations

import html
from typing import Any, NamedTuple

__all__ = ["Citation"]


class Citation(NamedTuple):
    """Methods paragraph and references of a run; print() shows both."""

    text: str  #: the paragraph and the numbered references
    bibtex: str  #: the references as entries of BibTeX
    models: dict[str, list[str]]  #: "contact law (jkr)" -> keys of its references

    @classmethod
    def of(cls, told: dict[str, Any]) -> Citation:
        """From what `mahlwerk cite --json` prints."""
        return cls(told["text"], told["bibtex"],
                   {f"{one['subject']} ({one['model']})": one["references"] for one in told["models"]})

    def __str__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        return "".join(f"<p>{html.escape(line)}</p>" for line in self.text.splitlines() if line)
