# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""`mahlwerk export`: the result of a run as an RO-Crate, checked by the rules of its specification."""
import copy
import json
from datetime import date
from pathlib import Path

import pytest

from ro_crate_rules import Invalid, checked, listed


@pytest.fixture
def made(ball, program):
    ball.run("here")
    assert program("export", "here", "--author", "Ada Lovelace, 0000-0002-1825-0097", "--author", "Bob",
                   "--license", "CC-BY-4.0")[0] == 0
    return Path("here")


def test_a_result_becomes_a_valid_crate(made, ball):
    entities, root = checked(made)
    assert root["name"] == ball.title and root["datePublished"] <= date.today().isoformat()
    assert "Mill: vibration, frequency 10 Hz" in root["description"]
    assert {"summary.json", "case.resolved.toml", "report.html", "result.h5"} <= set(entities)
    assert root["license"] == {"@id": "https://spdx.org/licenses/CC-BY-4.0"}
    authors = [entities[one["@id"]] for one in root["author"]]
    assert [one["name"] for one in authors] == ["Ada Lovelace", "Bob"]
    assert authors[0]["@id"] == "https://orcid.org/0000-0002-1825-0097"
    names = [entities[one["@id"]]["name"] for one in listed(root["citation"])]
    assert any("vibratory milling" in one for one in names)


def test_conditions_have_the_values_of_the_case_with_units_and_sources(made, ball):
    entities, _ = checked(made)
    frequency = entities["#condition-mill.frequency"]
    assert (frequency["value"], frequency["unitText"], frequency["unitCode"]) == (10, "Hz", "UCUM:Hz")
    density = entities["#condition-balls.1.density"]
    assert (density["value"], density["unitCode"]) == (7850, "UCUM:kg/m3")
    assert entities["#condition-mill.kind"]["value"] == "vibration"
    assert entities["#condition-run.time"]["value"] == 2
    assert entities["#condition-jar.volume"]["value"] == pytest.approx(5)
    assert "assumed, not measured" in entities["#condition-gravity"]["description"]
    assert "assumed" not in frequency["description"]
    for origin in ball.origins:
        assert "#condition-" + origin.key in entities or origin.key == "jar.volume"


def test_results_have_the_intervals_of_the_summary(made):
    entities, root = checked(made)
    summary = json.loads(Path(made, "summary.json").read_text(encoding="utf-8"))
    told = [one["@id"].removeprefix("#result-") for one in root["variableMeasured"]]
    assert told[:len(summary["_key_quantities"])] == summary["_key_quantities"]
    with_value = {name for name, one in summary.items() if name[0] != "_" and one["value"] is not None}
    assert set(told) == with_value
    for name in told:
        one, told_of = summary[name], entities["#result-" + name]
        assert told_of["value"] == one["value"] and told_of["unitText"] == one["unit"]
        half = one["ci95"] if one["ci95"] is not None else one["ci95_time"]
        assert ("minValue" in told_of) == (half is not None), name
        if half is not None:
            assert told_of["maxValue"] == min(one["value"] + half, max(one.get("most", 1e300), one["value"]))
            assert told_of["minValue"] == max(one["value"] - half, min(one.get("least", -1e300), one["value"]))


def test_warnings_of_the_run_are_in_the_crate(made):
    entities, root = checked(made)
    warnings = json.loads(Path(made, "summary.json").read_text(encoding="utf-8"))["_about"]["warnings"]
    assert [entities[one["@id"]]["text"] for one in listed(root.get("comment", []))] == warnings


def entity(crate, key):
    return next(one for one in crate["@graph"] if one["@id"] == key)


def without(key, name):
    return lambda crate: entity(crate, key).pop(name)


def with_value(key, name, value):
    return lambda crate: entity(crate, key).update({name: value})


def removed(key):
    return lambda crate: crate["@graph"].remove(entity(crate, key))


WRONG = {
    "context": lambda crate: crate.update({"@context": "https://schema.org"}),
    "no descriptor": removed("ro-crate-metadata.json"),
    "no root": removed("./"),
    "no version": without("ro-crate-metadata.json", "conformsTo"),
    "no name": without("./", "name"),
    "no description": without("./", "description"),
    "no date": without("./", "datePublished"),
    "no license": without("./", "license"),
    "wrong date": with_value("./", "datePublished", "today"),
    "root of another type": with_value("./", "@type", "CreativeWork"),
    "unlinked file": removed("summary.json"),
    "missing file": with_value("summary.json", "@id", "summary2.json"),
    "wrong size": with_value("summary.json", "contentSize", "1"),
    "unknown term": with_value("./", "wear", 1),
    "unknown type": with_value("#run", "@type", "Milling"),
    "nested entity": with_value("#run", "instrument", {"@id": "#mahlwerk", "name": "Mahlwerk"}),
    "dangling id": with_value("#run", "instrument", {"@id": "#nobody"}),
    "id with a blank": with_value("#author-2", "@id", "#author 2"),
    "list of one": with_value("./", "author", [{"@id": "#author-2"}]),
    "twice": lambda crate: crate["@graph"].append(entity(crate, "#mahlwerk")),
    "no unit": without("#condition-mill.frequency", "unitText"),
    "wrong unit": with_value("#condition-mill.frequency", "unitCode", "UCUM:per second"),
    "wrong interval": with_value("#result-dissipated_power", "minValue", 1e9),
    "no version of the software": without("#mahlwerk", "version"),
    "failed without an error": with_value("#run", "actionStatus", {"@id": "http://schema.org/FailedActionStatus"}),
}


@pytest.mark.parametrize("fault", WRONG)
def test_a_wrong_crate_is_found(fault, made):
    good = json.loads(Path(made, "ro-crate-metadata.json").read_text(encoding="utf-8"))
    checked(made, good)
    bad = copy.deepcopy(good)
    WRONG[fault](bad)
    assert bad != good
    with pytest.raises((Invalid, KeyError)):
        checked(made, bad)


def test_a_copy_is_a_crate_and_leaves_the_result_as_it_was(ball, program, tmp_path):
    ball.run("here")
    Path("here", "my notes.txt").write_text("private", encoding="utf-8")
    before = {one.name: one.read_bytes() for one in Path("here").iterdir()}
    code, out, _ = program("export", "here", "--out", "deep/copy", "--json")
    assert code == 0 and json.loads(out) == {"record": "deep/copy/ro-crate-metadata.json"}
    entities, root = checked("deep/copy")
    assert "author" not in root and root["license"].startswith("No license is given")
    assert {one.name: one.read_bytes() for one in Path("here").iterdir()} == before
    assert not Path("deep/copy/my notes.txt").exists()  # of the user, not of the result
    assert Path("deep/copy/summary.json").read_bytes() == before["summary.json"]
    assert program("cite", "deep/copy")[1] == program("cite", "here")[1]


def test_powder_drive_and_folders_of_frames_are_described(example, program):
    sets = {"run.time": "0.1 s", "run.settle": "0 s", "run.replicates": 1, "observe.frames": "20 ms"}
    words = [word for key, value in sets.items() for word in ("--set", f"{key}={value}")]
    assert program("run", example("03-planetary-mill"), *words, "--set", "powder.mass=2 g", "--set",
                   "milling.time=1 h", "--out", "here", "--quiet")[0] == 0
    assert program("export", "here")[0] == 0
    entities, _ = checked("here")
    assert entities["frames-1/"]["@type"] == "Dataset" and not any(key.startswith("frames-1/f") for key in entities)
    assert entities["#condition-powder.mass"]["value"] == 2
    assert entities["#condition-milling.time"]["unitCode"] in ("UCUM:h", "UCUM:s", "UCUM:min")
    assert entities["#condition-mill.speed"]["unitCode"] in ("UCUM:{rev}/min", "UCUM:rad/s")
    assert entities["#condition-mill.ratio"]["propertyID"] == "mill.ratio"
    assert "catalogue mills/fritsch-p7-classic" in entities["#condition-mill.orbit_radius"]["description"]
    assert entities["#result-specific_energy_dose"]["unitCode"] == "UCUM:J/g"


def test_an_interrupted_run_is_a_failed_action(made, program):
    summary = json.loads(Path(made, "summary.json").read_text(encoding="utf-8"))
    summary["_about"].update(complete=False, interrupted=True)
    summary["_about"]["replicates"][0].update(complete=False)
    Path(made, "summary.json").write_text(json.dumps(summary), encoding="utf-8")
    assert program("export", made, "--force")[0] == 0
    entities, _ = checked(made)
    assert "interrupted" in entities["#run"]["error"]
    summary["_about"]["replicates"] = [{"complete": False, "time": 0, "settling": 0}]
    Path(made, "summary.json").write_text(json.dumps(summary), encoding="utf-8")
    assert program("export", made, "--force")[0] == 0
    checked(made)
    assert "nan" not in Path(made, "ro-crate-metadata.json").read_text(encoding="utf-8")


def test_the_description_belongs_to_the_result(made, ball):
    assert "ro-crate-metadata.json" in Path(made, "mahlwerk-files.txt").read_text(encoding="utf-8").splitlines()
    ball.run(made, force=True)
    assert not Path(made, "ro-crate-metadata.json").exists()


def test_results_without_a_list_of_their_own_become_crates_that_can_be_replaced(ball, program):
    ball.save("ball.toml")
    words = ("compare", "ball.toml", "--set", "run.time=0.5 s", "--out", "both", "--quiet", "--force")
    assert program(*words)[0] == 0
    for _ in range(2):
        assert program("export", "both/soft/", "--force")[0] == 0
        checked("both/soft")
    assert not Path("both/soft/mahlwerk-files.txt").exists()
    assert program(*words)[0] == 0 and not Path("both/soft/ro-crate-metadata.json").exists()
    ball.run("old")  # as an early version left it: without a list
    Path("old/mahlwerk-files.txt").unlink()
    assert program("export", "old")[0] == 0
    checked("old")
    ball.run("old", force=True)


def test_what_cannot_be_exported_is_refused_with_a_remedy(made, program, tmp_path):
    def refused(code, *words):
        ended, out, said = program("export", *words, "--json")
        fault = said["faults"][0]
        assert (ended, out, fault["code"]) == (2, "", code), said
        assert fault["where"] and fault["what"] and fault["remedy"]

    refused("result-exists", made)
    refused("no-result", "nowhere")
    refused("no-result", ".")
    refused("no-result", made / "summary.json")
    refused("result-exists", made, "--out", made / "inside", "--force")
    (tmp_path / "there").mkdir()
    (tmp_path / "there" / "mine.txt").write_text("x", encoding="utf-8")
    refused("result-exists", made, "--out", "there")
    refused("wrong-author", made, "--force", "--author", "Ada, 0000-0002-1825-0098")
    refused("wrong-author", made, "--force", "--author", "Ada, 12")
    refused("wrong-author", made, "--force", "--author", "")
    refused("wrong-license", made, "--force", "--license", "do what you want")
    checked(made)  # still the description of before
