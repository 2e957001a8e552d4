#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Campaigns as a user meets them: killed, split, joined, failing, on a full disk.

  campaign_test.py PROGRAM TEST    exits with 77 where the test cannot be run here
"""

import math
import os
import pathlib
import random
import re
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time

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
    """What the runs gave, without how long they took."""
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


def killed_50_times_every_run_is_there_once_and_the_same(program):
    draw = random.Random(8)
    points = 300
    with Campaign(program, frequencies(points), time="2 s") as c:
        c.run("--results", "summary", "--quiet", out=c.here / "whole")
        kills, rounds = 0, 0
        while kills < 50 or rounds == 0:
            process = subprocess.Popen(c.command("--results", "summary", "--quiet"))
            if kills < 50:
                time.sleep(draw.uniform(0.0, 0.6))
                process.send_signal(signal.SIGKILL)
            ended = process.wait()
            check_sound(c.out)
            kills += ended == -signal.SIGKILL
            if ended != 0:
                continue
            rounds += 1  # all is done: whole, and once more from the beginning
            assert asked(c.out, "SELECT count(*), count(DISTINCT hash), sum(attempts) FROM runs "
                                "WHERE status = 'done'") == [(points, points, points)]
            assert numbers(c.out) == numbers(c.here / "whole")
            shutil.rmtree(c.out)
        print("killed", kills, "times in", rounds, "campaigns")


def killed_with_folders_leaves_whole_results(program):
    draw = random.Random(5)
    with Campaign(program, frequencies(12)) as c:
        for _ in range(10):
            process = subprocess.Popen(c.command("--quiet"))
            time.sleep(draw.uniform(0.05, 0.5))
            process.send_signal(signal.SIGKILL)
            process.wait()
            check_sound(c.out)
            for (folder,) in asked(c.out, "SELECT folder FROM runs WHERE status = 'done'") \
                    if (c.out / "campaign.sqlite").exists() else []:
                assert (c.out / folder / "summary.json").exists(), folder
        c.run("--quiet")
        folders = asked(c.out, "SELECT folder FROM runs")
        assert len(folders) == 12
        for (folder,) in folders:
            assert (c.out / folder / "report.html").exists(), folder


def jobs_and_shards_give_the_same_to_the_bit(program):
    with Campaign(program, frequencies(9)) as c:
        one, two, shards = (c.here / name for name in ("one", "two", "shards"))
        c.run("--jobs", "1", "--quiet", out=one)
        c.run("--jobs", "2", "--quiet", out=two)
        for i in range(1, 5):
            c.run("--shard", f"{i}/4", "--quiet", out=shards)
        c.part("merge", "--quiet", out=shards)
        assert numbers(one) == numbers(two) == numbers(shards)
        assert len(numbers(one)) == 9
        # Joined once more, nothing is taken twice; and there is nothing left to run.
        assert "0 runs taken" in c.part("merge", out=shards)
        assert "9 runs had been run before" in c.run(out=shards)


def shards_go_on_after_they_were_joined(program):
    with Campaign(program, frequencies(3)) as c:
        quiet = ("--quiet", "--results", "summary")
        for i in (1, 2):
            c.run("--shard", f"{i}/2", *quiet)
        c.part("merge", "--quiet")
        c.case.write_text(c.case.read_text().replace("steps = 3", "steps = 5"))
        for i in (1, 2):
            c.run("--shard", f"{i}/2", *quiet)
        c.part("merge", "--quiet")
        assert len(numbers(c.out)) == 5, "the points that are new"
        whole = c.here / "whole"
        c.run(*quiet, out=whole)
        assert numbers(c.out) == numbers(whole)


def a_shard_begins_beside_one_whose_store_is_being_made(program):
    with Campaign(program, frequencies(4)) as c:
        c.out.mkdir()
        (c.out / "campaign.lock").touch()  # as another shard leaves it, killed as it began
        (c.out / "campaign.shard-2-of-2.sqlite").touch()
        c.run("--shard", "1/2", "--quiet")
        assert len(asked(c.out, "SELECT * FROM runs WHERE status = 'done'",
                         "campaign.shard-1-of-2.sqlite")) == 2


def a_campaign_killed_as_it_began_goes_on(program):
    for words in ((), ("--force",)):
        with Campaign(program, frequencies(2)) as c:
            c.out.mkdir()
            (c.out / "campaign.lock").touch()
            c.run("--quiet", *words)
            assert len(numbers(c.out)) == 2


def trouble_with_a_folder_stops_and_fails_no_run(program):
    with Campaign(program, frequencies(3)) as c:
        c.out.mkdir()
        (c.out / "campaign.lock").touch()
        (c.out / "runs").write_text("in the way")
        c.run("--quiet", code=2)
        (c.out / "runs").unlink()
        c.run("--quiet")
        assert asked(c.out, "SELECT status, count(*) FROM runs GROUP BY status") == [("done", 3)]


def a_killed_shard_goes_on(program):
    with Campaign(program, frequencies(40), time="5 s") as c:
        whole, out = c.here / "whole", c.out
        c.run("--quiet", "--results", "summary", out=whole)
        for i in (1, 2):
            process = subprocess.Popen(c.command("--shard", f"{i}/2", "--quiet", "--results",
                                                 "summary"))
            time.sleep(0.2)
            process.send_signal(signal.SIGKILL)
            process.wait()
        for i in (1, 2):
            c.run("--shard", f"{i}/2", "--quiet", "--results", "summary")
            check_sound(out, f"campaign.shard-{i}-of-2.sqlite")
        c.part("merge", "--quiet")
        check_sound(out)
        assert numbers(out) == numbers(whole)


def failures_are_kept_and_do_not_stop_the_rest(program):
    with Campaign(program, '"balls.diameter" = ["8 mm", "40 mm", "9 mm"]') as c:
        said = c.run(code=3)
        assert "1 run failed" in said, said
        assert [row[0] for row in asked(c.out, "SELECT status FROM results")] == [
            "done", "failed", "done"]
        status = c.part("status")
        assert "balls.diameter = 40 mm" in status and "failed   1" in status, status
        c.part("retry", "--quiet", code=3)
        assert asked(c.out, "SELECT attempts FROM runs WHERE status = 'failed'") == [(2,)]
        assert asked(c.out, "SELECT max(attempts) FROM runs WHERE status = 'done'") == [(1,)]


def a_case_that_fails_everywhere_is_refused(program):
    with Campaign(program, '"balls.diameter" = ["40 mm", "50 mm"]') as c:
        said = c.run(code=2)
        assert "balls.1" in said or "diameter" in said, said
    with Campaign(program, '"mill.frequancy" = ["10 Hz"]') as c:
        assert "did you mean `frequency`?" in c.run(code=2)


def more_points_run_only_what_is_new(program):
    with Campaign(program, '"mill.frequency" = ["10 Hz", "12 Hz"]') as c:
        c.run("--quiet")
        c.case.write_text(c.case.read_text().replace('"12 Hz"]', '"12 Hz", "14 Hz", "10 Hz"]'))
        said = c.run()
        assert "2 runs had been run before" in said and "1 run in" in said, said
        assert asked(c.out, "SELECT count(*) FROM results") == [(4,)]


def one_at_a_time_leaves_the_case_as_it_is_and_can_be_checked(program):
    sweep = ('design = "one-at-a-time"\n"mill.frequency" = { from = "8 Hz", to = "12 Hz" }\n'
             '"contact.restitution" = { from = 0.5, to = 0.95 }')
    with Campaign(program, sweep) as c:
        subprocess.run([program, "check", str(c.case)], check=True, capture_output=True)
        c.run("--quiet")
        assert asked(c.out, 'SELECT "contact.restitution", "mill.frequency_Hz" FROM results') == [
            (0.9, 10), (0.5, 10), (0.95, 10), (0.9, 8), (0.9, 12)]
        assert (c.out / "figures" / "tornado-dissipated_power.svg").exists()


SENSITIVE = ('design = "%s"\nsamples = %d\n"mill.frequency" = { from = "8 Hz", to = "12 Hz" }\n'
             '"contact.rolling_friction" = { from = 0.01, to = 0.1 }')
T_OF_TWO = math.tan(0.475 * math.pi)  # Student's law with one degree of freedom is Cauchy's


def powers(c):
    """Of each point, and its standard error."""
    return [(power, width / T_OF_TWO) for power, width in asked(
        c.out, 'SELECT dissipated_power_W, dissipated_power_ci95_W FROM results ORDER BY point')]


def answers(c):
    """What the page says of the power's answer to keys: its words, the row of each key."""
    page = (c.out / "campaign.html").read_text()
    part = page[page.index("What matters"):]
    figure = [f for f in part.split("<figure>") if 'aria-label="dissipated power"' in f][0]
    rows = {key: [float(v) if v else math.nan for v in re.findall(r'data-v="([^"]*)"', row)]
            for key, row in re.findall(r"<tr><td>([a-z_.]+)</td>(.*?)</tr>", figure)}
    return part[:part.index("<figure>")], figure, rows


def of_two_replicates_the_noise_of_effects_is_theirs(program):
    with Campaign(program, SENSITIVE % ("morris", 4)) as c:
        c.run("--quiet")
        words, figure, rows = answers(c)
        step, squares = 2 / 3, []
        places = asked(c.out, 'SELECT "mill.frequency_Hz" FROM results ORDER BY point')
        found = powers(c)
        for i in range(len(found) - 1):
            if i % 3 != 2 and places[i] != places[i + 1]:
                squares.append((found[i][1]**2 + found[i + 1][1]**2) / step**2)
        assert len(squares) == 4, places
        expected = math.sqrt(2 / math.pi * sum(squares) / 4)
        size, noise, _, _ = rows["mill.frequency"]
        assert math.isclose(noise, expected, rel_tol=1e-9), (noise, expected)
        assert size > 0 and "Effects of each key: 4." in figure, (rows, figure)
        assert rows["contact.rolling_friction"][0] == 0, rows
        assert words.count("Changes nothing in this case: contact.rolling_friction.") == 1, words


def of_two_replicates_the_noise_of_shares_is_theirs(program):
    with Campaign(program, SENSITIVE % ("sobol-indices", 8)) as c:
        c.run("--quiet")
        _, figure, rows = answers(c)
        found = powers(c)
        ends = [found[i] for i in range(len(found)) if i % 4 in (0, 3)]  # a and b of each group
        mean = sum(y for y, _ in ends) / len(ends)
        variance = sum((y - mean)**2 for y, _ in ends) / (len(ends) - 1)
        noise = 100 * sum(e**2 for _, e in ends) / len(ends) / variance
        said = float(re.search(r"Noise makes ([0-9.]+) % of the variance", figure)[1])
        assert abs(said - noise) <= 0.05 * noise, (said, noise)  # told to two digits
        assert rows["contact.rolling_friction"][1] == 0, rows
        assert "Groups of runs: 8." in figure, figure


def two_at_once_are_refused(program):
    with Campaign(program, frequencies(50), time="60 s") as c:
        first = subprocess.Popen(c.command("--quiet", "--results", "summary"))
        while not (c.out / "campaign.sqlite").exists():  # it holds the lock before it makes that
            time.sleep(0.01)
        said = c.run(code=2)
        assert "another process is at work" in said, said
        assert "a process is at work on it" in c.part("status")
        first.send_signal(signal.SIGINT)
        assert first.wait() == 130
        assert "interrupted" not in c.part("status")


def export_is_what_the_store_holds(program):
    with Campaign(program, frequencies(3)) as c:
        c.run("--quiet")
        lines = c.part("export").splitlines()
        assert len(lines) == 4 and lines[0].startswith("point,mill.frequency_Hz,status,"), lines[0]
        assert c.part("export") == (c.out / "campaign.csv").read_text()


def export_replaces_nothing_unasked(program):
    with Campaign(program, frequencies(2)) as c:
        c.run("--quiet")
        notes = c.here / "notes.txt"
        notes.write_text("important")
        assert "there is such a file already" in c.part("export", "--out", str(notes), code=2)
        assert notes.read_text() == "important"
        c.part("export", "--out", str(notes), "--force")
        assert notes.read_text() == (c.out / "campaign.csv").read_text()


def another_case_does_not_take_the_folder(program):
    with Campaign(program, frequencies(2)) as c:
        c.run("--quiet")
        before = numbers(c.out)
        own = c.case
        c.case = c.here / "other.toml"
        c.case.write_text(own.read_text().replace("A ball", "Another"))
        said = c.run(code=2)
        assert "holds the campaign of" in said and str(own) in said, said
        assert numbers(c.out) == before
        own.unlink()  # as if it had been moved
        c.run("--quiet")
        assert numbers(c.out) == before


def what_is_finished_is_read_without_rights_to_write(program):
    with Campaign(program, frequencies(2)) as c:
        c.run("--quiet")
        assert not list(c.out.glob("campaign.sqlite-*")), "a journal was left"
        ended = in_a_small_room(f"""
          mount --bind {c.out} {c.out} && mount -o remount,ro,bind {c.out} || exit 77
          {program} sweep export {c.out}""")
        if ended is None or ended.returncode == 77:
            return SKIPPED
        assert ended.stdout == (c.out / "campaign.csv").read_text(), ended


def in_a_small_room(script):
    """Runs a shell script where it may mount; None if this machine does not let us."""
    if os.geteuid() != 0 or not shutil.which("unshare"):
        return None
    if subprocess.run(["unshare", "-m", "true"], capture_output=True).returncode != 0:
        return None
    return subprocess.run(["unshare", "-m", "sh", "-c", script], capture_output=True, text=True)


def a_full_disk_is_said_and_loses_nothing(program):
    with Campaign(program, frequencies(200)) as c:
        room = c.here / "room"
        room.mkdir()
        copy = c.here / "copy"
        words = "--quiet --results summary --jobs 2"
        ended = in_a_small_room(f"""
          mount -t tmpfs -o size=600k tmpfs {room} || exit 77
          {program} sweep {c.case} --out {room}/out {words}; echo "code $?"
          mount -o remount,size=50M {room}
          cp -r {room}/out {copy}
          {program} sweep {c.case} --out {room}/out {words}; echo "then $?"
          cp -r {room}/out {c.out}""")
        if ended is None or ended.returncode == 77:
            return SKIPPED
        print(ended.stderr)
        assert "code 2" in ended.stdout and "then 0" in ended.stdout, ended
        assert "full" in ended.stderr or "space" in ended.stderr, ended.stderr
        check_sound(copy)
        kept = asked(copy, "SELECT count(*) FROM runs WHERE status = 'done'")[0][0]
        print(kept, "runs were kept")
        assert 0 < kept < 200
        check_sound(c.out)
        assert asked(c.out, "SELECT count(*), sum(attempts) FROM runs WHERE status = 'done'") == [
            (200, 200)]


def a_store_that_cannot_be_written_is_said(program):
    with Campaign(program, frequencies(3)) as c:
        c.run("--quiet")
        before = numbers(c.out)
        ended = in_a_small_room(f"""
          mount --bind {c.out} {c.out} && mount -o remount,ro,bind {c.out} || exit 77
          {program} sweep {c.case} --out {c.out} --quiet; echo "code $?"
          {program} sweep status {c.out} >/dev/null; echo "status $?" """)
        if ended is None or ended.returncode == 77:
            return SKIPPED
        assert "code 2" in ended.stdout, ended
        assert "cannot be written" in ended.stderr, ended.stderr
        assert numbers(c.out) == before
        (c.out / "campaign.sqlite").write_text("no database at all, but long enough to be read\n")
        said = c.run(code=2)
        assert "damaged" in said or "no store" in said, said


def slurm_jobs_killed_and_submitted_again_lose_nothing_and_do_nothing_twice(program):
    """Needs a cluster: one node with slurmctld, slurmd and munge will do."""
    if not shutil.which("sbatch") or subprocess.run(["sinfo"], capture_output=True).returncode:
        return SKIPPED
    with Campaign(program, frequencies(40), time="200 s") as c:
        c.run("--quiet", "--results", "summary", out=c.here / "whole")

        def submit():
            said = c.run("--slurm", "3", "--results", "summary")
            return said.split("as job ")[1].split(";")[0]

        def wait():
            while subprocess.run(["squeue", "-h"], capture_output=True, text=True).stdout.strip():
                time.sleep(0.5)

        job = submit()
        time.sleep(3)
        subprocess.run(["scancel", "-s", "KILL", "--full", job], capture_output=True)
        time.sleep(1)
        subprocess.run(["scancel", job])
        wait()
        done = sum(asked(c.out, "SELECT count(*) FROM runs WHERE status = 'done'", path.name)[0][0]
                   for path in c.out.glob("campaign.shard-*.sqlite"))
        print(done, "runs done when the jobs were killed")
        assert done < 40, done
        submit()
        wait()
        check_sound(c.out)
        assert asked(c.out, "SELECT count(*), sum(attempts) FROM runs WHERE status = 'done'") == [
            (40, 40)]
        assert numbers(c.out) == numbers(c.here / "whole")


def main():
    program, name = sys.argv[1:]
    tests = {f.__name__: f for f in globals().values() if callable(f) and
             getattr(f, "__code__", None) and f.__code__.co_varnames[:1] == ("program",)}
    return tests[name](program) or 0


if __name__ == "__main__":
    sys.exit(main())
