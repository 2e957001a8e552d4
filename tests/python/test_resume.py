# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Runs from Python that are interrupted and resumed."""
import os
import signal
from pathlib import Path

import pytest

import mahlwerk


def test_an_interrupted_run_goes_on_with_the_same_bits(ball):
    """The first call is interrupted while it computes; the second is the same call."""
    long = ball.replace({"run.time": "800 s"})
    told = []

    def interrupt(share, line):
        told.append(line)
        if len(told) == 1:
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(mahlwerk.Interrupted) as caught:
        long.run("out", resume=True, threads=1, progress=interrupt)
    assert not caught.value.result.complete and Path("out.checkpoint").exists()
    with pytest.raises(mahlwerk.InputError, match="belongs to another run"):
        ball.run("out", resume=True)
    ended = long.run("out", resume=True)
    assert ended.complete and not Path("out.checkpoint").exists()
    whole = long.run()
    assert ended["energy_balance"] == whole["energy_balance"] and ended["drawn_power"] == whole["drawn_power"]
    with pytest.raises(mahlwerk.InputError, match="holds a result"):
        long.run("out", resume=True)


def test_what_cannot_be_resumed_is_refused(ball):
    with pytest.raises(ValueError, match="cannot be resumed"):
        ball.run("out", resume=True, collisions=True)
    with pytest.raises(ValueError, match="above 0, not 0"):
        ball.run("out", checkpoint=0)
    with pytest.raises(mahlwerk.InputError, match="no folder"):
        ball.run(resume=True)


def test_a_failed_point_of_a_sweep_says_why(ball):
    with pytest.raises(mahlwerk.RunError, match="point 2: .*fast"):
        ball.replace({"run.time": "0.1 s"}).sweep({"mill.frequency": ["10 Hz", "fast"]}, "speeds")
