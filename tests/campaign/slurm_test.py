#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Campaigns on a cluster, with a scheduler that writes down what it is asked.

  slurm_test.py PROGRAM TEST

ended_test.py has a test on a real one."""

import json
import os
import subprocess
import sys

import campaign
from campaign import Campaign, asked, frequencies, numbers

SBATCH = """#!/bin/sh
echo "$*" >> "$CALLS"
[ $(wc -l < "$CALLS") -le ${MOST_JOBS:-1000} ] || { echo "QOSMaxSubmitJobPerUserLimit"; exit 1; }
echo $((100 + $(wc -l < "$CALLS")));
"""


class Cluster(Campaign):
    """A campaign beside a fake sbatch and scontrol."""

    def __init__(self, program, points, most=None, **more):
        super().__init__(program, frequencies(points), **more)
        bin_ = self.here / "bin"
        bin_.mkdir()
        self.calls = self.here / "calls"
        self.program_of("sbatch", SBATCH)
        if most is not None:
            self.program_of("scontrol", "#!/bin/sh\n[ \"$1 $2\" = 'show config' ] || exit 1\n"
                                        "echo 'Configuration data as of now'\n"
                                        f"echo 'MaxArraySize            = {most}'\n")
        os.environ.update(PATH=f"{bin_}:{os.environ['PATH']}", CALLS=str(self.calls))

    def program_of(self, name, text):
        file = self.here / "bin" / name
        file.write_text(text)
        file.chmod(0o755)

    def submit(self, shards, code=0, **more):
        os.environ.update(more)
        self.calls.write_text("")
        said = self.run("--slurm", str(shards), "--results", "summary", code=code)
        return said, self.calls.read_text().splitlines()

    def task(self, number, before=0, code=0):
        """A task of the array that the script describes, as Slurm starts it."""
        words = [str(before)] if before else []
        ended = subprocess.run(["bash", str(self.out / "campaign.slurm"), *words],
                               env=dict(os.environ, SLURM_ARRAY_TASK_ID=str(number)),
                               capture_output=True, text=True)
        assert ended.returncode == code, (ended.returncode, ended.stdout, ended.stderr)
        return ended.stdout + ended.stderr

    def status(self):
        return json.loads(self.part("status", "--json"))


def arrays_beyond_the_limit_of_the_cluster_are_cut(program):
    """Slurm: the numbers of an array's tasks are below MaxArraySize."""
    for most, expected in ((4, [("", 3), ("3", 3), ("6", 1)]), (8, [("", 7)]), (None, [("", 7)])):
        with Cluster(program, 7, most) as c:
            said, calls = c.submit(7)
            script = (c.out / "campaign.slurm").read_text()
            assert f"#SBATCH --array=1-{expected[0][1]}\n" in script, script
            assert len(calls) == len(expected) + 1, calls
            for call, (before, tasks) in zip(calls, expected):
                assert call.endswith("campaign.slurm" + (" " + before if before else "")), call
                assert not before or f"--array=1-{tasks} " in call, call
                assert call.replace("--parsable ", "sbatch ").split("/")[0] in script, (call, script)
            jobs = ":".join(str(101 + i) for i in range(len(expected)))
            assert f"--dependency=afterany:{jobs} " in calls[-1], calls[-1]
            for before, tasks in expected:
                for task in range(1, tasks + 1):
                    c.task(task, int(before or 0))
            assert len(numbers(c.out)) == 7, "the last task merges"
            listed = (c.out / "mahlwerk-files.txt").read_text()
            for i, (_, tasks) in enumerate(expected):
                assert f"slurm-{101 + i}_{tasks}.out\n" in listed, listed
    with Cluster(program, 3, most=0) as c:
        assert "no job arrays" in c.submit(3, code=2)[0]


def what_was_not_submitted_is_said(program):
    with Cluster(program, 7, most=4) as c:
        said, calls = c.submit(7, code=2, MOST_JOBS="1")
        assert "sbatch refused: QOSMaxSubmitJobPerUserLimit" in said, said
        script = c.out / "campaign.slurm"
        assert f"sbatch --array=1-3 {script} 3 and sbatch --array=1-1 {script} 6" in said, said
        os.environ["MOST_JOBS"] = "1000"


def status_knows_shards_before_a_merge(program):
    with Cluster(program, 7) as c:
        c.submit(3)
        c.task(2)
        found = c.status()
        assert [found[k] for k in ("points", "done", "failed", "waiting", "merged")] == [
            7, 2, 0, 5, False], found
        assert [(s["shard"], s["of"], s["points"], s["done"], s["begun"]) for s in found["shards"]] == [
            (1, 3, 3, 0, False), (2, 3, 2, 2, True), (3, 3, 2, 0, False)], found
        said = c.part("status")
        assert "shards   3, 1 done" in said and "1/3  0 of 3 points done: not begun" in said, said
        assert "2/3  2 of 2 points done: done" in said and "campaign.slurm` resumes it" in said, said
        process = subprocess.Popen(c.command("--shard", "1/3", "--quiet", "--set", "run.time=1e5 s"))
        try:
            while not c.status()["shards"][0]["at_work"]:
                assert process.poll() is None
        finally:
            process.kill()
            process.wait()


def failures_of_shards_are_told_before_a_merge(program):
    with Cluster(program, 4) as c:
        c.case.write_text(c.case.read_text().replace('to = "20 Hz"', 'to = "1e9 Hz"'))
        c.submit(2)
        for task in (1, 2):
            subprocess.run(["bash", str(c.out / "campaign.slurm")], capture_output=True,
                           env=dict(os.environ, SLURM_ARRAY_TASK_ID=str(task)))
        (c.out / "campaign.sqlite").unlink(missing_ok=True)
        found = c.status()
        assert found["failed"] > 0 and found["done"] + found["failed"] == 4, found
        said = c.part("status")
        assert "failed" in said and "point 4: mill.frequency = 1000000000 Hz" in said, said


def a_cancelled_shard_that_is_submitted_again_gets_its_merge(program):
    with Cluster(program, 7) as c:
        c.run("--quiet", "--results", "summary", out=c.here / "whole")
        c.submit(3)
        for task in (1, 3):
            c.task(task)  # task 2 is cancelled, and the merge after it collects what is there
        assert not (c.out / "campaign.sqlite").exists(), "not all have ended"
        c.part("merge", "--quiet")
        assert asked(c.out, "SELECT count(*) FROM runs WHERE status = 'waiting'") == [(2,)]
        assert "5 of 7 done" not in c.part("status") and c.status()["waiting"] == 2
        said = c.task(2)  # sbatch --array=2 campaign.slurm
        assert "2 runs merged from 3 shards: 7 of 7 done" in said, said
        assert numbers(c.out) == numbers(c.here / "whole")
        assert c.status()["waiting"] == 0 and c.status()["merged"]


def a_case_that_changed_since_its_submission_is_refused(program):
    with Cluster(program, 4) as c:
        c.submit(2)
        c.case.write_text("# A comment changes nothing.\n" + c.case.read_text())
        c.task(1)
        assert not c.status()["case_changed"]
        kept = c.case.read_text()
        c.case.write_text(kept.replace("steps = 4", "steps = 5"))
        said = c.task(2, code=2)
        assert "has changed since it was submitted" in said and "case.toml" in said, said
        assert not (c.out / "campaign.shard-2-of-2.sqlite").exists()
        assert c.status()["case_changed"] and "Warning: " in c.part("status")
        c.case.write_text(kept.replace("restitution = 0.9\n", "restitution = 0.8\n", 1))
        c.task(2, code=2)
        c.case.write_text(kept)
        c.task(2)
        assert len(numbers(c.out)) == 4
        c.case.write_text(kept.replace("steps = 4", "steps = 5"))
        c.submit(2)  # takes the new one; what still holds is kept
        c.task(1), c.task(2)
        assert len(numbers(c.out)) == 5 and not c.status()["case_changed"]


if __name__ == "__main__":
    sys.exit(campaign.main(globals()))
