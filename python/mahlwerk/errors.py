# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Exceptions. Their texts, codes and places are those of the command line."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional, Union

if TYPE_CHECKING:
    from ._core import Fault
    from .campaign import Campaign
    from .result import Result
    from .searches import WearEvolution

    Kept = Union[Result, Campaign, WearEvolution]

__all__ = ["MahlwerkError", "InputError", "RunError", "Interrupted"]


class MahlwerkError(Exception):
    """Base of InputError and RunError."""


class InputError(MahlwerkError, ValueError):
    """Invalid input. `faults` lists every fault: where it is, what it is, the remedy, and its code,
    which is a heading on the documentation's page of errors. `result` holds the result of a run whose
    files could not be written, or is None."""

    def __init__(self, faults: list[Fault], result: Optional[Kept] = None):
        super().__init__(faults)
        self.faults = faults
        self.result = result

    def __str__(self) -> str:
        from ._core import describe_faults

        return describe_faults(self.faults)


class RunError(MahlwerkError, RuntimeError):
    """Physics stopped a run. `result` holds what was computed until then, or is None."""

    def __init__(self, what: str, result: Optional[Kept] = None):
        super().__init__(what)
        self.result = result


class Interrupted(KeyboardInterrupt):
    """Ctrl-C ended the work. `result` holds what was computed until then, or is None. In an
    interactive session it is `sys.last_value.result`."""

    def __init__(self, what: str, result: Optional[Kept] = None):
        super().__init__(what)
        self.result = result
