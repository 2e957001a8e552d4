# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Balls that are no spheres: a drum of cylpebs as a user runs it."""
import copy

import numpy as np
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


def test_body_that_starts_outside_is_bad_input(tmp_path):
    """Its centre is inside, a sphere of it is not."""
    rods = [{"shape": "rod", "diameter": "4 mm", "length": "40 mm", "density": "7800 kg/m3",
             "positions": [[f"{x} mm", "0 mm", "0 mm"] for x in (-54, -10, 10, 54)]}]
    with pytest.raises(mahlwerk.InputError, match="starts outside the jar"):
        mahlwerk.Case(copy.deepcopy(DRUM) | {"balls": rods}).run(out=tmp_path / "out")


def test_convex_body_whose_edges_are_pressed_into_the_wall_stops(tmp_path):
    """An edge of 0.1 mm on contacts that are too soft for it: it must not sink through the floor."""
    cube = [{"shape": "cube", "surface": "convex", "edge": "10 mm", "rounding": "0.1 mm", "density": "7800 kg/m3",
             "positions": [["0 mm", "0 mm", "-15 mm"]], "velocities": [["0 m/s", "0 m/s", "-2 m/s"]]}]
    with pytest.raises(mahlwerk.RunError, match="pressed in completely"):
        mahlwerk.Case(copy.deepcopy(DRUM) | {"balls": cube, "mill": {"kind": "still"}},
                      changes={"run.settle": "0 s", "run.time": "20 ms", "contact.softening": 0.01}).run(out=tmp_path / "out")


def test_frames_have_the_spheres_of_each_body(tmp_path):
    drum().run(out=tmp_path / "out")
    lines = (tmp_path / "out" / "frames-1.xyz").read_text().splitlines()
    assert int(lines[0]) == 60 * 21
    assert ":body:I:1:orientation:R:4" in lines[1]
    columns = lines[2].split()
    assert int(columns[-5]) == 1
    assert abs(sum(float(q) ** 2 for q in columns[-4:]) - 1) < 1e-12
    assert "Name=\"orientation\"" in (tmp_path / "out" / "frames-1" / "balls-00000.vtp").read_text()


def test_shares_of_hits_are_those_of_the_records(tmp_path):
    """By number and energy (bod.16); each collision of two bodies is a hit of both."""
    result = drum().run(out=tmp_path / "out", collisions=True)
    records = result.collisions()
    energy = np.tile(records["mass"] * records["approach"]**2 / 2, 2)
    feature = np.concatenate([records["feature"], records["other_feature"]])
    assert (records["feature"] > 0).all(), "all are bodies"
    assert ((records["other_feature"] > 0) == (records["other"] >= 0)).all()
    table = result.table("body_hits")
    for code, name in ((1, "face"), (2, "edge"), (4, "side")):
        here, all_of_them = feature == code, feature > 0
        assert here.any()
        assert result[f"{name}_hit_share"].value == pytest.approx(here.sum() / all_of_them.sum(), rel=1e-12)
        share = energy[here].sum() / energy[all_of_them].sum()
        assert result[f"{name}_energy_share"].value == pytest.approx(share, rel=1e-12)
        assert table[f"power_{name}_W"].sum() == pytest.approx(energy[here].sum() / 0.2, rel=1e-6)
    assert not (feature == 3).any() and "corner_hit_share" not in result


def test_order_of_axes_is_that_of_the_frames(tmp_path):
    """Rods that nothing turns (bod.17, bod.18): the axes of the only frame are those of all samples."""
    case = copy.deepcopy(DRUM)
    case["gravity"], case["mill"] = "0 m/s2", {"kind": "still"}
    case["balls"] = [{"shape": "rod", "diameter": "4 mm", "length": "12 mm", "density": "7800 kg/m3", "count": 40,
                      "spheres": 3}]
    case["run"] = {"engine": "soft", "time": "10 ms", "settle": "0 s", "start_spin": "0 rad/s", "replicates": 1}
    case["observe"]["frames"] = "10 ms"
    result = mahlwerk.Case(case).run(out=tmp_path / "out")
    lines = (tmp_path / "out" / "frames-1.xyz").read_text().splitlines()[2:2 + 120:3]
    x, y, z, w = np.array([line.split()[-4:] for line in lines], dtype=float).T
    axes = np.stack([2 * (z * x + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)], axis=1)
    order = np.linalg.eigvalsh(1.5 * axes.T @ axes / len(axes) - 0.5 * np.eye(3)).max()
    angle = np.degrees(np.arccos(np.abs(axes[:, 2]))).mean()
    assert result["nematic_order"].value == pytest.approx(order, rel=1e-6)
    assert result["body_axis_angle"].value == pytest.approx(angle, rel=1e-6)


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
