# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""What dir() and completions show."""

from __future__ import annotations

__all__ = ["Public"]


class Public:
    """Base of classes of which dir() shows the public names alone."""

    def __dir__(self) -> list[str]:
        return [name for name in object.__dir__(self) if not name.startswith("_")]
