# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Wear over the time of operation: what the folder and Python say, computed a second time from the tables."""
import os
import signal
import subprocess
import time

import numpy as np
import pytest

import mahlwerk

CASE = """
title = "Lifters that wear"
[mill]
kind = "tumbling"
speed = "90 rpm"
[jar]
kind = "periodic-lifter-cylinder"
diameter = "60 mm"
length = "20 mm"
lifters = 6
lifter_height = "5 mm"
lifter_width = "8 mm"
lifter_face_angle = "75 deg"
hardness = 200
[[balls]]
count = 12
diameter = "8 mm"
density = "7850 kg/m3"
hardness = 400
[contact]
restitution = 0.5
friction = 0.4
softening = 1e-3
[wear]
coefficient = 1e-2
evolve = "6000 h"
make_up = true
scrap_size = "4 mm"
[run]
engine = "soft"
time = "0.1 s"
settle = "0.1 s"
replicates = 2
sensitivity = "off"
"""
HOUR = 3600


@pytest.fixture
def evolution():
    return mahlwerk.Case.from_text(CASE).evolve_wear("worn")


def area(corners):
    x, y = corners.T
    return 0.5 * np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))


def test_the_tables_of_an_evolution_agree_with_each_other(evolution):
    table, sizes = evolution.table, evolution.ball_sizes
    assert evolution.complete and len(evolution) == len(table) > 2
    assert table["time_s"][-1] == 6000 * HOUR and table["duration_s"][-1] == 0
    assert np.allclose(np.cumsum(table["duration_s"])[:-1], table["time_s"][1:], rtol=1e-12)
    lost = [6 * 0.02 * (area(evolution.profile(0)) - area(evolution.profile(k))) for k in range(len(table))]
    assert np.allclose(lost, table["lost_parts_m3"], rtol=1e-9, atol=1e-18), "rows and length times the area (wea.12)"
    worn = np.cumsum(table["wear_rate_balls_kg_per_s"] * table["duration_s"])[:-1] / 7850
    assert np.allclose(worn, table["lost_balls_m3"][1:], rtol=1e-9), "wear_rate_balls of the runs"
    for stage in range(len(table)):
        rows = sizes[sizes["stage"] == stage]
        volumes = np.pi / 6 * rows["number"] * rows["diameter_m"] ** 3
        assert np.isclose(volumes.sum(), table["ball_volume_m3"][stage], rtol=1e-12)
        assert np.isclose(table["ball_volume_m3"][stage], 12 * np.pi / 6 * 8e-3 ** 3, rtol=1e-12), "make-up keeps it"
        below = [volumes[rows["diameter_m"] <= d].sum() / volumes.sum() for d in rows["diameter_m"]]
        assert np.allclose(below, rows["mass_not_above"], rtol=1e-12)


def test_the_life_of_a_profile_is_where_its_height_crosses_the_half(evolution):
    table = evolution.table
    life, extrapolated = evolution.lives["lifters"]
    height, time_of = table["height_lifters_m"], table["time_s"]
    assert height[0] == pytest.approx(5e-3, rel=1e-12)
    assert extrapolated == (height[-1] > 2.5e-3)
    if extrapolated:
        rate = (height[-2] - height[-1]) / (time_of[-1] - time_of[-2])
        assert life == pytest.approx(time_of[-2] + (height[-2] - 2.5e-3) / rate)


def test_each_stage_is_a_result_with_its_shapes(evolution):
    for stage in (0, -1):
        result = evolution[stage]
        assert result["dissipated_power"].value == pytest.approx(evolution.table["dissipated_power_W"][stage])
        assert "evolve" not in result.case.text
    assert isinstance(mahlwerk.open("worn"), mahlwerk.WearEvolution)
    with pytest.raises(KeyError):
        evolution.profile(0, "shaft")
    assert "<svg" in evolution.report or "data-" in evolution.report or len(evolution.report) > 10_000


def test_a_case_that_evolves_is_no_single_run():
    case = mahlwerk.Case.from_text(CASE)
    with pytest.raises(mahlwerk.InputError, match="single run"):
        case.run()
    with pytest.raises(mahlwerk.InputError, match="no time of operation"):
        mahlwerk.Case.from_text(CASE.replace('evolve = "6000 h"', "").replace("make_up = true", "")
                                .replace('scrap_size = "4 mm"', "")).evolve_wear("x")


@pytest.mark.parametrize("changes, words", [
    ({"run.engine": "lammps"}, "lammps"), ({"run.engine": "event"}, "event engine"),
    ({"observe.collisions": True}, "every collision")])
def test_what_cannot_evolve_is_refused_by_name(changes, words):
    with pytest.raises(mahlwerk.InputError, match=words):
        mahlwerk.Case.from_text(CASE).replace(changes).evolve_wear("x")


def test_an_evolution_that_was_killed_goes_on_with_the_same_bits(program):
    with open("worn.toml", "w") as file:
        file.write(CASE)
    words = [os.environ["MAHLWERK_PROGRAM"], "run", "worn.toml", "--set", "run.time=0.5 s", "--quiet", "--out"]
    assert subprocess.run([*words, "whole"], check=False).returncode == 0
    running = subprocess.Popen([*words, "part"])
    for _ in range(600):
        if os.path.exists("part/stage-001"):
            break
        time.sleep(0.05)
    running.send_signal(signal.SIGKILL)
    running.wait()
    first = os.stat("part/stage-000/summary.json").st_mtime_ns
    assert subprocess.run([*words, "part"], check=False).returncode == 0
    assert os.stat("part/stage-000/summary.json").st_mtime_ns == first, "a stage that ended is not run again"
    for name in ("wear_evolution.csv", "wear_profile.csv", "wear_ball_sizes.csv", "wear_spectra.csv"):
        with open(f"whole/{name}") as one, open(f"part/{name}") as other:
            assert one.read() == other.read()
    code, _, said = program("run", "worn.toml", "--seed", "3", "--out", "part", "--json")
    assert code == 2 and said["faults"][0]["code"] == "bad-checkpoint"
