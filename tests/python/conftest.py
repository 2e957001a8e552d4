# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Tests of the Python package beside the program: MAHLWERK_PROGRAM is the program, PYTHONPATH has the
package of the same build."""
import json
import os
import subprocess
from pathlib import Path

import matplotlib
import pytest

import mahlwerk

matplotlib.use("Agg")
HOME = Path(__file__).resolve().parents[2]


@pytest.fixture(autouse=True)
def in_a_fresh_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


@pytest.fixture
def example():
    return lambda name: str(HOME / "examples" / name)


@pytest.fixture
def program():
    """Runs the program; returns its exit code, its output and its last line of messages as JSON."""
    def run(*words):
        ended = subprocess.run([os.environ["MAHLWERK_PROGRAM"], *map(str, words)],
                               capture_output=True, text=True, check=False)
        last = ended.stderr.strip().splitlines()[-1:] or ["null"]
        said = json.loads(last[0]) if last[0].startswith("{") else None
        return ended.returncode, ended.stdout, said
    return run


@pytest.fixture
def ball():
    """One ball in a vibrating vial, built in Python."""
    return mahlwerk.Case({
        "title": "one ball", "seed": 1,
        "mill": {"kind": "vibration", "frequency": "10 Hz", "amplitude": "25 mm"},
        "jar": {"kind": "capsule", "diameter": "12 mm", "volume": "5 ml"},
        "balls": [{"count": 1, "diameter": "8 mm", "density": "7850 kg/m3"}],
        "contact": {"restitution": 0.9, "tangential_restitution": 0.9},
        "run": {"engine": "event", "time": "2 s", "replicates": 2}})
