#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Each call of the operating system that can fail is made to fail, in every command that computes or writes.

  faults_test.py PROGRAM LIBRARY HOME [--package FOLDER] [--points N | --whole] [--only WORK,...] [--kinds KIND,...]
                 [--signals]

LIBRARY is that of inject.cpp. Of the calls of each kind, N are spread over all of them; with --whole each one is,
and 200 of the allocations, but for commands that take long. After each failure: the exit code is one that docs/cli.md lists for it, a message says
what failed and where under a code of docs/errors.md, no incomplete file has its final name, no hidden folder
stays, what was computed is printed or kept, and the same command then gives the result of an undisturbed one.

With --signals SIGINT, SIGTERM and SIGHUP arrive at these calls, from the first one of main() on: the exit code is
130, or 0 with a complete result. SIGKILL, too: the next start removes what is left.
Exits with 77 if the library cannot be preloaded.
"""

import argparse
import csv
import errno
import io
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from works import PythonWork, copied, prepared, works

SKIPPED = 77
# Errors of each kind of call: number, and whether all later calls fail, too.
ERRORS = {
    "open": [(errno.EMFILE, False), (errno.EIO, False), (errno.EMFILE, True)],
    "write": [(errno.ENOSPC, True), (errno.EIO, False)],
    "sync": [(errno.EIO, False), (errno.ENOSPC, True)],
    "rename": [(errno.ENOSPC, False), (errno.EIO, True)],
    "make": [(errno.ENOSPC, True), (errno.EIO, False)],
    "mmap": [(errno.ENOMEM, False), (errno.ENOMEM, True)],
    "malloc": [(errno.ENOMEM, False)],
    "thread": [(errno.EAGAIN, False), (errno.EAGAIN, True)],
}
SIGNALS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL]
SIGNAL_KINDS = ("open", "write", "rename", "malloc")
MOST_ALLOCATIONS = 200
TIMING = re.compile(r'"?(wall_seconds|cpu_seconds|created)"?: *[^,\n}]*')
TIMED_COLUMNS = ("wall_seconds", "cpu_seconds", "cpu_seconds_s", "wall_seconds_s")
STREAMS = ("collisions.h5", "frames-")


class Failed(Exception):
    pass


def codes_of_errors(home):
    return set(re.findall(r"^### (\S+)$", (home / "docs" / "errors.md").read_text(), re.M))


def listing(place):
    """Files and folders below a place, by relative name."""
    found = {}
    for path in sorted(place.rglob("*")):
        found[str(path.relative_to(place))] = path
    return found


def masked(path):
    """What of a file is the same in each run."""
    if path.suffix in (".h5", ".sqlite", ".pdf", ".png"):
        return path.suffix
    text = path.read_bytes().decode("utf-8", "replace")
    if path.suffix == ".csv":
        rows = list(csv.reader(io.StringIO(text)))
        drop = {i for i, head in enumerate(rows[0] if rows else []) if head in TIMED_COLUMNS}
        return [[cell for i, cell in enumerate(row) if i not in drop] for row in rows]
    return TIMING.sub("", text)


class Bench:
    """One work: its undisturbed result, and the checks of disturbed ones."""

    def __init__(self, work, given, here):
        self.work, self.given, self.here = work, given, here
        self.template = prepared(work, given.program, here / "template")
        self.codes = codes_of_errors(given.home)
        self.references, self.calls = {}, {}
        self.before = {name: masked(path) for name, path in listing(self.template).items()
                       if path.is_file()}
        if work.takes_json:
            ended = self.start(copied(self.template, here / "first"), 1, True, {})
            if ended.returncode != 0:
                raise SystemExit(f"{work.name} --json: {ended.returncode}\n{ended.stderr}")
        for jobs in (1, 2):
            first = self.clean_files("first", jobs)
            second = self.clean_files("second", jobs)
            self.references[jobs] = {name: first[name] if first[name] == second.get(name) else None
                                     for name in first}

    def clean_files(self, name, jobs):
        place = copied(self.template, self.here / name)
        log = self.here / "log"
        log.unlink(missing_ok=True)
        ended = self.start(place, jobs, False, {"MAHLWERK_FAULT_LOG": str(log)})
        if ended.returncode != 0:
            raise SystemExit(f"{self.work.name}: {ended.returncode}\n{ended.stdout}{ended.stderr}")
        counts = {}
        for line in log.read_text().splitlines():
            kind, number = line.split()[:2]
            if kind in ERRORS:
                counts[kind] = max(counts.get(kind, 0), int(number))
        self.calls[jobs] = counts
        self.output = ended.stdout
        return {name: masked(path) for name, path in listing(place).items() if path.is_file()}

    def start(self, place, jobs, as_json, more, again=()):
        environment = {**os.environ, "MAHLWERK_PROGRESS_EVERY": "100", **self.work.environment(),
                       "LD_PRELOAD": str(self.given.library), **more}
        command = self.work.command(str(self.given.program), jobs, as_json) + list(again)
        return subprocess.run(command, cwd=place, env=environment, capture_output=True, text=True,
                              errors="replace", timeout=100, stdin=subprocess.DEVNULL)

    def point(self, kind, call, error, stays):
        """Injects one fault; returns a line that says what is wrong, or none."""
        jobs = 2 if kind == "thread" else 1
        as_json = self.work.takes_json and call % 2 == 1
        place = copied(self.template, self.here / "point")
        log = self.here / "log"
        log.unlink(missing_ok=True)
        number = error.value if isinstance(error, signal.Signals) else 0
        fault = (f"{kind}:{call}:signal:{number}" if number else
                 f"{kind}:{call}:{error}" + (":stays" if stays else ""))
        try:
            ended = self.start(place, jobs, as_json,
                               {"MAHLWERK_FAULT": fault, "MAHLWERK_FAULT_LOG": str(log)})
            told = log.read_text() if log.exists() else ""
            where = re.search(r"^fault \S+ \d+ (.*)$", told, re.M)
            if number and where:
                self.check_signal(place, jobs, as_json, ended, number)
            else:
                self.check(place, jobs, as_json, ended, where[1] if where else None,
                           kind == "open" and stays)
        except Failed as why:
            return (f"{self.work.name} {fault} {'json' if as_json else 'text'}"
                    f" at {where[1] if where else '?'}: {why}")
        except subprocess.TimeoutExpired:
            return f"{self.work.name} {fault}: does not end"
        return None

    def check(self, place, jobs, as_json, ended, where, no_descriptors):
        out = ended.stdout + ended.stderr
        if ended.returncode < 0:
            raise Failed(f"killed by signal {-ended.returncode}: {out[-300:]}")
        if ended.returncode not in (0, 2, 3, 4) or "internal error" in out:
            raise Failed(f"exit code {ended.returncode}: {out[-300:]}")
        if "HDF5-DIAG" in out or "terminate called" in out:
            raise Failed("words of a library: " + out[:300])
        self.check_files(place, jobs, ended, no_descriptors)
        if ended.returncode != 0:
            self.check_message(ended, as_json)
            self.check_kept(ended, as_json, where)
            self.check_again(place, jobs, "it is complete in" in out)

    def check_signal(self, place, jobs, as_json, ended, number):
        out = ended.stdout + ended.stderr
        expected = (-number,) if number == signal.SIGKILL else (0, 130)
        if ended.returncode not in expected:
            raise Failed(f"exit code {ended.returncode}: {out[-300:]}")
        if number != signal.SIGKILL:
            for name in listing(place):
                if name.endswith(".part") or any(part.startswith(".") for part in name.split("/")):
                    raise Failed(f"{name} is left")
            if ended.returncode == 130:
                self.check_message(ended, as_json)
        self.check_again(place, jobs, False)

    def check_files(self, place, jobs, ended, no_descriptors):
        """No file is incomplete, none is hidden, unless a message says that a complete result is there, or a
        folder cannot be opened to be removed; after success all are there."""
        reference = self.references[jobs]
        found = listing(place)
        said = ended.stdout + ended.stderr
        for name, path in found.items():
            hidden = [part for part in name.split("/") if part.startswith(".")]
            if hidden:
                if not no_descriptors and hidden[0] not in said:
                    raise Failed(f"hidden {name} is left, and no message names it")
                continue
            if name.endswith((".part", ".aside", ".new")):
                raise Failed(f"{name} is left")
            if not path.is_file() or name in self.before and masked(path) == self.before[name]:
                continue
            if self.is_kept_state(name):
                continue
            if name not in reference:
                raise Failed(f"{name} is left")
            if name.split("/")[-1] in ("campaign.sqlite", "campaign.csv", "campaign.json",
                                       "campaign.html", "mahlwerk-files.txt") and ended.returncode != 0:
                continue  # they grow with the campaign
            self.check_whole(name, path, reference[name])
        if ended.returncode == 0:
            missing = [name for name in reference if name not in found]
            if missing:
                raise Failed(f"exit code 0 without {missing[0]}")

    @staticmethod
    def is_kept_state(name):
        return ".checkpoint" in name or name.endswith((".lock", "-journal", "-wal", "-shm"))

    @staticmethod
    def check_whole(name, path, expected):
        if path.stat().st_size == 0 and not name.endswith(".lock"):
            raise Failed(f"{name} is empty")
        if path.suffix != ".html" and expected is not None and masked(path) != expected:
            raise Failed(f"{name} differs from that of an undisturbed run")
        if path.suffix == ".html" and not path.read_text().rstrip().endswith("</html>"):
            raise Failed(f"{name} has no end")
        if path.suffix == ".json":
            json.loads(path.read_text())

    def check_message(self, ended, as_json):
        if not as_json and not isinstance(self.work, PythonWork):
            if not ended.stderr.strip():
                raise Failed(f"exit code {ended.returncode} without a message")
            return
        lines = [line for line in ended.stderr.splitlines() if line.startswith('{"ended"')]
        if not lines:
            raise Failed("no message in JSON: " + ended.stderr[-300:])
        last = json.loads(lines[-1])
        if last["exit"] != ended.returncode or not last["faults"]:
            raise Failed(f"message {last} with exit code {ended.returncode}")
        for fault in last["faults"]:
            if fault["code"] not in self.codes:
                raise Failed(f"code of no heading of docs/errors.md: {fault}")
            placeless = ("not-enough-memory", "output-lost", "interrupted", "stopped")
            if not fault["what"] or not fault["where"] and fault["code"] not in placeless:
                raise Failed(f"no place or cause: {fault}")
            if not fault["remedy"]:
                raise Failed(f"no remedy: {fault}")

    def check_kept(self, ended, as_json, where):
        """Once files of the result are written, the table is on standard output."""
        name = (where or "").split("/")[-1]
        of_result = ".partial-" in (where or "") and not name.startswith(STREAMS) and any(
            known.split("/")[-1] == name for known in self.references[1])
        if not of_result or not self.work.marks or ended.returncode == 4:
            return
        marks = [mark.replace(" ", "_") if as_json else mark for mark in self.work.marks]
        lost = [mark for mark in marks if mark not in ended.stdout]
        if lost:
            raise Failed(f"what was computed is lost: no {lost[0]} on standard output")

    def check_again(self, place, jobs, complete_elsewhere):
        """The same command, undisturbed, gives the whole result."""
        again = self.start(place, jobs, False, {})
        if again.returncode == 2 and ("result-exists" in again.stderr or
                                      "campaign-exists" in again.stderr):
            again = self.start(place, jobs, False, {}, ["--force"])
        if again.returncode != 0:
            raise Failed(f"the next start ends with {again.returncode}: {again.stderr[-300:]}")
        found = listing(place)
        hidden = [name for name in found if any(part.startswith(".") for part in name.split("/"))]
        if hidden and not complete_elsewhere:
            raise Failed(f"hidden {hidden[0]} is left after the next start")
        for name, expected in self.references[jobs].items():
            if name not in found:
                raise Failed(f"the next start gives no {name}")
            self.check_whole(name, found[name], expected)


def chosen_calls(total, points, kind, whole):
    """The calls that are made to fail: all, or some spread over all."""
    if whole:
        points = min(total, MOST_ALLOCATIONS) if kind == "malloc" else total
    points = min(points, total)
    return sorted({1 + (total - 1) * i // max(1, points - 1) for i in range(points)})


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("library", type=pathlib.Path)
    parser.add_argument("home", type=pathlib.Path)
    parser.add_argument("--package", default="")
    parser.add_argument("--points", type=int, default=4)
    parser.add_argument("--whole", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--kinds", default="")
    parser.add_argument("--signals", action="store_true")
    parser.add_argument("--point", default="", help="one fault, such as write:17:28:stays")
    return parser.parse_args()


def points_of(bench, kind, given):
    """The faults of one kind: call, error, whether it stays."""
    total = bench.calls[2 if kind == "thread" else 1].get(kind, 0)
    errors = [(one, False) for one in SIGNALS] if given.signals else ERRORS[kind]
    most = bench.work.most if given.whole and bench.work.most else None
    calls = chosen_calls(total, most or given.points, kind, given.whole and not most)
    if given.whole and kind != "malloc":
        return [(call, *error) for call in calls for error in errors]
    return [(call, *errors[i % len(errors)]) for i, call in enumerate(calls)]


def try_work(bench, given):
    """Injects the faults of a work. Returns how many there were, and what was wrong."""
    counted, wrong = 0, []
    kinds = given.kinds.split(",") if given.kinds else SIGNAL_KINDS if given.signals else ERRORS
    for kind in kinds:
        points = points_of(bench, kind, given)
        if given.point:
            chosen = given.point.split(":")
            error = signal.Signals(int(chosen[3])) if "signal" in chosen else int(chosen[2])
            points = [(int(chosen[1]), error, chosen[-1] == "stays")] * (chosen[0] == kind)
        for point in points:
            counted += 1
            line = bench.point(kind, *point)
            if line:
                wrong.append(line)
                print(line, flush=True)
    return counted, wrong


def main():
    given = arguments()
    given.program, given.library = given.program.resolve(), given.library.resolve()
    given.package = given.package and str(pathlib.Path(given.package).resolve())
    if not sys.platform.startswith("linux") or not given.library.exists():
        return SKIPPED
    tried, wrong = 0, 0
    begun = time.time()
    here = pathlib.Path(tempfile.mkdtemp(prefix="mahlwerk-faults-"))
    try:
        for work in works(given.home, given.package):
            if given.only and work.name not in given.only.split(","):
                continue
            bench = Bench(work, given, here / work.name)
            counted, bad = try_work(bench, given)
            print(f"{work.name}: {counted} faults, {len(bad)} not answered as they should be "
                  f"({time.time() - begun:.0f} s)", flush=True)
            tried, wrong = tried + counted, wrong + len(bad)
            if not given.point:
                shutil.rmtree(bench.here, ignore_errors=True)
    finally:
        if not given.point:
            shutil.rmtree(here, ignore_errors=True)
    print(f"expected: none of {tried} faults without a right end; found: {wrong}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
