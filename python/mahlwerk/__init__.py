# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Mahlwerk simulates ball mills: it takes a mill, a jar and balls, and computes what their collisions do.

>>> import mahlwerk
>>> case = mahlwerk.Case("examples/01-one-ball")
>>> result = case.run()
>>> result["collision_rate"]
>>> result.plot.spectrum()

A command of the command line is a function: `mahlwerk.run("examples/01-one-ball")`; those of a case are methods of
Case, too.
numpy is loaded with the first table, pandas with the first frame, matplotlib with the first plot, xarray with
the first dataset, uncertainties with the first ufloat.
"""

from __future__ import annotations

import atexit
import os
from collections.abc import Callable
from pathlib import Path
from typing import Union

from . import _core, measure
from .bond import BondTest, LargestBall
from .campaign import Campaign, SweptKey
from .case import Case
from .check import Check, Origin
from .citation import Citation
from .commands import command
from .errors import InputError, Interrupted, MahlwerkError, RunError
from .estimates import Band, Cause, Estimate, estimate
from .folders import ask, export, report, surrogate
from .functions import bond_test, check, cite, compare, evolve_wear, fit, match, new, optimise, run, sweep
from .listings import (CatalogueName, KeyInfo, QuantityInfo, UnitInfo, catalogue, describe, list_keys, list_quantities,
                       list_units)
from .measurement import Finding, Measurement
from .quantities import Influence, Notice, Quantity
from .records import record_columns
from .result import Result
from .searches import Comparison, Fit, Match, Optimum, WearEvolution
from .surrogate import Prediction, Surrogate

_core.set_data_folder(os.fspath(Path(__file__).with_name("data")))  # catalogue, papers, examples
Fault = _core.Fault
atexit.register(_core.stop_all_jobs)  # daemon threads may still compute
__version__: str = _core.version

Opened = Union[Result, Campaign, Fit, Optimum, Match, Comparison, WearEvolution]

__all__ = ["Band", "BondTest", "Campaign", "Case", "CatalogueName", "Cause", "Check", "Citation", "Comparison",
           "Estimate", "Fault", "Finding", "Fit", "Influence", "InputError", "Interrupted", "KeyInfo",
           "LargestBall", "MahlwerkError", "Match", "Measurement", "Notice", "Optimum", "Origin", "Prediction",
           "Quantity", "QuantityInfo", "Result", "RunError", "Surrogate", "SweptKey", "UnitInfo",
           "WearEvolution", "ask", "bond_test", "catalogue", "check", "cite", "command", "compare", "describe",
           "estimate", "evolve_wear", "export", "fit", "list_keys", "list_quantities", "list_units", "match",
           "new", "open", "optimise", "record_columns", "report", "run", "surrogate", "sweep"]


def __dir__() -> list[str]:
    return [*__all__, "__version__", "measure", "papers"]


def open(folder: Union[str, "os.PathLike[str]"]) -> Opened:
    """Opens what a command wrote: a Result, Campaign, Fit, Optimum, Match, Comparison or WearEvolution."""
    place = Path(folder)
    if place.suffix == ".sqlite":
        return Campaign(place)
    kinds: dict[str, Callable[[Path], Opened]] = {
        "summary.json": Result, "campaign.sqlite": Campaign, "fit.json": Fit, "match.json": Match,
        "optimise.json": Optimum, "compare.csv": Comparison, "wear_evolution.json": WearEvolution}
    for file, kind in kinds.items():
        if (place / file).is_file():
            return kind(place)
    what = "holds no result" if place.is_dir() else "is not a folder"
    raise InputError([Fault(os.fspath(folder), what,
                            "give a folder that a command of Mahlwerk wrote", "no-result")])
