# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Commands as functions: what they return is what the command line prints."""
import json
import re

import pytest

import mahlwerk

from conftest import HOME

MEASURED = HOME / "examples" / "measure"
#: commands that print text for a shell or a person, and the functions of others that have another name
TERMINAL = {"completion", "manual", "help"}
FUNCTIONS = {"list": "catalogue"}


def test_every_command_has_a_function(program):
    help_text = program("--help")[1]
    commands = re.findall(r"^  ([a-z-]+)  ", help_text.split("Commands:")[1], re.MULTILINE)
    assert len(commands) > 20
    for name in commands:
        if name not in TERMINAL:
            assert callable(getattr(mahlwerk, FUNCTIONS.get(name, name.replace("-", "_")), None)) or \
                name in ("measure", "papers"), name
    subcommands = re.findall(r"^  ([a-z]+)  ", program("measure", "--help")[1].split("Commands:")[1], re.MULTILINE)
    assert sorted(subcommands) == sorted(mahlwerk.measure.__all__)


def test_every_option_of_a_measurement_has_an_argument(program):
    """Outputs of the command are methods of Measurement."""
    import inspect

    outputs = {"entry", "data", "case", "set", "next", "out", "force", "jobs", "threads", "quiet", "json", "color",
               "help"}
    names = {"from": "start", "to": "end", "mark": "marks"}
    for kind in mahlwerk.measure.__all__:
        options = set(re.findall(r"--([a-z-]+)", " ".join(
            line[:30] for line in program("measure", kind, "--help")[1].splitlines()))) - outputs
        taken = set(inspect.signature(getattr(mahlwerk.measure, kind)).parameters) - {"file", "files"}
        assert {names.get(one, one.replace("-", "_")) for one in options} == taken, kind


def test_a_measurement_is_that_of_the_command_line(program, example):
    table = MEASURED / "drop-heights.csv"
    told = json.loads(program("measure", "drop", table, "--json")[1])
    drop = mahlwerk.measure.drop(table)
    assert drop.data == told and str(drop["contact.restitution"]).startswith("0.61")
    assert drop["restitution"] == drop["contact.restitution"] and float(drop["restitution"]) < 1
    with pytest.raises(KeyError, match="it has contact.restitution"):
        drop["contact.friction"]
    case = mahlwerk.Case(example("02-mixer-mill"))
    assert float(case.replace(drop.changes)["contact.restitution"]) == pytest.approx(told["values"][0]["value"])
    calibrated = drop.calibrate(case.replace({"run.time": "1 s"}), "results/dropped")
    assert calibrated["run.time"] == "1 s" and calibrated.file.name == "calibrated.toml"
    # Two rows of a table for a fit; another condition needs another table.
    drop.add_to("drops.csv", {"powder.mass": "1 g"})
    drop.add_to("drops.csv", {"powder.mass": "2 g"})
    assert len(open("drops.csv", encoding="utf-8").readlines()) == 3
    with pytest.raises(mahlwerk.InputError, match="other columns"):
        drop.add_to("drops.csv")


def test_a_measured_jar_is_an_entry_of_a_catalogue(tmp_path):
    entry = mahlwerk.measure.jar(MEASURED / "jar.csv", "capsule").save_entry(tmp_path / "my-jar.toml")
    assert "diameter" in entry.read_text(encoding="utf-8")
    with pytest.raises(mahlwerk.InputError):
        mahlwerk.measure.jar(MEASURED / "nowhere.csv", "capsule")
    with pytest.raises(ValueError, match="shape is one of"):
        mahlwerk.measure.jar(MEASURED / "jar.csv", "cube")


def test_a_result_is_exported_and_its_page_made_anew(ball):
    result = ball.run()
    with pytest.raises(mahlwerk.InputError, match="in memory"):
        mahlwerk.export(result)
    result.save("ran")
    made = mahlwerk.export(result, authors="Ada Lovelace", license="CC-BY-4.0")
    assert "Ada Lovelace" in made.read_text(encoding="utf-8")
    with pytest.raises(mahlwerk.InputError, match="description already"):
        mahlwerk.export("ran")
    copy = mahlwerk.export("ran", "copy", authors=["A B", "C D"])
    assert mahlwerk.Result(copy.parent)["collision_rate"] == result["collision_rate"]
    page = mahlwerk.report(result)
    assert page.name == "report.html" and "<html" in page.read_text(encoding="utf-8")


def test_listings_say_what_a_case_and_a_result_may_have():
    keys = {one["key"]: one for one in mahlwerk.list_keys("frequency")}
    assert keys["mill.frequency"]["unit"] == "Hz" and "balls.diameter" not in keys
    assert {one["unit"] for one in mahlwerk.list_units()} >= {"Hz", "rpm", "mm"}
    assert "drawn_power" in {one["name"] for one in mahlwerk.list_quantities("power")}
    assert mahlwerk.new(mill="retsch-mm400", jar="retsch-mm-25ml")["mill.frequency"]
