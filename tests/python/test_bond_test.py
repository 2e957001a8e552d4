# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""What `mahlwerk bond-test` tells beside its work index."""
import json
import math
import re

import pytest

import mahlwerk

from conftest import HOME

SHORT = ["--set", "run.time=0.3 s", "--set", "run.settle=0.1 s", "--set", "run.replicates=1"]


@pytest.fixture
def bond(program):
    """Runs bond-test on the case of the how-to, for a third of a second."""
    text = (HOME / "docs" / "howto" / "bond.md").read_text(encoding="utf-8")
    with open("bond.toml", "w", encoding="utf-8") as case:
        case.write(re.search(r"```toml\n(.*?)```", text, re.DOTALL).group(1))
    return lambda *words: program("bond-test", "bond.toml", *SHORT, *words)


def test_the_notices_of_the_run_and_the_largest_ball_are_in_text_and_json(bond):
    text = bond()[1]
    assert "Largest ball" not in text
    code, told, _ = bond("--json", "--mill-diameter", "4m", "--mill-speed", "75%")
    assert code == 0
    told = json.loads(told)
    assert any(one["severity"] == "warning" for one in told["notices"])
    assert len({one["code"] for one in told["notices"]}) == len(told["notices"])
    for one in told["notices"]:
        assert text.count(one["text"]) == 1, one["code"]
        assert (f"Warning: {one['text']}" in text) == (one["severity"] != "note")
    ball = told["largest_ball"]
    assert ball["mill_diameter_m"] == 4 and ball["mill_speed"] == 0.75
    turns = 0.75 * (2 * 9.80665 / 4)**0.5 * 60 / (2 * math.pi)  # [rpm]
    # (bnd.5); the density of quartz, 2.65 t/m3, is known to 1 %, whose power 0.4 makes 0.4 %.
    azzaroni = (4.5e-3 * (1e6 * told["f80_m"])**0.263 * (2.65 * told["work_index"]["value"])**0.4
                / (turns * 4)**0.25)
    assert ball["azzaroni_m"] == pytest.approx(azzaroni, rel=0.01)


def test_the_function_of_python_tells_the_same_in_a_shorter_run(bond):
    assert bond("--screen", "1 km")[0] == 2  # the case is written, nothing runs
    case = mahlwerk.Case("bond.toml", {"run.time": "20 ms", "run.settle": "0 s", "run.replicates": 1})
    found = mahlwerk.bond_test(case, mill_diameter="4 m")
    told = found.data
    assert found.work_index.value == told["work_index"]["value"] and found.work_index.unit == "kWh/t"
    assert found.frame()["g_per_turn"].tolist() == [one["g_per_turn"] for one in told["cycles"]]
    assert found.largest_ball.azzaroni == told["largest_ball"]["azzaroni_m"] and found.notices
    with pytest.raises(mahlwerk.InputError, match="--screen"):
        mahlwerk.bond_test("bond.toml", screen="1 km")


@pytest.mark.parametrize("speed", ["100%", "1.2", "150 %"])
def test_a_mill_that_centrifuges_is_refused_before_the_run(bond, speed):
    code, text, said = bond("--json", "--mill-diameter", "4m", "--mill-speed", speed)
    assert code == 2 and text == ""
    assert said["faults"][0]["where"] == "--mill-speed" and "centrifuges" in said["faults"][0]["remedy"]


@pytest.mark.parametrize("option, value, words", [
    ("--mill-diameter", "1e9m", "100 mm to 20 m"), ("--mill-diameter", "9 cm", "100 mm to 20 m"),
    ("--mill-speed", "1%", "10 % to 99 %"), ("--load", "0%", "10 % to 1000 %"), ("--load", "1e9", "10 % to 1000 %"),
    ("--screen", "1 km", "10 um to 5 mm"), ("--screen", "nan m", "10 um to 5 mm"), ("--screen", "150 rpm", "10 um to 5 mm")])
def test_sizes_that_no_such_test_has_are_refused_before_the_run(bond, option, value, words):
    code, text, said = bond("--json", option, value)
    assert code == 2 and text == ""
    fault, = said["faults"]
    assert fault["where"] == option and fault["code"] == "bad-command-line" and fault["remedy"]
    assert fault["what"].endswith(words), fault["what"]
