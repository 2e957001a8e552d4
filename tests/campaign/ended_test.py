#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Campaigns that are interrupted: killed, split into shards, on a full disk or a cluster.

  ended_test.py PROGRAM TEST    exits with 77 if the test cannot run on this machine
"""

import random
import shutil
import signal
import subprocess
import sys
import time

import campaign
from campaign import Campaign, SKIPPED, asked, check_sound, frequencies, in_a_small_room, numbers


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
            rounds += 1  # complete: compare, then start again from the beginning
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
        # A second merge takes nothing twice, and no run is left.
        assert "0 runs merged" in c.part("merge", out=shards)
        assert "9 runs already done" in c.run(out=shards)


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
        (c.out / "campaign.lock").touch()  # as left by another shard that was killed at its start
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
    """Needs a cluster; one node with slurmctld, slurmd and munge is enough."""
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


if __name__ == "__main__":
    sys.exit(campaign.main(globals()))
