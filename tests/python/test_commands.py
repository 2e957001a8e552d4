# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""sweep, fit, optimise, match, compare, and opening what the command line wrote."""
import json
import shutil

import numpy as np
import pytest

import mahlwerk

from conftest import HOME

FAST = {"run.time": "0.2 s", "run.settle": "0 s", "run.replicates": 2}
SETS = [word for key, value in FAST.items() for word in ("--set", f"{key}={value}")]


def equal_tables(one, other):
    assert one.dtype.names == other.dtype.names
    for name in one.dtype.names:
        if not name.endswith("_seconds"):
            np.testing.assert_array_equal(one[name], other[name], name)


def test_a_sweep_is_the_campaign_of_the_command_line(example, program):
    assert program("sweep", example("09-campaign"), *SETS, "--out", "there", "--quiet")[0] == 0
    here = mahlwerk.Case(example("09-campaign"), FAST).sweep(out="here")
    there = mahlwerk.open("there")
    equal_tables(here.table, there.table)
    assert len(here) == 16 and {k.key for k in here.keys} == {"mill.speed", "mill.ratio"}
    assert here[0].quantities["dissipated_power"].value == here.column("dissipated_power")[0]
    assert here[-1].case["mill.speed"] == "800 rpm"
    assert mahlwerk.open("there/campaign.sqlite").title == here.title
    assert here.warnings and here.failed == [] and here.unit("dissipated_power") == "W"
    # What exists is not computed again.
    before = here.table["wall_seconds"].tolist()
    again = mahlwerk.Case(example("09-campaign"), FAST).sweep(out="here")
    assert again.table["wall_seconds"].tolist() == before
    with pytest.raises(KeyError, match="did you mean dissipated_power"):
        here.column("dissipated_powr")
    with pytest.raises(IndexError):
        here[16]


def test_a_case_from_python_sweeps_and_its_case_stays_beside_the_folder(ball):
    over = {"mill.frequency": {"from": "10 Hz", "to": "12 Hz", "steps": 3}}
    campaign = ball.sweep(over, "out/here")
    assert campaign.column("mill.frequency").tolist() == [10, 11, 12]
    assert "[sweep]" in open("out/here.case.toml", encoding="utf-8").read()
    with pytest.raises(mahlwerk.InputError) as caught:
        ball.sweep(over)
    assert caught.value.faults[0].code == "no-folder"
    with pytest.raises(mahlwerk.InputError) as caught:
        ball.sweep(out="none")
    assert caught.value.faults[0].code == "no-sweep"
    with pytest.raises(mahlwerk.InputError, match="frequenzy"):
        ball.sweep({"mill.frequenzy": ["1 Hz"]}, "none")


def test_a_surrogate_is_that_of_the_command_line(example, program):
    campaign = mahlwerk.Case(example("09-campaign"), FAST).sweep(out="here")
    here = campaign.surrogate("here.json")
    assert program("surrogate", "here", "--out", "there.json", "--quiet")[0] == 0
    assert open("here.json").read() == open("there.json").read()
    assert here.keys == {"mill.speed": ("200 rpm", "800 rpm"), "mill.ratio": ("-3", "-1.5")}
    setting = {"mill.speed": "500 rpm", "mill.ratio": -2.2}
    power = here(setting, ["dissipated_power"])
    assert list(power) == ["dissipated_power"] and power["dissipated_power"].unit == "W"
    assert power["dissipated_power"].low < power["dissipated_power"].value < power["dissipated_power"].high
    assert set(here(setting)) == set(here.data["quantities"])
    with pytest.raises(mahlwerk.InputError, match="does not extrapolate"):
        here({**setting, "mill.speed": "900 rpm"})
    with pytest.raises(mahlwerk.InputError, match="--force"):
        campaign.surrogate("here.json")
    only = campaign.surrogate("here.json", ["drawn_power"], force=True)
    assert list(only.data["quantities"]) == ["drawn_power"] and "16 settings" in repr(only)


def test_searches_and_fits_are_those_of_the_command_line(example, program):
    best = example("09-campaign") + "/optimise.toml"
    few = {**FAST, "optimise.settings": 6}
    sets = [word for key, value in few.items() for word in ("--set", f"{key}={value}")]
    assert program("optimise", best, *sets, "--out", "there", "--quiet")[0] == 0
    here, there = mahlwerk.Case(best, few).optimise(out="here"), mahlwerk.open("there")
    assert here.data == there.data and here.best == there.best and here.value > 0
    equal_tables(here.table, there.table)
    assert here.case["balls.diameter"] == here.best["balls.diameter"] and here.remarks

    data = HOME / "tests/docs/cases/fit.csv"
    case = HOME / "tests/docs/cases/fit.toml"
    assert program("fit", case, data, "--out", "fit-there", "--quiet")[0] == 0
    fitted = mahlwerk.Case.fit_file(case, data, "fit-here")
    assert fitted.data == mahlwerk.open("fit-there").data
    assert fitted.parameters and fitted.case.text


def test_match_and_compare_are_those_of_the_command_line(example, program, tmp_path):
    a = mahlwerk.Case(example("03-planetary-mill"), {**FAST, "mill.speed": "300 rpm"})
    over = {"over": {"mill.speed": {"from": "200 rpm", "to": "400 rpm"}}, "settings": 4,
            "replicates": 2}
    b = mahlwerk.Case(example("03-planetary-mill"), FAST)
    match = b.match(a, over, "match")
    assert set(match.best) == {"mill.speed"} and 0 <= match.data["overlap"] <= 1
    assert match.a.case["mill.speed"] == "300 rpm" and match.b["dissipated_power"].value > 0
    assert mahlwerk.open("match").data == match.data
    assert not list(tmp_path.glob(".case-*")), "temporary cases are removed"

    few = {"run.time": "0.5 s"}
    assert program("compare", example("01-one-ball"), "--set", "run.time=0.5 s", "--out", "there",
                   "--quiet")[0] == 0
    found = mahlwerk.Case(example("01-one-ball"), few).compare("here")
    there = mahlwerk.open("there").table
    one, other = (t[t["quantity"] != "computing_time"] for t in (found.table, there))
    equal_tables(one, other)
    assert (found.event.engine, found.soft.engine) == ("event", "soft")
    assert found.data["study"] == "compare" and "How to read it" in found.data["remarks"][-1]
    power = found.table[found.table["quantity"] == "dissipated_power"]
    assert found.data["quantities"]["dissipated_power"]["event"] == power["event"][0]
    (found.folder / "compare.json").unlink()  # as in folders of older versions
    assert len(mahlwerk.open("here").table) == len(found.table)


def test_opening_something_else_is_refused(tmp_path):
    for place in (tmp_path, tmp_path / "none"):
        with pytest.raises(mahlwerk.InputError) as caught:
            mahlwerk.open(place)
        assert caught.value.faults[0].code == "no-result"
    for kind in (mahlwerk.Result, mahlwerk.Campaign, mahlwerk.Fit, mahlwerk.Comparison):
        with pytest.raises(mahlwerk.InputError):
            kind(tmp_path)


def test_the_catalogue_is_that_of_the_command_line(program):
    assert mahlwerk.catalogue("mills") == json.loads(program("list", "mills", "--json")[1])
    assert mahlwerk.describe("retsch-mm400") == json.loads(
        program("describe", "retsch-mm400", "--json")[1])
    with pytest.raises(mahlwerk.InputError, match="did you mean"):
        mahlwerk.describe("retsch-mm40")


def test_a_damaged_result_is_not_read_silently(ball):
    ball.run("out")
    shutil.copytree("out", "bad")
    open("bad/summary.json", "w").write("{")
    with pytest.raises(ValueError):
        mahlwerk.open("bad").quantities


def test_a_campaign_of_another_case_is_not_replaced(ball):
    over = {"mill.frequency": ["10 Hz", "11 Hz"]}
    open("mine.case.toml", "w").write("precious")
    with pytest.raises(mahlwerk.InputError) as caught:
        ball.sweep(over, "mine")
    assert caught.value.faults[0].code == "other-campaign"
    assert open("mine.case.toml").read() == "precious"
    first = ball.sweep(over, "out")
    with pytest.raises(mahlwerk.InputError) as caught:
        ball.replace({"jar.diameter": "13 mm"}).sweep({"seed": [1]}, "out")
    assert caught.value.faults[0].code == "other-campaign"
    equal_tables(mahlwerk.open("out").table, first.table)
    with pytest.raises(mahlwerk.InputError):
        ball.sweep({"mill.frequency": ["10 mm"]}, "refused")
    import os
    assert not os.path.exists("refused.case.toml")


def test_a_key_that_was_set_may_be_swept(ball):
    ball["mill.frequency"] = "12 Hz"
    assert ball.sweep({"mill.frequency": ["10 Hz", "11 Hz"]}, "out").column(
        "mill.frequency").tolist() == [10, 11]
    swept = mahlwerk.Case("out.case.toml")
    with pytest.raises(mahlwerk.InputError, match="already"):
        swept.sweep({"mill.frequency": ["10 Hz"]}, "again")


def test_options_have_the_names_of_the_command_line_and_others_are_refused():
    from mahlwerk.commands import command
    assert command(["list"], category="mills") == mahlwerk.catalogue("mills")
    for name in ("jobs", "threads"):  # --jobs,--threads
        with pytest.raises(TypeError, match=f"{name} is a whole number, not 'two'"):
            command(["compare"], case="none", **{name: "two"})
    with pytest.raises(KeyError, match="no command swep; did you mean sweep"):
        command("swep")
    with pytest.raises(TypeError, match="no option thread; did you mean threads"):
        command("run", thread=2)
    with pytest.raises(TypeError, match="frequency is a text, a quantity with its unit, not 30"):
        mahlwerk.estimate("MM 400", balls="2x10mm", frequency=30)
    with pytest.raises(TypeError, match="balls are texts"):
        mahlwerk.estimate("MM 400", balls=2)
    with pytest.raises(TypeError, match="mahlwerk list has no option target"):
        command(["list"], target="mills")
    with pytest.raises(TypeError, match="mahlwerk new has no option json"):
        command(["new"], json=True)
    with pytest.raises(TypeError, match="set is a text"):
        command(["check"], case="none", set={"run.replicates": 2})
    with pytest.raises(mahlwerk.InputError, match="there is no such file"):
        command(["match"], case="none", in_="none", out=None)


def test_values_that_the_command_line_refuses_are_refused(ball):
    from mahlwerk.commands import command
    for threads in (-3, 4097):
        with pytest.raises(ValueError, match=f"threads is from 1 to 4096, or 0 for the default, not {threads}"):
            ball.sweep({"mill.frequency": ["10 Hz"]}, "out", threads=threads)
    for seconds in (-1.0, 0.0, float("nan"), 1e9):
        with pytest.raises(ValueError, match="checkpoint is a number of seconds above 0"):
            command(["run"], case="none", checkpoint=seconds)
    with pytest.raises(ValueError, match="shell is one of bash, zsh, not 'fish'"):
        command(["completion"], shell="fish")


def test_an_estimate_is_that_of_the_command_line(program):
    words = ["MM 400", "--jar", "25ml", "--material", "ZrO2", "--frequency", "30Hz", "--powder", "200mg",
             "--balls", "2x10mm", "--balls", "1x5mm", "--set", "seed=2"]
    code, told = program("estimate", *words, "--json")[:2]
    assert code == 0
    here = mahlwerk.estimate("MM 400", jar="25ml", material="ZrO2", frequency="30Hz", powder="200mg",
                             balls=["2x10mm", "1x5mm"], set={"seed": 2})
    assert here.data == json.loads(told)
    power = here["dissipated_power"]
    assert power.low < float(power) < power.high and power.unit == "W"
    assert power.causes[0].key.startswith(("contact.", "mill."))
    assert here.case["seed"] == "2" and "retsch-mm400" in here.case["mill.model"]
    assert here.notices[0].code == "assumed-mill" and "wide because of" in here._repr_html_()
    with pytest.raises(mahlwerk.InputError, match="give --frequency"):
        mahlwerk.estimate("MM 400", balls="2x10mm", material="ZrO2")
