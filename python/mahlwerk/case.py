# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Cases: a mill, its jar, balls and settings, and the commands as their methods."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Optional, Union

from . import _core
from .case_source import Place
from .case_values import CaseValues
from .changes import checked_threads, merged
from .check import Check
from .commands import command
from .errors import InputError, Interrupted, RunError
from .files import measurements, named_folder
from .progress import Progress, shown
from .records import observer

if TYPE_CHECKING:
    import numpy as np
    import pandas as pd

    from .bond import BondTest
    from .campaign import Campaign
    from .changes import Changes
    from .citation import Citation
    from .result import Result
    from .searches import Comparison, Fit, Match, Optimum, WearEvolution

    #: A function of collision records and the number of the replicate.
    Observer = Callable[[np.ndarray, int], object]
    #: A CSV file, a data frame, or a dict of columns.
    Measurements = Union[Place, pd.DataFrame, Mapping[str, Iterable[object]]]

__all__ = ["Case"]


class Case(CaseValues):
    """A complete and valid case.

    `source` is a case file, a folder with a case.toml, or a dict of sections as in a case file:

    >>> case = mahlwerk.Case({"mill": {"model": "retsch-mm400", "frequency": "30 Hz"},
    ...                       "jar": {"model": "retsch-mm-25ml"},
    ...                       "balls": [{"count": 2, "diameter": "12 mm", "material": "steel-304"}],
    ...                       "contact": {"friction": 0.3},
    ...                       "run": {"time": "1 s"}})
    >>> case["mill.frequency"] = "25 Hz"
    >>> del case["contact.friction"]  # its default counts

    A number with a dimension is a text with its unit ("30 Hz"). `changes` replaces values, as --set
    does on the command line; None takes a value, or a whole section, from the case. Files that the case
    names are relative to its folder, or to the current folder for a dict. Raises InputError with all
    faults; a change that is refused changes nothing.
    """

    @classmethod
    def new(cls, *, mill: Optional[str] = None, kind: Optional[str] = None,
            jar: Optional[str] = None, jar_kind: Optional[str] = None,
            balls: Optional[str] = None) -> Case:
        """A case to start from, as `mahlwerk new` writes it: a `mill` of the catalogue or a `kind` of
        mill, a `jar` of the catalogue or a `jar_kind`, and a ball set of the catalogue. Its text says
        in comments what each key is, and marks assumed values."""
        import tempfile

        if (mill and kind) or (jar and jar_kind):
            raise ValueError("give mill or kind, and jar or jar_kind, not both")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "case.toml"
            command(["new"], file=os.fspath(file), mill=mill, kind=kind, jar=jar,
                    jar_kind=jar_kind, balls=balls)
            return cls.from_text(file.read_text(encoding="utf-8"))

    def check(self) -> Check:
        """What follows from the case, as `mahlwerk check`. Raises InputError if no engine can run it."""
        from .quantities import Quantity

        with self._source.as_file() as target:
            said = command(["check"], case=target, set=self._source.changes,
                           refusal_is_result=True)[0]
            if not said["runs"]:
                raise InputError([_core.Fault(**fault) for fault in said["faults"]])
        return Check({name: Quantity(name, q["value"], None, q["unit"], q["about"])
                      for name, q in said["follows"].items()}, said["notes"],
                     [one for one in self.origins if one.assumed])

    def cite(self) -> Citation:
        """Methods paragraph and references of the models that a run would use, as `mahlwerk cite`."""
        from .citation import Citation

        with self._source.as_file() as target:
            return Citation.of(command(["cite"], case=target, set=self._source.changes))

    def run(self, out: Optional[Place] = None, *, force: bool = False, threads: int = 0,
            collisions: Optional[bool] = None,
            observers: Union[Observer, Iterable[Observer]] = (),
            checkpoint: Optional[float] = None, resume: bool = False, progress: Progress = None) -> Result:
        """Runs the case, as `mahlwerk run`: the same bits on any number of threads.

        out         result folder to write, as the command line does; None: results are in memory
        force       replaces an existing result
        threads     0: all cores
        collisions  keeps every collision record in memory (136 bytes each); None: if the case has
                    [observe] collisions and there is no folder
        observers   one or several functions `f(records, replicate)` that get every counted collision in
                    chunks, a numpy structured array of at least 8192 records but for the last;
                    `replicate` counts from 1. Replicates may run side by side, so that calls for
                    different replicates alternate. An exception ends the run
        resume      goes on with a run into `out` that was interrupted, or begins it: the same call again
                    and again reaches the end, with the bits of a run without a pause. A case built
                    in Python stays beside the folder, as OUT.case.toml
        checkpoint  seconds of computing between two saves of the state that `resume` needs; 60 with resume
        progress    None: in notebooks and on terminals; True, False; or a function
                    `f(share, line)`

        Raises InputError; RunError if physics stopped a replicate; Interrupted after Ctrl-C. They hold
        what was computed in `result`: InputError if the files of the result could not be written.
        """
        from .result import Result

        if resume or checkpoint is not None:
            if collisions or observers:
                raise ValueError("a run with collisions in memory or observers cannot be resumed")
            return self._run_with_checkpoints(out, force, threads, 60.0 if checkpoint is None else checkpoint, resume,
                                              progress)
        if collisions is None:
            collisions = out is None and self._value("observe.collisions") == "true"
        folder = None if out is None else named_folder(out)
        called = [observer(one) for one in ([observers] if callable(observers) else observers)]
        with shown(progress) as show:
            ran, interrupted, unwritten = _core.run(
                self._resolved, self._source.parts(), folder, force, checked_threads(threads),
                bool(collisions), called, show)
        result = Result.of_run(ran, None if unwritten else folder, self._source.file.parent)
        if unwritten:
            raise InputError(unwritten, result)
        if ran.failure:
            raise RunError(ran.failure, result)
        if interrupted:
            raise Interrupted("interrupted: results computed until then are in `result`", result)
        return result

    def _run_with_checkpoints(self, out: Optional[Place], force: bool, threads: int, checkpoint: float, resume: bool,
                              progress: Progress) -> Result:
        """A run whose state is beside its folder until it is complete."""
        from .result import Result

        place = self._source.result_folder(out, "")
        kept = place.with_name(place.name + ".checkpoint").exists()
        try:
            with self._source.as_file(place, force) as target:  # the state belongs to a file of this name
                command(["run"], case=target, set=self._titled(), out=place, force=force,
                        threads=checked_threads(threads), checkpoint=checkpoint, resume=resume and kept,
                        progress=progress)
        except (Interrupted, RunError) as error:
            if (place / "summary.json").exists():
                error.result = Result(place)
            raise
        return Result(place)

    def sweep(self, over: Optional[Changes] = None, out: Optional[Place] = None, *,
              force: bool = False, threads: int = 0, films: bool = False,
              checkpoint: Optional[float] = None, progress: Progress = None) -> Campaign:
        """Runs the campaign of the case's [sweep], or over the values in `over`, as `mahlwerk sweep`:
        `case.sweep({"mill.speed": ["300 rpm", "400 rpm"]})`. `over` takes what [sweep] takes. A second
        call with the same folder runs only what is missing. `films`: the paths of the balls are kept in
        film.json of each run (docs/formats.md). `checkpoint`: seconds between two saves of a run's state,
        60 by default. Ctrl-C raises Interrupted; its `result`
        is the campaign so far."""
        from .campaign import Campaign

        case = self._with_section("sweep", over)
        place = self._source.result_folder(out, "")
        try:
            with case._source.as_file(place, force) as target:
                command(["sweep"], case=target, set=case._titled(), out=place, force=force,
                        threads=threads, films=films, checkpoint=checkpoint, progress=progress)
        except (Interrupted, RunError) as error:
            if (place / "campaign.sqlite").exists():
                error.result = Campaign(place)
                error.args = ("\n".join([str(error), *(f"point {i}: {why}" for i, why in error.result.failed[:5])]),)
            raise
        return Campaign(place)

    @classmethod
    def fit_file(cls, file: Place, data: Measurements, out: Place, changes: Optional[Changes] = None, *,
                 force: bool = False, threads: int = 0, progress: Progress = None) -> Fit:
        """Fits a case file whose fitted keys have no values yet, which is no complete Case."""
        from .searches import Fit

        texts = merged({}, changes or {})
        with measurements(data) as table:
            command(["fit"], case=os.fspath(file), data=table, set=texts, out=Path(out), force=force,
                    threads=threads, progress=progress)
        return Fit(out)

    def fit(self, data: Measurements, out: Optional[Place] = None, *, over: Optional[Changes] = None,
            force: bool = False, threads: int = 0, progress: Progress = None) -> Fit:
        """Fits the parameters in [fit] to measurements, as `mahlwerk fit`. `data` is a CSV file, a data frame or a
        dict of columns: {"time (s)": [30, 60], "D90 (um)": [905, 640]}. `over` is [fit], if the case has none: each
        key with the ends of its range, {"breakage.f_mat": ["0.01 kg/J/m", "100 kg/J/m"]}."""
        from .searches import Fit

        case = self._with_section("fit", over)
        place = self._source.result_folder(out, "-fit")
        with case._source.as_file() as target, measurements(data) as table:
            command(["fit"], case=target, data=table, set=case._titled(), out=place, force=force,
                    threads=threads, progress=progress)
        return Fit(place)

    def optimise(self, settings: Optional[Changes] = None, out: Optional[Place] = None, *,
                 force: bool = False, threads: int = 0, progress: Progress = None) -> Optimum:
        """Searches the best settings by [optimise], as `mahlwerk optimise`. `settings` is that section
        as a dict, if the case has none."""
        from .searches import Optimum

        case = self._with_section("optimise", settings)
        place = self._source.result_folder(out, "-optimise")
        with case._source.as_file() as target:
            command(["optimise"], case=target, set=case._titled(), out=place, force=force,
                    threads=threads, progress=progress)
        return Optimum(place)

    def match(self, like: Union[Case, Place], settings: Optional[Changes] = None, out: Optional[Place] = None, *,
              force: bool = False, threads: int = 0, progress: Progress = None) -> Match:
        """Searches settings of this mill that do what the mill of `like` does, by [match], as
        `mahlwerk match LIKE --in THIS`. `like` is a case, or its file or folder."""
        from .searches import Match

        like = like if isinstance(like, Case) else Case(like)
        case = self._with_section("match", settings)
        place = self._source.result_folder(out, "-match")
        with like._source.as_resolved_file(like.text) as target, case._source.as_file() as data:
            command(["match"], case=target, in_=data, set=case._titled(), out=place,
                    force=force, threads=threads, progress=progress)
        return Match(place)

    def compare(self, out: Optional[Place] = None, *, force: bool = False, threads: int = 0,
                progress: Progress = None) -> Comparison:
        """Runs the case with both engines, as `mahlwerk compare`."""
        from .searches import Comparison

        place = self._source.result_folder(out, "-compare")
        with self._source.as_file() as target:
            command(["compare"], case=target, set=self._titled(), out=place, force=force,
                    threads=threads, progress=progress)
        return Comparison(place)

    def evolve_wear(self, out: Optional[Place] = None, *, force: bool = False, threads: int = 0,
                    progress: Progress = None) -> WearEvolution:
        """Follows shapes and ball sizes over the time [wear] evolve, as `mahlwerk run` does for such a case. A
        second call with the same folder runs only the stages that are missing. Ctrl-C raises Interrupted;
        its `result` is the evolution so far."""
        from .searches import WearEvolution

        if self._value("wear.evolve") is None:
            raise InputError([_core.Fault("wear.evolve", "the case gives no time of operation",
                                          'write for instance evolve = "500 h" in [wear]', "no-wear-evolution")])
        place = self._source.result_folder(out, "")
        try:
            with self._source.as_file() as target:
                command(["run"], case=target, set=self._titled(), out=place, force=force, threads=threads,
                        progress=progress)
        except (Interrupted, RunError) as error:
            if (place / WearEvolution.numbers).exists():
                error.result = WearEvolution(place)
            raise
        return WearEvolution(place)

    def bond_test(self, *, screen: str = "150 um", load: str = "250 %", mill_diameter: Optional[str] = None,
                  mill_speed: str = "72 %", threads: int = 0, progress: Progress = None) -> BondTest:
        """Bond's grindability test in locked cycles, as `mahlwerk bond-test`: the case is a drum with a rock that
        breaks.

        screen         opening of the closing screen, 10 um to 5 mm
        load           circulating load, 10 % to 1000 %
        mill_diameter  of a full-scale mill, 10 cm to 20 m, whose largest ball is wanted
        mill_speed     of that mill, share of its critical speed, 10 % to 99 %

        Raises InputError; RunError if physics stopped a replicate.
        """
        from .bond import BondTest

        with self._source.as_file() as target:
            told = command(["bond-test"], case=target, set=self._titled(), screen=screen, load=load,
                           mill_diameter=mill_diameter, mill_speed=mill_speed, threads=checked_threads(threads),
                           progress=progress)
        return BondTest(told, int(self._value("run.replicates") or 0))
