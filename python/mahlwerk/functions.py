# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The commands as functions of a case, a case file, a folder with a case, or a dict of sections."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Optional, TypeVar, Union

from .case import Case
from .case_source import Place

if TYPE_CHECKING:
    from typing_extensions import Concatenate, ParamSpec

    from .toml import Value

    Options = ParamSpec("Options")

__all__ = ["bond_test", "check", "cite", "compare", "evolve_wear", "fit", "match", "new", "optimise", "run", "sweep"]

AnyCase = Union[Case, Place, "Mapping[str, Value]"]
Found = TypeVar("Found")


def as_case(case: AnyCase) -> Case:
    return case if isinstance(case, Case) else Case(case)


def function_of(method: Callable[Concatenate[Case, Options], Found]) -> Callable[
        Concatenate[AnyCase, Options], Found]:
    """The method of Case as a function whose first argument may be whatever a Case is made of."""
    @functools.wraps(method)
    def function(case: AnyCase, *arguments: Options.args, **options: Options.kwargs) -> Found:
        return method(as_case(case), *arguments, **options)

    first, *others = inspect.signature(method).parameters.values()
    first = first.replace(name="case", annotation="Case, file, folder or dict of sections")
    function.__signature__ = inspect.signature(method).replace(parameters=[first, *others])  # type: ignore[attr-defined]
    function.__qualname__, function.__module__ = method.__name__, "mahlwerk"
    return function


bond_test = function_of(Case.bond_test)
check = function_of(Case.check)
cite = function_of(Case.cite)
compare = function_of(Case.compare)
evolve_wear = function_of(Case.evolve_wear)
fit = function_of(Case.fit)
match = function_of(Case.match)
optimise = function_of(Case.optimise)
run = function_of(Case.run)
sweep = function_of(Case.sweep)


def new(*, mill: Optional[str] = None, kind: Optional[str] = None, jar: Optional[str] = None,
        jar_kind: Optional[str] = None, balls: Optional[str] = None) -> Case:
    """A case to start from, as `mahlwerk new`: the same as `Case.new`.

    >>> print(mahlwerk.new(mill="retsch-mm400", jar="retsch-mm-25ml").text)
    """
    return Case.new(mill=mill, kind=kind, jar=jar, jar_kind=jar_kind, balls=balls)
