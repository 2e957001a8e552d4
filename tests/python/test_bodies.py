# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Balls that are no spheres: a drum of cylpebs as a user runs it."""
import copy

import pytest

import mahlwerk

DRUM = {
    "title": "cylpebs", "seed": 1, "mill": {"kind": "tumbling", "speed": "60 %"},
    "jar": {"kind": "cylinder", "diameter": "120 mm", "height": "50 mm"},
    "balls": [{"shape": "cylpebs", "diameter": "12 mm", "length": "12 mm", "density": "7800 kg/m3", "count": 60,
               "spheres": 21}],
    "contact": {"restitution": 0.6, "friction": 0.4, "rolling_friction": 0.01, "softening": 1e-3},
    "run": {"engine": "auto", "time": "0.2 s", "settle": "0.1 s", "replicates": 1},
    "observe": {"frames": "50 ms", "collisions": True}}


def drum(changes=None):
    return mahlwerk.Case(copy.deepcopy(DRUM), changes=changes or {})


def test_drum_of_cylpebs_runs_and_its_books_close(tmp_path):
    result = drum().run(out=tmp_path / "out")
    assert abs(result["energy_balance"].value) < 2e-3
    records = result.collisions()
    assert set(records["ball"]) <= set(range(1, 61)) | set(range(60))
    # Two bodies may touch at several points; a body does not touch itself.
    assert (records["ball"] != records["other"]).all()


def test_frames_have_the_spheres_of_each_body(tmp_path):
    drum().run(out=tmp_path / "out")
    lines = (tmp_path / "out" / "frames-1.xyz").read_text().splitlines()
    assert int(lines[0]) == 60 * 21
    assert ":body:I:1:orientation:R:4" in lines[1]
    columns = lines[2].split()
    assert int(columns[-5]) == 1
    assert abs(sum(float(q) ** 2 for q in columns[-4:]) - 1) < 1e-12
    assert "Name=\"orientation\"" in (tmp_path / "out" / "frames-1" / "balls-00000.vtp").read_text()


def test_event_engine_refuses_them():
    with pytest.raises(mahlwerk.InputError) as refused:
        drum({"run.engine": "event"}).run()
    assert "spheres only" in str(refused.value)


def test_a_finer_clump_has_the_same_mass():
    coarse, fine = drum(), drum({"balls.1.spheres": 47})
    a, b = coarse.check(), fine.check()
    for name in ("total_ball_mass", "equivalent_diameter"):
        assert a.derived[name].value == b.derived[name].value
    assert b.derived["scale_of_spheres"].value < a.derived["scale_of_spheres"].value
