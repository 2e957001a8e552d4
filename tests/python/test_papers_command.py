# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The command `mahlwerk papers`."""
import contextlib
import json
import os
import signal
import sqlite3
import subprocess
import time
from pathlib import Path

import pytest

import mahlwerk

HOME = Path(__file__).resolve().parents[2]
PROGRAM = os.environ["MAHLWERK_PROGRAM"]
LONG = ["--set", "run.time=4000 s", "--set", "run.replicates=1"]


def papers(*words, **environment):
    ended = subprocess.run([PROGRAM, "papers", *words], capture_output=True, text=True, check=False,
                           env={**os.environ, **environment})
    return ended.returncode, ended.stdout + ended.stderr


def paper(quantity="dissipated_power", key="mill.frequency", campaign=True):
    """A paper with one campaign, c.toml, one figure and one check."""
    mine = Path("mine")
    mine.mkdir(exist_ok=True)
    (mine / "paper.py").write_text(
        'from mahlwerk.papers import Paper\npaper = Paper(title="T", source="S")\nc = paper.campaign("c")\n'
        f'paper.figure("1", "t", c.curve("{quantity}", against="{key}"))\n'
        f'paper.check("1", "s", c.rises("{quantity}", against="{key}"))\n')
    if campaign:
        text = (HOME / "papers/vertical-vibration-mill/frequency.toml").read_text()
        (mine / "c.toml").write_text(text)


def test_one_command_makes_every_figure_and_judges_every_check():
    few = ["vertical-vibration-mill", "--set", "run.replicates=8", "--leave-out", "free-numbers", "--leave-out",
           "sticking", "--out", "out"]
    code, told = papers(*few)
    assert code == 0, told
    for name in ("paper.html", "claims.csv", "claims.md", "diameter/campaign.csv", "figures/figure-7.svg",
                 "figures/figure-7.pdf", "figures/figure-7a.csv", "figures/figure-6.svg", "figures/figure-6a.csv",
                 "figures/captions.md", "tables/d90.md", "tables/d90.csv"):
        assert (Path("out") / name).is_file(), name
    assert len(list(Path("out/size/runs").glob("[0-9]*/summary.json"))) == 5
    assert not Path("out/sticking").exists() and "24 sets" not in Path("out/claims.csv").read_text()
    # The verification tests prove the same claims for this mill with tolerances of their own.
    for line in ("6a     yes", "6b     yes", "7      yes", "intro  partly"):
        assert line in told
    # A second run judges what is there; --force runs everything again. Both give the same numbers.
    claims, stored = Path("out/claims.csv").read_text(), Path("out/size/campaign.sqlite").stat().st_ino
    assert papers(*few, "--quiet") == (0, "")
    assert Path("out/claims.csv").read_text() == claims
    assert Path("out/size/campaign.sqlite").stat().st_ino == stored
    assert papers(*few, "--force", "--quiet", "--threads", "1", "--leave-out", "spex")[0] == 0
    assert Path("out/size/campaign.sqlite").stat().st_ino != stored
    assert set(Path("out/claims.csv").read_text().splitlines()) < set(claims.splitlines())


def test_what_is_wrong_is_said_before_anything_runs():
    code, told = papers("no-such-mill", "--out", "out")
    assert code == 2 and "there is no paper with this name" in told
    paper("flight_share", "mill.amplitude", campaign=False)
    code, told = papers("mine", "--out", "out")
    assert code == 2 and "c.toml" in told
    paper("flight_share", "mill.amplitude")
    code, told = papers("mine", "--out", "out")
    assert code == 2 and "c.toml does not vary mill.amplitude" in told and "has no quantity flight_share" in told
    assert "paper.py:4" in told and "paper.py:5" in told
    assert not Path("out").exists()


SHORT = ["mine", "--set", "run.time=1 s", "--set", "run.replicates=2", "--out", "out", "--quiet"]


def test_a_folder_with_other_files_is_never_written_into():
    paper()
    Path("out/figures").mkdir(parents=True)
    Path("out/figures/thesis.txt").write_text("mine")
    for words in (SHORT, [*SHORT, "--force"]):
        code, told = papers(*words)
        assert code == 2 and "holds no results of a paper" in told
        assert os.listdir("out") == ["figures"] and os.listdir("out/figures") == ["thesis.txt"]


def test_files_of_others_among_the_figures_stay_and_old_figures_go():
    paper()
    assert papers(*SHORT) == (0, "")
    Path("out/figures/mine.svg").write_text("mine")
    assert Path("out/figures/figure-1.svg").is_file()
    file = Path("mine/paper.py")
    file.write_text(file.read_text().replace('figure("1"', 'figure("2"'))
    for words in (SHORT, [*SHORT, "--force"]):
        assert papers(*words) == (0, "")
        assert Path("out/figures/mine.svg").read_text() == "mine"
        assert Path("out/figures/figure-2.svg").is_file() and not Path("out/figures/figure-1.svg").exists()


def test_json_has_the_checks_and_no_other_words():
    paper()
    ended = subprocess.run([PROGRAM, "papers", "mine", "--set", "run.time=1 s", "--out", "out", "--json"],
                           capture_output=True, text=True, check=True)
    (told,) = json.loads(ended.stdout)
    assert {**json.loads(Path("out/paper.json").read_text()), "results": "out"} == told
    assert (told["study"], told["mahlwerk"]) == ("paper", mahlwerk.__version__)
    assert told["title"] == "T" and told["claims"][0]["says"] == "s"
    assert told["claims"][0]["holds"] in ("yes", "partly", "no", "undecided")
    refused = subprocess.run([PROGRAM, "papers", "nowhere", "--json"], capture_output=True, text=True, check=False)
    assert json.loads(refused.stderr)["faults"][0]["code"] == "no-such-paper"


def done():
    """The folders of the runs that the store holds."""
    try:
        with contextlib.closing(sqlite3.connect("file:out/c/campaign.sqlite?mode=ro", uri=True, timeout=30)) as store:
            return [row[0] for row in store.execute("SELECT folder FROM runs WHERE status = 'done'")]
    except sqlite3.OperationalError:  # not there yet
        return []


def begun():
    """Starts a long paper, and waits until a run of it is stored."""
    paper()
    started = subprocess.Popen([PROGRAM, "papers", "mine", *LONG, "--out", "out", "--quiet", "--jobs", "1"])
    began = time.monotonic()
    while not done():
        assert started.poll() is None and time.monotonic() - began < 240
        time.sleep(0.02)
    return started


def test_an_interrupted_paper_writes_no_checks_and_goes_on():
    started = begun()
    started.send_signal(signal.SIGINT)
    assert started.wait(120) == 130
    assert not Path("out/claims.csv").exists(), "half a paper is no paper"
    assert papers("mine", *LONG, "--out", "out", "--quiet")[0] == 0
    assert Path("out/claims.csv").is_file()


def test_a_killed_paper_goes_on_and_gives_the_same():
    started = begun()
    started.kill()
    started.wait()
    assert not Path("out/claims.csv").exists()
    kept = {f: (Path("out/c") / f / "summary.json").stat().st_mtime_ns for f in done()}
    assert papers("mine", *LONG, "--out", "out", "--quiet")[0] == 0
    for folder, when in kept.items():
        assert (Path("out/c") / folder / "summary.json").stat().st_mtime_ns == when, "a stored run is not run again"
    assert papers("mine", *LONG, "--out", "whole", "--quiet")[0] == 0
    assert Path("out/claims.csv").read_text() == Path("whole/claims.csv").read_text()


@pytest.mark.parametrize("python, said", [("/no/such/python", "Python is not installed"), ("bare", "lacks")])
def test_without_python_or_its_packages_the_command_says_what_to_install(python, said):
    if python == "bare":
        Path("bare").write_text("#!/bin/sh\nexec /usr/bin/env -i python3 -S -I \"$@\"\n")
        Path("bare").chmod(0o755)
        python = str(Path("bare").resolve())
    code, told = papers("bond-mill", MAHLWERK_PYTHON=python)
    assert code == 2 and said in told and "python3-matplotlib" in told
