#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""What is kept of interrupted runs and fits, and of results whose files cannot be written.

  kept_test.py PROGRAM HOME TEST    exits with 77 if the test cannot run on this machine
"""

import json
import os
import pathlib
import re
import resource
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time

from faults_test import SKIPPED, masked
from works import BALL

TABLES = ("timeseries.csv", "replicates.csv", "spectrum.csv", "speeds.csv")
LONG = BALL.replace('"0.3 s"', '"3000 s"')
ENDLESS = BALL.replace('"0.3 s"', '"1e6 s"')
POWDER = """
[powder]
material = "quartz"
mass = "0.15 g"
distribution = "sieves"
passing = [["0.2 mm", "0 %"], ["0.3 mm", "100 %"]]
[capture]
model = "barrios"
energy_share = 0.3
[breakage]
model = "tavares"
sigma = 0.5
gamma = 5
a = 0.5
b = 0.03
[fragments]
model = "t10"
[grinding]
time = "10 min"
smallest = "60 um"
[fit]
"breakage.gamma" = [1, 15]
"""
STEEL = 'material = "steel-1.4034"'
GROUND = BALL.replace('density = "7850 kg/m3"', STEEL).replace(
    'volume = "5 ml"', 'volume = "5 ml"\n' + STEEL) + POWDER
SIEVES = "time (s), D50 (um), D50_error (um)\n60, 180, 10\n300, 120, 10\n600, 90, 10\n"


class Place:
    """A folder with a case, in which the program is started."""

    def __init__(self, program, **files):
        self.program = program
        self.here = pathlib.Path(tempfile.mkdtemp(prefix="mahlwerk-"))
        for name, text in files.items():
            (self.here / name.replace("_", ".")).write_text(text)

    def command(self, words):
        return [self.program, *words.split()]

    def start(self, words, code=0, limit=None, **environment):
        def limited():
            if limit:
                resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
        ended = subprocess.run(self.command(words), cwd=self.here, capture_output=True, text=True,
                               env={**os.environ, **environment}, preexec_fn=limited)
        assert ended.returncode == code, (ended.returncode, ended.stdout[-500:], ended.stderr)
        return ended

    def end_when(self, words, ready, with_signal=signal.SIGINT, **environment):
        """Sends a signal once `ready(progress so far)` is true; the exit code and what was said."""
        said = self.here / "said"
        with open(said, "w") as errors, open(self.here / "printed", "w") as printed:
            process = subprocess.Popen(self.command(words), cwd=self.here, stdout=printed,
                                       stderr=errors, env={**os.environ, **environment})
            while process.poll() is None and not ready(said.read_text()):
                time.sleep(0.01)
            if process.poll() is None:
                process.send_signal(with_signal)
            process.wait(timeout=120)
        return process.returncode, said.read_text()

    def names(self):
        return {path.name for path in self.here.iterdir()}

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.here, ignore_errors=True)


def a_run_of_more_than_a_minute_keeps_a_checkpoint_unasked(program):
    """The minute is shortened to 0.2 s."""
    with Place(program, ball_toml=LONG) as p:
        file = p.here / "out.checkpoint"
        code, said = p.end_when("run ball.toml --out out --jobs 1", lambda _: file.exists(),
                                MAHLWERK_CHECKPOINT_AFTER="0.2")
        assert code == 130 and file.exists(), (code, said)
        assert "out.checkpoint" in said and "--resume" in said, said
        assert said.count("--resume") == 1, said
        p.start("run ball.toml --out out --resume --jobs 2")
        assert not file.exists(), "the run is complete"
        p.start("run ball.toml --out whole --jobs 1")
        for name in TABLES:
            assert (p.here / "out" / name).read_text() == (p.here / "whole" / name).read_text(), name


def a_short_run_and_one_that_wants_none_keep_no_checkpoint(program):
    with Place(program, ball_toml=ENDLESS) as p:
        begun = time.time()
        code, said = p.end_when("run ball.toml --out out", lambda _: time.time() > begun + 0.7)
        assert code == 130 and "out.checkpoint" not in p.names(), (code, said)
        begun = time.time()
        code, said = p.end_when("run ball.toml --out none --no-checkpoint",
                                lambda _: time.time() > begun + 0.7,
                                MAHLWERK_CHECKPOINT_AFTER="0.1")
        assert code == 130 and "none.checkpoint" not in p.names(), (code, said)
        assert "--resume" not in said, said


def a_checkpoint_of_a_killed_run_is_told_before_it_is_replaced(program):
    with Place(program, ball_toml=ENDLESS) as p:
        file = p.here / "out.checkpoint"
        p.end_when("run ball.toml --out out", lambda _: file.exists(), signal.SIGKILL,
                   MAHLWERK_CHECKPOINT_AFTER="0.1")
        said = p.start("run ball.toml --out out --set run.time=0.1s").stderr
        assert "checkpoint-replaced" in said and "--resume" in said, said
        assert not file.exists()


def ctrl_c_while_assumed_values_are_varied_leaves_the_whole_result(program):
    """The runs that vary them take several times as long as the run itself."""
    case = BALL.replace('"0.3 s"', '"150 s"').replace('lasting = "tc"\ncontact_time = "1e-4 s"\n', "")
    case = case.replace("restitution = 0.9\ntangential_restitution = 0.9\n", "").replace(
        "[run]", '[run]\nsensitivity = "on"')
    with Place(program, ball_toml=case) as p:
        p.start("run ball.toml --out alone --jobs 1 --set run.sensitivity=off")
        code, said = p.end_when("run ball.toml --out out --jobs 1",
                                lambda said: "varying the assumed values" in said,
                                MAHLWERK_PROGRESS_EVERY="0")
        assert code == 130 and "the results are complete" in said, (code, said[-500:])
        assert "assumed values" in said and "--resume" not in said, said
        about = json.loads((p.here / "out" / "summary.json").read_text())
        assert about["_about"]["complete"] and "_sensitivity" not in about
        for name in TABLES:
            assert (p.here / "out" / name).read_text() == (p.here / "alone" / name).read_text(), name
        assert "dissipated power" in (p.here / "printed").read_text()


def an_interrupted_fit_of_powder_goes_on_with_its_evaluations(program):
    with Place(program, ball_toml=GROUND, sieves_csv=SIEVES) as p:
        words = "fit ball.toml sieves.csv --jobs 1 --out "
        whole = p.start(words + "whole")
        done = re.compile(r"fitting: (\d+) of about (\d+) evaluations")

        def some(said, least=15):
            found = done.findall(said)
            return bool(found) and int(found[-1][0]) >= least

        code, said = p.end_when(words + "out", some, MAHLWERK_PROGRESS_EVERY="0")
        assert code == 130, (code, said)
        last = said.splitlines()[-1]
        assert "the best of" in last and "breakage.gamma = " in last, last
        assert "out.checkpoints" in last and "same command" in last, last
        assert not [name for name in p.names() if name.startswith(".")], p.names()
        code, said = p.end_when(words + "out", lambda s: some(s, 60), signal.SIGKILL,
                                MAHLWERK_PROGRESS_EVERY="0")
        kept = int(re.search(r"resuming a fit with (\d+) kept evaluations", said)[1])
        assert code == -signal.SIGKILL and kept >= 15, (code, said[:200])
        again = p.start(words + "out")
        assert "resuming a fit" in again.stderr, again.stderr
        for name in ("fit.csv", "fit.json", "fitted.toml"):
            assert masked(p.here / "out" / name) == masked(p.here / "whole" / name), name
        assert again.stdout.replace("out/", "whole/").split("results:")[0] == whole.stdout.split(
            "results:")[0]
        assert p.names() == {"ball.toml", "sieves.csv", "whole", "out", "said", "printed"}, p.names()


def a_fit_of_other_measurements_takes_no_kept_evaluations(program):
    with Place(program, ball_toml=GROUND, sieves_csv=SIEVES) as p:
        words = "fit ball.toml sieves.csv --jobs 1 --out out"
        p.end_when(words, lambda said: "fitting: " in said, MAHLWERK_PROGRESS_EVERY="0")
        assert (p.here / "out.checkpoints").exists()
        (p.here / "sieves.csv").write_text(SIEVES.replace("180", "170"))
        said = p.start(words).stderr
        assert "resuming a fit" not in said, said


def a_file_at_its_limit_is_answered_and_the_table_is_printed(program):
    """ulimit -f: SIGXFSZ would end the program."""
    with Place(program, ball_toml=BALL) as p:
        for words, mark in (("", "dissipated power"), (" --json", '"dissipated_power"')):
            ended = p.start("run ball.toml --out out" + words, code=2, limit=20_000)
            assert mark in ended.stdout, ended
            assert "cannot-write" in ended.stderr and "File too large" in ended.stderr, ended.stderr
            assert p.names() == {"ball.toml"}, p.names()


def a_full_disk_is_answered_and_the_table_is_printed(program):
    """Of records in HDF5, whose library has an error trace of its own."""
    import campaign
    records = LONG.replace("3000 s", "60 s") + "[observe]\ncollisions = true\n"
    with Place(program, ball_toml=records) as p:
        room = p.here / "room"
        room.mkdir()
        ended = campaign.in_a_small_room(f"""
          mount -t tmpfs -o size=2M tmpfs {room} || exit 77
          cd {p.here}; {program} run ball.toml --out room/out --jobs 2; echo "first $?"
          ls -A room
          mount -o remount,size=5M {room}
          {program} run ball.toml --out room/out --jobs 2; echo "then $?"; ls -A room
          mount -o remount,size=64M {room}
          {program} run ball.toml --set run.time="600 s" --out room/out --jobs 2 &
          until ls room/.out*/collisions.h5 >/dev/null 2>&1; do sleep 0.01; done
          dd if=/dev/zero of=room/other bs=64k 2>/dev/null; wait $!; echo "last $?"
          ls -A room/out""")
        if ended is None or ended.returncode == 77:
            return SKIPPED
        print(ended.stdout, ended.stderr)
        assert "HDF5-DIAG" not in ended.stderr, ended.stderr
        first, _, rest = ended.stdout.partition("first 2")
        assert not first and "MB are needed for a result" in ended.stderr, "refused before the run"
        then, _, last = rest.partition("then 2")
        assert not then.strip() and "not-enough-disk" in ended.stderr, "records have no room"
        assert "dissipated power" in last and "summary.json" in last.split("last 2")[1], last


def a_store_with_an_endless_view_is_refused(program):
    """`results` may be replaced, because the program does not read it; a table may be no view."""
    import campaign
    endless = ("CREATE VIEW {0} AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i FROM n) "
               "SELECT i AS point, i AS hash, i AS status FROM n")
    with campaign.Campaign(program, campaign.frequencies(2)) as c:
        c.run("--quiet", "--results", "summary")
        table = c.part("export")
        with sqlite3.connect(c.out / "campaign.sqlite") as store:
            store.execute("DROP VIEW results")
            store.execute(endless.format("results"))
        assert c.part("export") == table
        with sqlite3.connect(c.out / "campaign.sqlite") as store:
            store.execute("DROP TABLE summary")
            store.execute(endless.format("summary"))
        for part in ("export", "status"):
            said = c.part(part, code=2)
            assert "`summary` is no table" in said and "store" in said, said


def an_export_to_a_full_disk_leaves_no_file(program):
    import campaign
    with campaign.Campaign(program, campaign.frequencies(2)) as c:
        c.run("--quiet", "--results", "summary")
        room = c.here / "room"
        room.mkdir()
        ended = campaign.in_a_small_room(f"""
          mount -t tmpfs -o size=4k tmpfs {room} || exit 77
          {program} sweep export {c.out} --out {room}/table.csv; echo "code $?"; ls -A {room}""")
        if ended is None or ended.returncode == 77:
            return SKIPPED
        assert ended.stdout == "code 2\n", ended
        assert "cannot-write" in ended.stderr and "space" in ended.stderr, ended.stderr


if __name__ == "__main__":
    program, _, name = sys.argv[1:]
    sys.exit(globals()[name](program) or 0)
