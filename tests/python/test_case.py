# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
import pickle
import tomllib

import numpy as np
import pytest

import mahlwerk
from mahlwerk import toml


def test_a_case_from_a_folder_a_file_a_dict_and_a_text_is_the_same(example):
    place = example("01-one-ball")
    with open(place + "/case.toml", "rb") as file:
        content = tomllib.load(file)
    from_folder = mahlwerk.Case(place)
    text = open(place + "/case.toml", encoding="utf-8").read()
    for other in (mahlwerk.Case(place + "/case.toml"), mahlwerk.Case(content),
                  mahlwerk.Case.from_text(text), mahlwerk.Case.from_text(from_folder.text),
                  pickle.loads(pickle.dumps(from_folder))):
        assert other == from_folder
    assert from_folder.title == content["title"]


def test_toml_text_reads_back_as_the_same_values():
    content = {"a": "x\"\\\n\x07é", "b": 1, "c": 0.1, "d": True, "e": [1, 2.5], "f": float("inf"),
               "section": {"mill.speed": ["1 rpm"], "inner": {"k": 1e-300}, "n": np.float64(2.5),
                           "i": np.int32(3)},
               "balls": [{"count": 1}, {"count": 2}]}
    read = tomllib.loads(toml.case_text(content))
    assert read == {**content, "section": {**content["section"], "n": 2.5, "i": 3}}
    with pytest.raises(TypeError, match="object"):
        toml.value_text(object())


def test_values_are_read_and_changed_with_units(ball):
    assert ball["mill.frequency"] == "10 Hz"
    assert ball["balls.diameter"] == ball["balls.1.diameter"] == "8 mm"
    ball["mill.frequency"] = "12 Hz"
    ball["run.replicates"] = 3
    assert (ball["mill.frequency"], ball["run.replicates"]) == ("12 Hz", "3")
    assert ball.origin("mill.frequency").source == "--set mill.frequency"
    other = ball.replace({"mill.frequency": "600 rpm", "jar.diameter": "13 mm"})
    assert other["jar.diameter"] == "13 mm" and ball["jar.diameter"] == "12 mm"
    with pytest.raises(KeyError, match="did you mean mill.frequency"):
        ball["mill.frequenzy"]
    assert {"mill.frequency", "run.time", "balls.diameter"} <= set(ball._ipython_key_completions_())


WRONG = [("mill.frequenzy", "3 Hz"), ("mill.frequency", "3 mm"), ("mill.frequency", "-3 Hz"),
         ("balls.diameter", "20 mm"), ("run.engine", "fast"), ("run.replicates", "2.5"),
         ("contact.restitution", "1.5"), ("mill", "x"), ("jar.kind", "cylindre"), ("", "x")]


@pytest.mark.parametrize("key, value", WRONG)
def test_a_wrong_value_has_the_text_code_and_place_of_the_command_line(example, program, key, value):
    place = example("01-one-ball")
    code, _, said = program("check", place, "--json", "--set", f"{key}={value}")
    assert code == 2
    case = mahlwerk.Case(place)
    before = case.text
    with pytest.raises(mahlwerk.InputError) as caught:
        case[key] = value
    if key:  # without a key the command line refuses its own option
        assert [{"code": f.code, "where": f.where, "what": f.what, "remedy": f.remedy}
                for f in caught.value.faults] == said["faults"]
    assert case.text == before, "a refused change changes nothing"
    assert isinstance(caught.value, ValueError)
    assert str(caught.value) and str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)


def test_faults_of_a_file_cite_its_line(tmp_path, program):
    file = tmp_path / "bad.toml"
    file.write_text('title = "x"\n[mill]\nkind = "vibration"\nfrequency = "10 mm"\nbad = 1\n')
    _, _, said = program("check", file, "--json")
    with pytest.raises(mahlwerk.InputError) as caught:
        mahlwerk.Case(file)
    assert [f.where for f in caught.value.faults] == [f["where"] for f in said["faults"]]
    for missing in (tmp_path / "none.toml", tmp_path):
        with pytest.raises(mahlwerk.InputError):
            mahlwerk.Case(missing) if missing.suffix else mahlwerk.Case(missing / "nothing")


def test_check_says_what_the_command_says(example, program, ball):
    import json
    for name in ("01-one-ball", "03-planetary-mill"):
        said = json.loads(program("check", example(name), "--json")[1])[0]
        found = mahlwerk.Case(example(name)).check()
        assert {k: q.value for k, q in found.derived.items() if k != "run_time"} == {
            k: q["value"] for k, q in said["follows"].items() if k != "run_time"}
        assert found.notes == said["notes"]
        assert {o.key: o.value for o in found.assumed} == said["assumed"]
    assert ball.check().derived["ball_count"].value == 1
    # A case that is valid, but that the engine cannot run: the command ends with exit code 2.
    two = ball.replace({"balls.count": 2, "jar.volume": "50 ml", "jar.diameter": "30 mm", "contact.lasting": "roll"})
    with pytest.raises(mahlwerk.InputError) as caught:
        two.check()
    assert caught.value.faults[0].code == "roll-one-ball"
    assert ".case-" not in str(caught.value), "no temporary name in a message"


def test_a_new_case_of_every_mill_of_the_catalogue_is_valid_and_commented(capfd):
    for one in mahlwerk.catalogue("mills"):
        case = mahlwerk.Case.new(mill=one["name"])
        assert case["mill.model"].strip('"') == one["name"]
    case = mahlwerk.Case.new(kind="vibration", jar_kind="capsule")
    assert "ASSUMED" in case._source.text and case.check().derived
    with pytest.raises(mahlwerk.InputError, match="no mill is given"):
        mahlwerk.Case.new()
    with pytest.raises(mahlwerk.InputError, match="did you mean"):
        mahlwerk.Case.new(mill="retsch-mm40")
    assert capfd.readouterr().out == "", "commands print nothing from Python"


def test_the_last_change_of_a_value_counts_under_any_name(ball):
    ball["balls.diameter"] = "2 mm"
    ball["balls.1.diameter"] = "4 mm"
    ball["balls.diameter"] = "3 mm"
    assert ball["balls.diameter"] == "3 mm" == ball["balls.1.diameter"]
    assert ball.replace({"balls.01.diameter": "5 mm"})["balls.diameter"] == "5 mm"


def test_a_case_is_that_of_its_construction(example, tmp_path, monkeypatch):
    import shutil
    shutil.copytree(example("01-one-ball"), "mine")
    case = mahlwerk.Case("mine/case.toml")
    filling = case.check().derived["filling"].value
    text = open("mine/case.toml", encoding="utf-8").read()
    open("mine/case.toml", "w", encoding="utf-8").write(text.replace("8 mm", "4 mm"))
    (tmp_path / "else").mkdir()
    monkeypatch.chdir("else")
    assert case["balls.diameter"] == "8 mm" and case.check().derived["filling"].value == filling
    assert mahlwerk.Case("../mine")["balls.diameter"] == "4 mm"
    shutil.rmtree("../mine")
    assert case.check().derived["filling"].value == filling


def test_a_case_without_title_gets_no_temporary_one(ball):
    untitled = mahlwerk.Case.from_text(ball.text.split("\n", 1)[1])
    found = untitled.replace({"run.time": "0.1 s"}).compare("out")
    assert found.event.title == untitled.title and "case-" not in found.event.title


def test_other_encodings_and_types_are_refused_as_on_the_command_line(tmp_path, program):
    for name, content in (("latin.toml", 'title = "M\xfchle"'.encode("latin-1")),
                          ("utf16.toml", 'title = "x"'.encode("utf-16")),
                          ("nul.toml", b'title = "x\0"')):
        (tmp_path / name).write_bytes(content)
        _, _, said = program("check", name, "--json")
        with pytest.raises(mahlwerk.InputError) as caught:
            mahlwerk.Case(name)
        assert [f.what for f in caught.value.faults] == [f["what"] for f in said["faults"]]
    for wrong in (5, None, b"x"):
        with pytest.raises(TypeError):
            mahlwerk.Case.new(mill="thped")[wrong]
    with pytest.raises(TypeError, match="name is a text, .* not 5"):
        mahlwerk.describe(5)
    with pytest.raises(ValueError):
        mahlwerk.Case.new(mill="thped", kind="still")


def test_a_case_that_names_a_file_can_be_saved_elsewhere(tmp_path):
    rows = "".join(f"{i / 100},{i % 10 / 1000},0,0\n" for i in range(101))
    (tmp_path / "motion.csv").write_text("time_s,x_m,y_m,z_m\n" + rows)
    case = mahlwerk.Case.from_text(toml.case_text({
        "mill": {"kind": "tabulated", "file": "motion.csv"},
        "jar": {"kind": "sphere", "diameter": "20 mm"},
        "balls": [{"count": 1, "diameter": "8 mm", "density": "7850 kg/m3"}],
        "run": {"time": "2 s"}}), tmp_path)
    case.save(tmp_path / "case.toml")
    assert 'file = "motion.csv"' in (tmp_path / "case.toml").read_text()
    (tmp_path / "other").mkdir()
    case.save(tmp_path / "other" / "case.toml")
    moved = mahlwerk.Case(tmp_path / "other")
    assert moved.origin("mill.file").value == f'"{tmp_path / "motion.csv"}"'
    number = "acceleration_number"
    assert moved.check().derived[number].value == case.check().derived[number].value
