# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The commands that work on what others wrote: folders of results, files of surrogates."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Optional, Union

from . import _core
from .campaign import Campaign
from .case_source import Place
from .commands import command
from .errors import InputError
from .result import Result
from .searches import Found
from .surrogate import Prediction, Surrogate

if TYPE_CHECKING:
    from .toml import Value

    #: A folder that a command wrote, or what was opened from it.
    AnyFolder = Union[Place, Result, Campaign, Found]

__all__ = ["ask", "export", "report", "surrogate"]


def folder_of(opened: AnyFolder) -> str:
    """Its path. Raises InputError for a result in memory."""
    if not isinstance(opened, (Result, Campaign, Found)):
        return os.fspath(opened)
    if opened.folder is None:
        raise InputError([_core.Fault("", "the result is in memory and has no folder",
                                      'save it first: result.save("results/name")', "no-folder")])
    return os.fspath(opened.folder)


def report(folder: AnyFolder) -> Path:
    """Makes the page of a run, campaign or search anew, in the form of this version, as `mahlwerk report`.
    Returns its path. Raises InputError.

    >>> mahlwerk.report(campaign)
    """
    return Path(command(["report"], folder=folder_of(folder))["report"])


def export(folder: AnyFolder, out: Optional[Place] = None, *, authors: Union[str, Iterable[str]] = (),
           license: str = "", force: bool = False) -> Path:
    """Describes the result of a run as an RO-Crate, as `mahlwerk export`. Returns the path of the description.

    >>> mahlwerk.export(campaign[0], authors="Ada Lovelace, 0000-0002-1825-0097", license="CC-BY-4.0")

    folder   result folder of a run, or its Result
    out      a folder for a copy of the result with its description; None: the description comes into `folder`
    authors  "NAME" or "NAME, ORCID", one or several
    license  of the data: an identifier of SPDX or an address
    force    replaces an existing description or copy

    Raises InputError.
    """
    names = [authors] if isinstance(authors, str) else list(authors)
    return Path(command(["export"], folder=folder_of(folder), out=out, author=names, license=license,
                        force=force)["record"])


def surrogate(campaign: AnyFolder, out: Place, quantities: Iterable[str] = (), *, force: bool = False) -> Surrogate:
    """Writes the file `out` with the results between the settings of a campaign, as `mahlwerk surrogate`, and opens
    it: the same as `Campaign.surrogate`.

    >>> mill = mahlwerk.surrogate(campaign, "mill.json", ["dissipated_power"])
    """
    opened = campaign if isinstance(campaign, Campaign) else Campaign(folder_of(campaign))
    return opened.surrogate(out, quantities, force=force)


def ask(file: Place, setting: Mapping[str, Value], quantities: Iterable[str] = ()) -> dict[str, Prediction]:
    """The quantities (default: all) at a setting, from the file of a surrogate, as `mahlwerk ask`. For several
    settings open the file once: `mahlwerk.Surrogate(file)`. Raises InputError outside the range of the campaign.
    """
    return Surrogate(file)(setting, quantities)
