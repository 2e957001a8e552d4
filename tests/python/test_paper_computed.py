# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Quantities and maps that functions of a paper.py compute from its runs."""
import math

import pytest

import mahlwerk
from mahlwerk.papers import run_paper

SWEPT = """title = "c"
seed = 1
[mill]
kind = "vibration"
frequency = "10 Hz"
amplitude = "25 mm"
[jar]
kind = "capsule"
diameter = "12 mm"
volume = "5 ml"
[[balls]]
count = 1
diameter = "8 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.9
tangential_restitution = 0.9
[run]
engine = "event"
time = "1 s"
settle = "0 s"
replicates = 2
sensitivity = "off"
[sweep]
"mill.frequency" = ["10 Hz", "20 Hz"]
"""

PAPER = """import numpy as np
from mahlwerk.papers import Paper
paper = Paper(title="T", source="S")
c = paper.campaign("c")

def doubled(result):
    rate = result["collision_rate"]
    return 2 * rate.value, 0.5

def field(result):
    return np.arange(6.0).reshape(2, 3), 1e-3

name = paper.quantity(c, "doubled_rate", doubled, unit="1/s")
paper.check("1", "it rises", c.rises(name, against="mill.frequency"))
paper.figure("1", "doubled", c.curve(name, against="mill.frequency"))
paper.figure("2", "field", c.maps(field))
"""


def folder(tmp_path, paper=PAPER):
    (tmp_path / "c.toml").write_text(SWEPT)
    (tmp_path / "paper.py").write_text(paper)
    return tmp_path


def faults(tmp_path, paper):
    with pytest.raises(mahlwerk.InputError) as refused:
        run_paper(folder(tmp_path, paper), tmp_path / "out")
    return refused.value.faults


def test_a_computed_quantity_is_drawn_and_judged_as_those_of_the_program(tmp_path):
    result = run_paper(folder(tmp_path), tmp_path / "out")
    rates = [2 * point["collision_rate"].value for point in mahlwerk.Campaign(tmp_path / "out" / "c")]
    assert result.verdicts[0].holds == "yes" and rates[0] + 1 < rates[1]
    rows = [line.split(",") for line in (tmp_path / "out/figures/figure-1.csv").read_text().splitlines()]
    assert rows[0][2:] == ["mill_frequency_Hz", "doubled_rate_per_s", "low_per_s", "high_per_s"]
    for row, rate in zip(rows[1:], rates):
        assert [float(cell) for cell in row[3:]] == pytest.approx([rate, rate - 0.5, rate + 0.5])


def test_a_map_has_a_panel_for_each_point_and_its_numbers_by_place(tmp_path):
    run_paper(folder(tmp_path), tmp_path / "out")
    held = (tmp_path / "out/figures/figure-2a.csv").read_text()
    assert held == "x_m,y_m,value\n0.0005,0.0005,0\n0.0005,0.0015,1\n0.0005,0.0025,2\n0.0015,0.0005,3\n" \
                   "0.0015,0.0015,4\n0.0015,0.0025,5\n"
    assert (tmp_path / "out/figures/figure-2b.csv").exists()
    assert "<image" in (tmp_path / "out/figures/figure-2.svg").read_text()
    assert not list((tmp_path / "out/c").glob("**/film.json")), "maps need no films of the balls"


@pytest.mark.parametrize("old, new, what", [
    ('"doubled_rate"', '"collision_rate"', "has a quantity collision_rate already"),
    ('"doubled_rate"', '"doubled rate"', "is not the name of a quantity"),
    ("2 * rate.value", "rate.valu", "doubled fails for"),
    ("np.arange(6.0)", "np.arange(7.0)", "field fails for")])
def test_a_function_that_fails_is_told_with_the_line_that_names_it(tmp_path, old, new, what):
    line = 1 + next(i for i, text in enumerate(PAPER.splitlines())
                    if text.startswith("paper.figure(\"2" if "field" in what else "name ="))
    fault = faults(tmp_path, PAPER.replace(old, new))[0]
    assert what in fault.what and fault.code == "bad-paper"
    assert fault.where == f"{tmp_path / 'paper.py'}:{line}"


def test_a_point_without_a_result_has_no_computed_value():
    from mahlwerk.papers.computed import Computed, add_computed
    from mahlwerk.papers.lines import Point, Points
    points = Points(["k"], {}, [Point(["1"], {}, {})])
    add_computed([Computed("c", "q", lambda result: (1.0, 0.0), "m", "")], points)
    assert math.isnan(points.points[0].value["q"]) and points.unit("q") == "m"
