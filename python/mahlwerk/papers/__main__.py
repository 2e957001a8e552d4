# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""`mahlwerk papers`: runs papers and sets of measured data. The program calls this module."""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
from pathlib import Path
from typing import Any, Optional

from .. import _core
from ..errors import InputError, Interrupted
from .overview import Row, overview_csv, overview_markdown, overview_page, rows_of, score
from .page import PaperResult, checks_text, paper_data
from .paper import Paper, read_paper
from .runs import PaperJob, Settings, write_file

SUCCESS, BAD_INPUT, STOPPED, INTERRUPTED = 0, 2, 3, 130
OWN, MEASURED = "papers", "validation"
RESUME = "finished runs are kept; run the same command again to resume"


def arguments(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="mahlwerk papers")
    parser.add_argument("paper", nargs="?", default="", metavar="PAPER")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE")
    parser.add_argument("--unset", action="append", default=[], metavar="KEY")
    parser.add_argument("--seed")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--leave-out", action="append", default=[], metavar="CAMPAIGN")
    parser.add_argument("--out", type=Path)
    parser.add_argument("--force", action="store_true")
    parser.add_argument("--jobs", "--threads", type=int, default=0, dest="threads")
    parser.add_argument("--checkpoint", type=float)
    parser.add_argument("--quiet", action="store_true")
    parser.add_argument("--json", action="store_true")
    return parser.parse_args(words)


def changes(given: argparse.Namespace) -> dict[str, Optional[str]]:
    made: dict[str, Optional[str]] = dict.fromkeys(given.unset)
    made.update(one.split("=", 1) for one in given.set)
    if given.seed is not None:
        made["seed"] = given.seed
    return made


# Folders


def holds_paper(folder: Path) -> bool:
    return (folder / "paper.py").is_file()


def results_of(place: Path) -> Path:
    whole = place.resolve()
    return Path("results") / (MEASURED if whole.parent.name == MEASURED else OWN) / whole.name


def refused(where: str, what: str, remedy: str) -> InputError:
    return InputError([_core.Fault(where, what, remedy, "no-such-paper")])


def folders(target: str) -> list[Path]:
    """The folders that `target` names by path or name: one of papers/ or validation/, all of
    validation/ ("validation"), or all of papers/ (empty)."""
    if target in ("", MEASURED):
        home = Path(_core.data_folder(target or OWN))
        found = sorted(place for place in home.iterdir() if holds_paper(place))
        if not found:
            raise refused(os.fspath(home), "there is no paper", "name a folder with a paper.py")
        return found
    places = [Path(target), *(Path(_core.data_folder(home)) / target for home in (OWN, MEASURED))]
    for place in places:
        if holds_paper(place):
            return [place]
    raise refused(target, "there is no paper with this name, and no folder with a paper.py",
                  "the names are those of the folders in papers/ and validation/; \"validation\" means all "
                  "of the latter")


def jobs(given: argparse.Namespace) -> list[PaperJob]:
    """The papers that are asked for. --quick leaves out those that take long."""
    places = folders(given.paper)
    papers: list[tuple[Path, Paper]] = [(place, read_paper(place / "paper.py")) for place in places]
    chosen = [(place, paper) for place, paper in papers if paper.quick or not given.quick]
    if not chosen:
        raise refused(given.paper, "--quick leaves out all of these papers", "leave out --quick")
    settings = Settings(changes(given), given.force, given.threads,
                        False if given.quiet or given.json else None, tuple(given.leave_out), given.checkpoint)
    made = []
    for place, paper in chosen:
        out = given.out or results_of(place)
        if given.out and len(places) > 1:
            out = given.out / results_of(place).name
        made.append(PaperJob(place, out, settings, paper))
    return made


# Output


def print_summary(job: PaperJob, result: PaperResult, seconds: float) -> None:
    print(f"{job.paper.title}\n{job.paper.source}\n\n{checks_text(result)}")
    print(f"page:     {job.out / 'paper.html'}\nfigures:  {job.out / 'figures'}")
    if result.tables:
        print(f"tables:   {job.out / 'tables'}")
    print(f"claims:   {job.out / 'claims.csv'}\n\ndone in {_core.two_digits(seconds)} s", flush=True)


def write_overview(given: argparse.Namespace, rows: list[Row]) -> None:
    folder = (given.out or Path("results") / MEASURED) / "overview"
    for name, text in (("validation.md", overview_markdown(rows)), ("validation.csv", overview_csv(rows)),
                       ("validation.html", overview_page(rows))):
        write_file(folder / name, text.encode())
    if not given.quiet and not given.json:
        print(f"{score(rows)}\noverview: {folder / 'validation.html'}")


def work(given: argparse.Namespace) -> int:
    """Runs the papers that are asked for, one after the other. Returns the exit code."""
    code, rows, told = SUCCESS, [], []
    for job in jobs(given):
        began = time.monotonic()
        result, failed = job.run()
        rows += rows_of(result, job.out.resolve().name)
        if given.json:
            told.append({**paper_data(result), "results": os.fspath(job.out)})
        elif not given.quiet:
            print_summary(job, result, time.monotonic() - began)
        if failed is not None:
            code = _core.report_end(STOPPED, str(failed), [_core.Fault("", str(failed), "", "runs-failed")],
                                    given.json)
    if given.paper == MEASURED:
        write_overview(given, rows)
    if given.json:
        print(json.dumps(told, indent=2, ensure_ascii=False))
    return code


def main(words: Optional[list[str]] = None) -> int:
    given = arguments(sys.argv[1:] if words is None else words)

    def ended(code: int, text: str, faults: list[Any]) -> int:
        return int(_core.report_end(code, text, faults, given.json))
    try:
        return work(given)
    except InputError as error:
        return ended(BAD_INPUT, _core.describe_faults(error.faults), error.faults)
    except BrokenPipeError:  # who read the output has enough
        sys.stdout = open(os.devnull, "w", encoding="utf-8")
        return SUCCESS
    except (Interrupted, KeyboardInterrupt):
        if given.quiet and not given.json:
            return INTERRUPTED
        return ended(INTERRUPTED, f"interrupted: {RESUME}",
                     [_core.Fault("", "interrupted", RESUME, "interrupted")])


if __name__ == "__main__":
    sys.exit(main())
