# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""What a user sees of the package: names, completions, examples in docstrings, types."""
import doctest
import inspect
import math
import re
import shutil

import numpy as np
import pytest

import mahlwerk
from mahlwerk import plots


def own_members(thing):
    """Those of a class and of the bases that the package defines."""
    return {member: value for base in reversed(thing.__mro__) if base.__module__.startswith("mahlwerk")
            for member, value in vars(base).items()}


def documented():
    """Every public name and its public members, with their docstrings."""
    for name in mahlwerk.__all__:
        thing = getattr(mahlwerk, name)
        yield f"mahlwerk.{name}", thing
        for member, value in own_members(thing).items() if inspect.isclass(thing) else ():
            if not member.startswith("_"):
                yield f"mahlwerk.{name}.{member}", value
    for name in mahlwerk.measure.__all__:
        yield f"mahlwerk.measure.{name}", getattr(mahlwerk.measure, name)
    for owner in (plots.ResultPlots, plots.CampaignPlots):
        for member, value in vars(owner).items():
            if not member.startswith("_"):
                yield f"plots.{owner.__name__}.{member}", value


EXAMPLES = {where: inspect.getdoc(thing) for where, thing in [("mahlwerk", mahlwerk), *documented()]
            if ">>>" in (inspect.getdoc(thing) or "")}


@pytest.fixture(scope="module")
def done(tmp_path_factory):
    """A case, its result and a campaign, as the examples name them."""
    case = mahlwerk.Case({
        "title": "one ball", "seed": 1,
        "mill": {"kind": "vibration", "frequency": "10 Hz", "amplitude": "25 mm"},
        "jar": {"kind": "capsule", "diameter": "12 mm", "volume": "5 ml"},
        "balls": [{"count": 1, "diameter": "8 mm", "density": "7850 kg/m3"}],
        "contact": {"restitution": 0.9, "tangential_restitution": 0.9, "friction": 0.3},
        "run": {"engine": "event", "time": "1 s", "replicates": 4, "settle": "0 s"}})
    over = {"mill.frequency": ["10 Hz", "11 Hz", "12 Hz", "13 Hz"]}
    return {"mahlwerk": mahlwerk, "case": case, "result": case.run(),
            "campaign": case.sweep(over, tmp_path_factory.mktemp("done") / "campaign")}


@pytest.mark.parametrize("where", EXAMPLES)
def test_every_example_of_a_docstring_runs(where, done, example):
    for name in ("01-one-ball", "measure"):
        shutil.copytree(example(name), f"examples/{name}")
    names = dict(done)
    for one in doctest.DocTestParser().get_examples(EXAMPLES[where]):
        exec(compile(one.source, where, "exec"), names)  # an exception is a fault


def test_the_main_classes_have_examples():
    for name in ("Case", "Result", "Campaign", "Quantity", "Surrogate", "estimate"):
        assert f"mahlwerk.{name}" in EXAMPLES, name


def test_dir_shows_public_names_alone(done):
    assert sorted(dir(mahlwerk)) == sorted([*mahlwerk.__all__, "__version__", "measure", "papers"])
    for thing, name in ((done["case"], "replace"), (done["result"], "quantities"), (done["campaign"], "frame"),
                        (done["result"]["collision_rate"], "ci95")):
        assert name in dir(thing) and not [one for one in dir(thing) if one.startswith("_")]


def test_notebooks_complete_quantities_keys_and_tables(done):
    result = done["result"]
    assert "dissipated_power" in result._ipython_key_completions_()
    assert "mill.frequency" in done["case"]._ipython_key_completions_()
    assert "spectrum" in done["campaign"][0].tables._ipython_key_completions_()


def test_public_signatures_name_their_types():
    """`dict[str, Any]`, and what command() returns, is a document of JSON, whose content formats.md describes."""
    for where, thing in documented():
        thing = thing.fget if isinstance(thing, property) else getattr(thing, "func", thing)
        if inspect.isfunction(thing):
            said = str(inspect.signature(thing)).replace("dict[str, Any]", "")
            if thing is mahlwerk.command:
                said = said.replace("-> 'Any'", "")
            assert not re.search(r"\bAny\b", said), f"{where}{said}"


def test_a_command_is_a_function_of_a_case_a_file_and_a_dict(done, example):
    case = done["case"]
    assert mahlwerk.run(case)["collision_rate"] == done["result"]["collision_rate"]
    assert mahlwerk.check(example("01-one-ball")).derived["ball_count"].value == 1
    assert mahlwerk.check(example("01-one-ball") + "/case.toml").derived.keys() == mahlwerk.Case(example("01-one-ball")).check().derived.keys()
    assert "Mahlwerk" in mahlwerk.cite({"mill": {"kind": "still"}, "jar": {"kind": "sphere", "diameter": "3 cm"},
                                        "balls": [{"count": 1, "diameter": "8 mm", "density": "7850 kg/m3"}],
                                        "run": {"time": "1 s"}}).text
    campaign = mahlwerk.sweep(case, {"mill.frequency": ["10 Hz", "11 Hz"]}, "speeds")
    assert len(campaign) == 2
    assert list(inspect.signature(mahlwerk.run).parameters)[:2] == ["case", "out"]
    with pytest.raises(mahlwerk.InputError):
        mahlwerk.run("nowhere")


def test_values_are_taken_from_a_case(done):
    case = done["case"]
    without = case.without("contact.restitution")
    assert case["contact.restitution"] == "0.9" and without.origin("contact.restitution").assumed
    changed = case.replace({"contact.restitution": 0.4})
    del changed["contact.restitution"]
    assert changed.origin("contact.restitution").assumed, "neither the change nor the value of the text counts"
    added = case.replace({"observe.threshold": "0.2 m/s"}).without("observe.threshold")
    assert added == case, "a value that only a change gave is gone with it"
    assert mahlwerk.Case(example_with_powder(), {"powder": None}) == mahlwerk.Case(example_with_powder(powder=False))
    with pytest.raises(mahlwerk.InputError, match="did you mean contact.restitution") as caught:
        case.without("contact.restituiton")
    assert caught.value.faults[0].where == "--unset contact.restituiton"


def example_with_powder(powder=True):
    sections = {"title": "x", "mill": {"kind": "still"}, "jar": {"kind": "sphere", "diameter": "3 cm"},
                "balls": [{"count": 1, "diameter": "8 mm", "density": "7850 kg/m3"}], "run": {"time": "1 s"}}
    return {**sections, "powder": {"mass": "1 g"}} if powder else sections


def test_a_campaign_remembers_what_was_taken_from_its_case(done, program):
    case = done["case"].without("contact.restitution")
    case.sweep({"mill.frequency": ["10 Hz", "11 Hz"]}, "taken")
    code, _, said = program("sweep", "retry", "taken", "--json")
    assert code == 0, said
    assert mahlwerk.open("taken")[0].case.origin("contact.restitution").value == "0.8"


def test_the_standard_error_is_that_of_the_replicates(done):
    """s / sqrt(n) of the values in the replicates; half-width = t(0.975, n - 1) times it (sta.2)."""
    result = done["result"]
    values = result.table("replicates")["collision_rate_per_s"]
    expected = np.std(values, ddof=1) / math.sqrt(len(values))
    found = result["collision_rate"]
    print(f"expected {expected}, found {found.standard_error}")
    assert math.isclose(found.standard_error, expected, rel_tol=1e-9)
    assert math.isclose(found.ci95 / found.standard_error, 3.182446305284263, rel_tol=1e-6), "t(0.975, 3)"
    low, high = found.interval
    assert low == max(found.value - found.ci95, 0) and high == found.value + found.ci95
    share = result["contact_time_share"]
    assert 0 <= share.interval[0] <= share.interval[1] <= 1


def test_numbers_with_errors_compute(done):
    pytest.importorskip("uncertainties")
    result = done["result"]
    rate = result["collision_rate"].ufloat()
    assert math.isclose((2 * rate).std_dev, 2 * result["collision_rate"].standard_error)
    power, drawn = result.ufloats("dissipated_power", "drawn_power")
    assert math.isclose(power.std_dev, result["dissipated_power"].standard_error, rel_tol=1e-9)
    again, = result.ufloats("dissipated_power")
    assert math.isclose((power - 0 * drawn).std_dev, again.std_dev, rel_tol=1e-6)
    table = result.table("replicates")
    each = table["drawn_power_W"] - table["dissipated_power_W"]
    expected = np.std(each, ddof=1) / math.sqrt(len(each))
    found = (drawn - power).std_dev
    print(f"difference over replicates: expected {expected}, found {found}")
    assert math.isclose(found, expected, rel_tol=1e-6), "linear: the difference in each replicate says the same"
    with pytest.raises(ValueError, match="replicates"):
        done["case"].replace({"run.replicates": 1}).run().ufloats("drawn_power")


def test_maps_spectra_and_sweeps_are_datasets(done):
    pytest.importorskip("xarray")
    result, table = done["result"], done["result"].table("wall_map")
    side = result.dataset("wall_map", part="side")
    assert set(side.sizes) == {"angle_rad", "across_m"}
    assert math.isclose(float(side["power_normal_W"].sum()), table[table["part"] == "side"]["power_normal_W"].sum())
    row = table[(table["part"] == "side")][100]
    middle = {"angle_rad": (row["angle_low_rad"] + row["angle_high_rad"]) / 2,
              "across_m": (row["across_low_m"] + row["across_high_m"]) / 2}
    assert float(side["rate_per_s"].sel(middle)) == row["rate_per_s"]
    with pytest.raises(ValueError, match="choose one part: bottom"):
        result.dataset("wall_map")
    with pytest.raises(ValueError, match="no row has part = 'lid'"):
        result.dataset("wall_map", part="lid")
    assert list(result.dataset("spectrum").sizes) == ["energy_J"]
    campaign = done["campaign"]
    power = campaign.dataset()["dissipated_power"]
    assert power.dims == ("mill.frequency",) and power.attrs["units"] == "W"
    assert list(power.values) == list(campaign.column("dissipated_power"))
    assert list(campaign.dataset()["mill.frequency"].values) == list(campaign.column("mill.frequency"))


def test_a_campaign_over_two_keys_is_a_grid(done):
    pytest.importorskip("xarray")
    found = done["case"].replace({"run.time": "0.2 s"}).sweep(
        {"mill.frequency": ["10 Hz", "11 Hz"], "mill.amplitude": ["20 mm", "25 mm", "30 mm"]}, "grid")
    data = found.dataset()
    assert dict(data.sizes) == {"mill.frequency": 2, "mill.amplitude": 3}
    for i in range(len(found)):
        place = {key: found.column(key)[i] for key in data.sizes}
        assert float(data["drawn_power"].sel(place)) == found.column("drawn_power")[i]
