# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""A bed has a known packing fraction, and flow keeps number and mass of balls."""
import copy
import math
import re

import mahlwerk
import numpy as np
import pytest
from mahlwerk.replay import replay

from quantity_runs import CASES, run_of


def test_a_random_bed_in_a_thin_slice_has_its_packing_fraction():
    """Without friction, balls come to rest in random close packing, 0.637 (Scott and Kilgour 1969). The places hold
    some five separate spheres, whose packing scatters by about 0.03."""
    run = run_of("packed")
    assert run["packing_fraction"] == pytest.approx(0.637, abs=0.015)
    profile = run.result.table("packing_profile")
    mean = np.average(profile["packing_fraction"], weights=profile["points"])
    assert mean == pytest.approx(run["packing_fraction"], abs=0.005)  # samples differ in their number of points


def test_flow_keeps_the_number_and_the_mass_of_balls():
    """Inside + left - entered is the same in every row (flo.2), and balls stay as long as Little's law says (flo.5)."""
    run = run_of("hopper")
    table = run.result.table("flow")
    assert np.ptp(table["inside"] + table["left"] - table["entered"]) == 0
    assert np.ptp(table["mass_inside_kg"] + table["mass_left_kg"] - table["mass_entered_kg"]) < 1e-12
    left = table["left"][-1]
    print(f"{left:.0f} left; residence times {run['residence_time']:.4g} s, {run['tracer_residence_time']:.4g} s")
    assert left > 100
    # The mean of n tracers is off by spread/sqrt(n); what is inside at the ends counts half a residence time each.
    tolerance = 3 * run["residence_time_spread"] / math.sqrt(left) + run["residence_time"]**2 / run.time / 2
    assert run["tracer_residence_time"] == pytest.approx(run["residence_time"], abs=tolerance)



def fed(count, flow, **run):
    """Balls of 3 mm that wait outside an empty jar, enter at its middle at most 200 a second, and fall 22 mm to the outlet."""
    case = copy.deepcopy(CASES["hopper"])
    case["balls"][0]["count"] = count
    case["flow"] |= {"feed": "rate", "feed_rate": "200 1/s", "fresh_feed": ["balls.1"], **flow}
    case["flow"] = {key: value for key, value in case["flow"].items() if value is not None}
    case["run"] |= {"settle": "0 s", **run}
    return mahlwerk.Case({"title": "fed", **case}).run()


def told(result, code):
    return [one.text for one in result.notices if one.code == code]


def test_a_fresh_feed_is_counted_and_its_end_is_told():
    """60 balls at 200 a second last 0.3 s: the last enters 0.295 s after the first."""
    result = fed(60, {}, time="0.6 s")
    table = result.table("flow")
    assert table["entered"][-1] == 60
    assert np.all(table["inside"] == table["entered"] - table["left"])
    text, = told(result, "feed-exhausted")
    assert re.search(r"used up 0.29[56]", text), text
    assert not told(fed(60, {"recirculate": True}, time="0.6 s"), "feed-exhausted")


def test_an_inlet_that_limits_the_flow_is_told():
    """Through a point, one ball of 3 mm enters each time the one before has fallen 3 mm: 40 a second."""
    point = {"inlet_size": ["0 mm", "0 mm", "0 mm"]}
    result = fed(60, point, time="0.5 s")
    rate = math.sqrt(9.81 / (2 * 3e-3))
    assert result["feed_rate"].value == pytest.approx(rate, abs=2 / 0.5)
    text, = told(result, "inlet-limits-flow")
    assert f"{100 * result['feed_rate'].value / 200:.0f} %" in text
    assert not told(fed(60, {**point, "feed_rate": "30 1/s"}, time="0.5 s"), "inlet-limits-flow")
    assert told(fed(60, {**point, "feed": "recirculate", "feed_rate": None}, time="0.2 s"), "inlet-limits-flow")


def test_a_jar_that_fills_is_told():
    """After 0.1 s of 600 balls a second, which fall for 67 ms, 60 have entered and 20 left."""
    assert told(fed(300, {"feed_rate": "600 1/s"}, time="0.1 s"), "flow-not-steady")
    assert not told(fed(300, {"feed_rate": "600 1/s"}, settle="0.1 s", time="0.3 s"), "flow-not-steady")


def test_frames_show_only_balls_in_the_jar(tmp_path):
    """As many as flow.csv has inside; each by its own number."""
    case = copy.deepcopy(CASES["hopper"])
    case["flow"] |= {"feed": "rate", "feed_rate": "200 1/s", "fresh_feed": ["balls.1"], "interval": "10 ms"}
    case["run"] |= {"settle": "0 s", "time": "0.2 s"}
    result = mahlwerk.Case({"title": "frames", **case, "observe": {"frames": "10 ms"}}).run(tmp_path / "out")
    lines = (tmp_path / "out" / "frames-1.xyz").read_text().splitlines()
    shown, at = [], 0
    while at < len(lines):
        count = int(lines[at])
        numbers = [int(line.split()[0]) for line in lines[at + 2:at + 2 + count]]
        assert len(set(numbers)) == count
        shown.append(count)
        at += 2 + count
    assert shown[0] == 0 and max(shown) > 10
    assert np.abs(np.array(shown[:20]) - result.table("flow")["inside"][:20]).max() <= 1  # a frame is a step later


def test_paths_of_balls_end_where_they_leave_the_jar():
    result = mahlwerk.Case({**CASES["hopper"], "flow": {"outlet": ["0 mm", "0 mm", "-12 mm"]},
                            "run": {**CASES["hopper"]["run"], "settle": "0 s", "time": "0.2 s"}}).run()
    film = replay(result, "jar")
    assert result.table("flow")["left"][-1] > 0
    outside = np.isnan(film["positions"]).any(axis=2)
    assert outside[-1].any() and not outside[0].any(), "balls have left by the end"
    ball = int(np.flatnonzero(outside[-1])[0])
    path = np.concatenate(result.plot.trajectory(ball, plane="xz").collections[0].get_segments())
    assert np.isfinite(path).all() and path[:, 1].min() > -12 - 1.5 - 0.5, "mm: above the outlet, within a frame"
    assert len(path) == 2 * np.isfinite(film["positions"][:-1, ball] + film["positions"][1:, ball]).all(axis=1).sum()
