# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""What a session says to usual mistakes."""
from pathlib import Path

import numpy as np
import pytest

import mahlwerk
from mahlwerk import toml


@pytest.fixture
def result(ball):
    return ball.replace({"run.time": "0.2 s", "run.settle": "0 s"}).run()


def test_a_dict_gives_values_of_a_section(ball):
    ball["contact"] = {"restitution": 0.6, "friction": np.float32(0.25)}
    assert ball["contact.restitution"] == "0.6" and ball["contact.tangential_restitution"] == "0.9"
    assert mahlwerk.Case({"mill": {"kind": "still"}, "jar": {"kind": "sphere", "diameter": "3 cm"}, "balls": [
        {"count": 1, "diameter": "8 mm", "density": "7850 kg/m3"}], "run": {"time": "1 s"}}, {"run": {"time": "2 s"}})["run.time"] == "2 s"
    with pytest.raises(mahlwerk.InputError, match="did you mean `restitution`"):
        ball["contact"] = {"restitutio": 0.6}


def test_a_path_is_a_value(ball):
    with pytest.raises(mahlwerk.InputError, match="no-such.stl"):
        ball["jar"] = {"kind": "mesh", "file": Path("no-such.stl"), "unit": "mm", "diameter": None, "volume": None}
    assert toml.value_text([Path("a"), "b"]) == '["a", "b"]'


@pytest.mark.parametrize("wrong", [None, 3, [1]])
def test_what_is_no_case_is_named(wrong):
    with pytest.raises(TypeError, match="a case is a file, a folder or a dict of sections"):
        mahlwerk.run(wrong)


def test_a_result_in_the_place_of_a_case_says_where_its_case_is(result):
    with pytest.raises(TypeError, match="`.case`"):
        mahlwerk.run(result)


def test_a_section_in_the_place_of_a_key_names_its_keys(ball):
    with pytest.raises(KeyError, match="mill is a section: .*mill.frequency"):
        ball["mill"]
    with pytest.raises(TypeError, match="a key is a text"):
        ball.replace({3: "1"})


def test_a_quantity_says_how_to_compute_with_it(result):
    power = result["drawn_power"]
    assert f"{power:.3f}" == f"{power.value:.3f}" and f"{power}" == str(power)
    for wrong in (lambda: 2 * power, lambda: power + power, lambda: power < 3, lambda: np.float64(2) * power, lambda: -power):
        with pytest.raises(TypeError, match="float.q., or with both, q.ufloat"):
            wrong()


def test_a_session_shows_names_and_numbers_in_few_lines(ball, result):
    assert len(repr(ball.check())) < 100 and "peak_wall_speed" in str(ball.check())
    assert repr(result.tables).startswith("<Tables spectrum")
    assert all(not name.startswith("_") for name in dir(result.plot))


def test_numbers_of_threads_and_observers_are_checked(ball):
    with pytest.raises(TypeError, match="threads is a whole number, not '8'"):
        ball.run(threads="8")
    with pytest.raises(TypeError, match="an observer is a function"):
        ball.run(observers=[3])
    seen = []
    ball.replace({"run.time": "0.2 s"}).run(observers=lambda records, replicate: seen.append(len(records)))
    assert sum(seen) > 0


def test_frames_are_rows_of_balls_and_times(ball):
    made = ball.replace({"run.time": "0.1 s", "run.settle": "0 s", "observe.frames": "20 ms"}).run("out")
    rows = made.frames(2)
    assert len(rows) == len(np.unique(rows["time_s"])) and (rows["radius_m"] == 4e-3).all()
    first = open("out/frames-2.xyz", encoding="utf-8").readlines()[2].split()
    assert [rows[name][0] for name in ("x_m", "y_m", "z_m")] == [float(one) for one in first[2:5]]
    with pytest.raises(mahlwerk.InputError, match="no frames of replicate 3"):
        made.frames(3)
