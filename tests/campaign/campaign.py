# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""A campaign in a folder of its own, and queries of its store."""

import os
import pathlib
import shutil
import sqlite3
import subprocess
import sys
import tempfile

SKIPPED = 77

CASE = """
title = "A ball"
[mill]
kind = "vibration"
frequency = "10 Hz"
amplitude = "25 mm"
[jar]
kind = "capsule"
diameter = "12 mm"
volume = "5 ml"
[[balls]]
count = 1
diameter = "8 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.9
tangential_restitution = 0.9
lasting = "tc"
contact_time = "1e-4 s"
[run]
engine = "event"
time = "TIME"
replicates = 2
[sweep]
SWEEP
"""

TIMINGS = ("wall_seconds", "cpu_seconds")


class Campaign:
    """A case in a folder of its own, and the program that runs it."""

    def __init__(self, program, sweep, time="0.5 s"):
        self.program = program
        self.here = pathlib.Path(tempfile.mkdtemp(prefix="mahlwerk-"))
        self.case = self.here / "case.toml"
        self.case.write_text(CASE.replace("TIME", time).replace("SWEEP", sweep))
        self.out = self.here / "out"

    def command(self, *words, out=None):
        return [self.program, "sweep", str(self.case), "--out", str(out or self.out), *words]

    def run(self, *words, out=None, code=0, before=()):
        ended = subprocess.run([*before, *self.command(*words, out=out)], capture_output=True,
                               text=True)
        assert ended.returncode == code, (ended.returncode, ended.stdout, ended.stderr)
        return ended.stdout + ended.stderr

    def part(self, name, *words, out=None, code=0):
        ended = subprocess.run([self.program, "sweep", name, str(out or self.out), *words],
                               capture_output=True, text=True)
        assert ended.returncode == code, (ended.returncode, ended.stdout, ended.stderr)
        return ended.stdout + ended.stderr

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.here, ignore_errors=True)


def asked(folder, question, store="campaign.sqlite"):
    with sqlite3.connect(folder / store) as database:
        return database.execute(question).fetchall()


def numbers(folder):
    """The results of the runs, without their timings."""
    database = sqlite3.connect(folder / "campaign.sqlite")
    cursor = database.execute("SELECT * FROM results")
    names = [column[0] for column in cursor.description]
    return [{name: value for name, value in zip(names, row) if name not in TIMINGS}
            for row in cursor]


def check_sound(folder, store="campaign.sqlite"):
    if not (folder / store).exists():
        return
    assert asked(folder, "PRAGMA integrity_check", store) == [("ok",)]
    if asked(folder, "SELECT name FROM sqlite_master WHERE name = 'runs'", store):
        assert asked(folder, "SELECT max(attempts) FROM runs", store)[0][0] in (None, 0, 1)


def frequencies(n):
    return '"mill.frequency" = { from = "10 Hz", to = "20 Hz", steps = %d }' % n


def in_a_small_room(script):
    """Runs a shell script in its own mount namespace; None if this machine does not allow it."""
    if os.geteuid() != 0 or not shutil.which("unshare"):
        return None
    if subprocess.run(["unshare", "-m", "true"], capture_output=True).returncode != 0:
        return None
    return subprocess.run(["unshare", "-m", "sh", "-c", script], capture_output=True, text=True)


def main(tests):
    """Runs the test of a file that the command line names."""
    program, name = sys.argv[1:]
    return tests[name](program) or 0
