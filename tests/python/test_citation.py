# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""`mahlwerk cite`: text and BibTeX of the models that a run uses."""
import html
import re

import pytest

import mahlwerk

from conftest import HOME

FIELDS = {"article": {"author", "title", "journal", "year"}, "book": {"author", "title", "publisher", "year"},
          "incollection": {"author", "title", "booktitle", "year"}, "misc": {"title"}}


def braced(text, at):
    """The text inside the braces that open at `at`, and the place behind them."""
    assert text[at] == "{", text[at:at + 40]
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] == "{") - (text[i] == "}")
        if depth == 0:
            return text[at + 1:i], i + 1
    raise AssertionError(f"braces do not close: {text[at:at + 80]}")


def parsed(text):
    """Entries of BibTeX: key -> (type, fields). A small parser; it refuses all that stands between entries."""
    entries, at = {}, 0
    while at < len(text.rstrip()):
        begin = re.compile(r"\s*@(\w+)(?=\{)").match(text, at)
        assert begin, text[at:at + 40]
        body, at = braced(text, begin.end())
        key, _, rest = body.partition(",")
        assert re.fullmatch(r"[A-Za-z0-9.-]+", key), key
        assert key not in entries, f"{key} stands twice"
        fields, place = {}, 0
        while place < len(rest.rstrip()):
            name = re.compile(r"\s*(\w+)\s*=\s*(?=\{)").match(rest, place)
            assert name and name[1] not in fields, rest[place:place + 40]
            fields[name[1]], place = braced(rest, name.end())
            if rest[place:place + 1] == ",":
                place += 1
        entries[key] = (begin[1], fields)
    return entries


def is_valid(entries):
    for key, (kind, fields) in entries.items():
        assert FIELDS[kind] <= set(fields), f"{key} lacks {FIELDS[kind] - set(fields)}"
        for name, value in fields.items():
            assert value.strip(), f"{key}: {name} is empty"
            if name != "doi":
                assert not re.search(r"(?<!\\)[&%#_$]", value), f"{key}: {name} has a bare command of LaTeX"
    return True


def test_the_parser_refuses_wrong_bibtex():
    good = "@book{a1, title = {{X}}, author = {Y}, publisher = {Z}, year = {1}}"
    assert is_valid(parsed(good))
    for wrong in (good[:-1], good + "x", good + good, good.replace("year", "month"), good.replace("X", "X % Y"),
                  good.replace("= {Y}", "= Y"), good.replace("{Z}", "{ }")):
        with pytest.raises(AssertionError):
            is_valid(parsed(wrong))


def examples():
    return sorted(one.parent.name for one in HOME.glob("examples/*/case.toml"))


@pytest.mark.parametrize("name", [one for one in examples() if one != "09-campaign"])
def test_every_example_can_be_cited(name, example, program):
    code, text, _ = program("cite", example(name))
    assert code == 0
    code, bibtex, _ = program("cite", example(name), "--bibtex")
    entries = parsed(bibtex)
    assert code == 0 and is_valid(entries)
    numbers = re.findall(r"^\[(\d+)\] ", text, re.M)
    assert numbers == [str(i + 1) for i in range(len(entries))]
    cited = {n for group in re.findall(r"\[([\d, ]+)\]", text.split("\n\n")[0]) for n in group.split(", ")}
    assert cited == set(numbers), "each reference is cited in the paragraph, and each citation is listed"
    assert list(entries)[0] == "mahlwerk"


def test_the_program_is_cited_as_its_file_of_citation_says(example, program):
    yaml = pytest.importorskip("yaml")
    said = yaml.safe_load((HOME / "CITATION.cff").read_text(encoding="utf-8"))
    kind, fields = parsed(program("cite", example("01-one-ball"), "--bibtex")[1])["mahlwerk"]
    assert kind == "misc" and fields["title"] == "{" + said["title"] + "}"
    assert fields["author"] == "{" + said["authors"][0]["name"] + "}"
    assert fields["howpublished"].endswith(f"version {said['version']}")
    by_doi = {one["doi"]: one for one in said["references"]}
    paper = parsed(program("cite", example("05-planetary-soft"), "--bibtex")[1])["mhadhbi2021"][1]
    assert by_doi[paper["doi"]]["title"] == paper["title"].strip("{}")
    assert str(by_doi[paper["doi"]]["year"]) == paper["year"]


def test_a_result_is_cited_as_it_ran(ball, program):
    result = ball.run("here")
    text = program("cite", "here")[1]
    assert "2 replicates of 2 s each were counted after" in text
    assert result.cite().text == text and str(result.cite()) == text
    report = re.search(r'id="methods">(.*?)</p>', result.report, re.S)[1]
    paragraph = re.sub(r" Models: .*", "", text.split("\n\n")[0]).replace(" [1]", "")
    assert html.unescape(re.sub(r"<.*?>", "", report)) == paragraph


def test_from_memory_and_from_a_folder_the_citation_is_the_same(ball):
    ran = ball.run()
    inside = ran.cite()
    ran.save("there")
    assert mahlwerk.open("there").cite() == inside
    assert is_valid(parsed(inside.bibtex))
    assert inside.models["bounce rule (constant)"] == ["chen2016"]


def test_changes_of_a_case_change_what_is_cited(ball):
    assert "restitution (viscoelastic)" not in ball.cite().models
    soft = ball.replace({"run.engine": "soft", "contact.law": "jkr", "contact.surface_energy": "1 J/m2",
                         "contact.friction": 0.3, "contact.tangential_restitution": 0})
    assert soft.cite().models["contact law (jkr)"] == ["johnson1971", "mindlin1949"]
    assert "bounce rule (walton)" not in soft.cite().models


def test_origins_of_the_run_are_kept_in_its_folder(example, program):
    assert program("run", example("02-mixer-mill"), "--set", "run.time=0.2 s", "--out", "mixer", "--quiet")[0] == 0
    of_case, of_result = (program("cite", one, "--bibtex")[1] for one in (example("02-mixer-mill"), "mixer"))
    assert parsed(of_case)["mahlwerk-materials-steel-1.4034"] == parsed(of_result)["mahlwerk-materials-steel-1.4034"]
    assert "rolling friction 0.01*" in program("cite", "mixer")[1]


def test_what_cannot_be_cited_is_refused_with_a_remedy(example, program, ball, tmp_path):
    def refused(code, *words):
        ended, out, said = program("cite", *words, "--json")
        fault = said["faults"][0]
        assert (ended, out, fault["code"]) == (2, "", code), said
        assert fault["where"] and fault["what"] and fault["remedy"]

    refused("no-such-case", "nowhere")
    refused("one-case", example("09-campaign"))
    (tmp_path / "empty").mkdir()
    refused("no-such-case", "empty")
    (tmp_path / "wrong.toml").write_text("[mill]\nkind = \"vibration\"\n", encoding="utf-8")
    assert program("cite", "wrong.toml")[0] == 2
    ball.run("here")
    refused("changed-result", "here", "--set", "run.time=1 s")
    for text in ("{", "{}", "[]", '{"_about": {"mahlwerk": 3}}', '{"_about": {"assumed": 1}}'):
        (tmp_path / "here" / "summary.json").write_text(text, encoding="utf-8")
        refused("no-result", "here")
    (tmp_path / "campaign").mkdir()
    (tmp_path / "campaign" / "campaign.sqlite").write_bytes(b"SQLite format 3")
    refused("no-result", "campaign")
