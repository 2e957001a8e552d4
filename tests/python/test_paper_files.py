# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Reading of paper.py, what is wrong in it, and what a paper writes."""
import math
from pathlib import Path
from types import SimpleNamespace

import pytest

import mahlwerk
from mahlwerk.papers import Paper, PaperCampaign, Verdict, captures
from mahlwerk.papers.captures import CaptureBounds, counted_bins, Bin, has_bounds
from mahlwerk.papers.lines import Point, Points
from mahlwerk.papers.overview import overview_csv, overview_markdown, rows_of, score
from mahlwerk.papers.page import PaperResult, checks_csv, checks_markdown, checks_text, page
from mahlwerk.papers.paper import read_paper
from mahlwerk.papers.references import reference_faults
from mahlwerk.papers.tables import markdown

HOME = Path(__file__).resolve().parents[2]
C = PaperCampaign("c")
HEAD = 'from mahlwerk.papers import Paper\npaper = Paper(title="T", source="S")\nc = paper.campaign("c")\n'


def written(tmp_path, text):
    file = tmp_path / "paper.py"
    file.write_text(HEAD + text)
    return file


def fault_of(tmp_path, text):
    with pytest.raises(mahlwerk.InputError) as refused:
        read_paper(written(tmp_path, text))
    return refused.value.faults[0]


def test_a_paper_is_read_with_its_campaigns_in_the_order_of_first_mention(tmp_path):
    paper = read_paper(written(tmp_path, (
        'd = paper.campaign("d")\n'
        'paper.check("2", "it is large", d.above("3 mJ", "energy_normal_mean"), own=True)\n'
        'paper.figure("1", "t", c.curve("d90", against="mill.frequency"))\n')))
    assert paper.campaigns == ["c", "d"] and paper.folder == tmp_path
    assert paper.checks[0].own and paper.checks[0].line.endswith("paper.py:5")
    paper.without(["d"])
    assert paper.campaigns == ["c"] and paper.checks == []


@pytest.mark.parametrize("text, line, part", [
    ("x = (\n", 4, ""), ("1 / 0\n", 4, "division"), ('\nc.curve("d90")\n', 5, "against"),
    ('c.above("3 mj/", "d90")\n', 4, "mj"), ('c.regime("flying")\n', 4, "cascading"),
    ('c.is_alike("d90", against="k", within=-1)\n', 4, "above 0"), ('paper.campaign("../c")\n', 4, "name"),
    ('paper.table("a.b", "t", c.table("d90", against="k"))\n', 4, "file name"),
    ('paper.measured("m", source="s", status="sure", values=[("1 W", "1 W")])\n', 4, "verified"),
    ('paper.measured("m", source="s", status="quoted", values=[("1 W",)])\n', 4, "83 W"),
    ("paper = 3\n", None, "no `paper`")])
def test_a_fault_names_the_line_of_the_paper(tmp_path, text, line, part):
    fault = fault_of(tmp_path, text)
    assert part in fault.what and fault.code == "bad-paper"
    assert fault.where == str(tmp_path / "paper.py") + (f":{line}" if line else "")


SWEPT = """title = "c"
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
[sweep]
"mill.frequency" = ["10 Hz", "20 Hz"]
"contact.restitution" = [0.8, 0.9]
"""


def codes(use):
    paper = Paper(title="T", source="S")
    use(paper)
    return [fault.code for fault in reference_faults(paper, {"c": mahlwerk.Case.from_text(SWEPT)})]


def measured(paper, *values):
    return paper.measured("m", source="s", status="quoted", values=values)


KEY = {"against": "mill.frequency"}


@pytest.mark.parametrize("use, code", [
    (lambda p: p.check("1", "s", C.rises("collision_rate", **KEY)), None),
    (lambda p: p.check("1", "s", C.rises("collision_rate", against="mill.amplitude")), "paper-unknown-key"),
    (lambda p: p.check("1", "s", C.rises("colision_rate", **KEY)), "paper-unknown-quantity"),
    (lambda p: p.check("1", "s", C.rises("flight_share", **KEY)), "paper-unknown-quantity"),
    (lambda p: p.check("1", "s", C.rises("collision_rate", **KEY, at={"mill.frequency": "11 Hz"})),
     "paper-unknown-value"),
    (lambda p: p.check("1", "s", C.larger("collision_rate", **KEY, first="0.01 kHz", second="20 Hz")), None),
    (lambda p: p.check("1", "s", C.larger("collision_rate", **KEY, first="10 Hz", second="30 Hz")),
     "paper-unknown-value"),
    (lambda p: p.check("1", "s", C.agrees_with(measured(p, ("20 Hz", "5 1/s", "1 1/s")), "collision_rate", **KEY)),
     None),
    (lambda p: p.check("1", "s", C.agrees_with(measured(p, ("21 Hz", "5 1/s", "1 1/s")), "collision_rate", **KEY)),
     "paper-unknown-value"),
    (lambda p: p.check("1", "s", C.agrees_with(measured(p, ("5 1/s", "1 1/s")), "collision_rate", **KEY)),
     "paper-unknown-measurement"),
    (lambda p: p.check("1", "s", C.agrees_with(measured(p, ("20 Hz", "5 W", "1 W")), "collision_rate", **KEY)),
     "bad-quantity"),
    (lambda p: p.check("1", "s", C.captures_within_bounds()), "paper-no-capture"),
    (lambda p: p.figure("1", "t", C.curve("collision_rate", **KEY, band_over=["contact.restitution"],
                                          nominal={"contact.restitution": 0.9})), None),
    (lambda p: p.figure("1", "t", C.curve("collision_rate", **KEY, band_over=["breakage.x"])), "paper-unknown-key"),
    (lambda p: p.figure("1", "t", C.curve("collision_rate", **KEY, band_over=["mill.frequency"])),
     "paper-unknown-key"),
    (lambda p: p.figure("1", "t", C.curve("collision_rate", **KEY, nominal={"contact.restitution": 0.9})),
     "paper-unknown-key"),
    (lambda p: p.figure("1", "t", C.curve("collision_rate", **KEY, band_over=["contact.restitution"],
                                          nominal={"contact.restitution": 0.7})), "paper-unknown-value"),
    (lambda p: p.table("t", "t", C.captured("jar.side", against="mill.frequency", energies=["1 mJ"])),
     "paper-no-capture")])
def test_what_a_paper_asks_of_campaigns_is_checked_before_they_run(use, code):
    assert codes(use) == ([] if code is None else [code])


@pytest.mark.parametrize("folder", sorted(f.parent for f in HOME.glob("*/*/paper.py")), ids=lambda f: f.name)
def test_every_paper_of_the_project_asks_for_what_its_campaigns_have(folder):
    paper = read_paper(folder / "paper.py")
    cases = {name: mahlwerk.Case(folder / f"{name}.toml") for name in paper.campaigns}
    assert [str(fault) for fault in reference_faults(paper, cases)] == []
    assert all(case._resolved.sweeps for case in cases.values())


def test_a_table_has_a_row_for_each_combination_and_the_ratio_of_the_ends():
    points = Points(["contact.friction", "mill.frequency"], {"collision_rate": "1/s"}, [
        Point([friction, f"{f} Hz"], {"collision_rate": float(f)}, {"collision_rate": 1.0})
        for friction in ("0.1", "0.5") for f in (10, 30)])
    made = C.table("collision_rate", **KEY, ratio=True).made(points)
    assert made.heads == ["contact.friction", "10 Hz", "30 Hz", "last over first"]
    assert made.rows[1] == ["0.5", "10.0 ± 1.0 /s", "30.0 ± 1.0 /s", "3.00"]
    assert made.csv.startswith("contact.friction,mill.frequency,collision_rate_per_s,collision_rate_ci95_per_s\n")
    assert markdown(made).startswith("| contact.friction | 10 Hz | 30 Hz | last over first |\n|---|---|---|---|\n")


def captured_case():
    """Five balls of 15 mm in a vial of 42 mm, as the paper on the planetary mill has them."""
    return mahlwerk.Case(HOME / "papers/planetary-mill/friction-05.toml")


def test_the_bounds_of_captures_are_those_of_the_hertz_spot_and_of_the_greatest_deformation():
    case = captured_case()
    assert has_bounds(case) and not has_bounds(mahlwerk.Case.from_text(SWEPT))
    bounds = CaptureBounds(case)
    # A separate program gives these numbers for E = 200 GPa, nu = 0.265, 1 mJ and 40 um.
    bounds.size = 40e-6
    soft = 2 * (1 - 0.265 ** 2) / 200e9
    for other, radius, low, high in (("balls.1", 0.00375, 67.668322, 505.007444),
                                     ("jar.side", math.sqrt(0.0075 / (1 / 0.0075 - 1 / 0.021)), 140.323554,
                                      1181.123918),
                                     ("jar.bottom", 0.0075, 117.632117, 961.559782)):
        bounds._known["balls.1", other] = (radius, soft)
        assert bounds.at("balls.1", other, 1e-3) == pytest.approx((low, high), abs=1e-6)
    assert CaptureBounds(case)._radius("balls.1", "jar.bottom") == pytest.approx(
        0.5 * float(mahlwerk._core.quantity_in(case["balls.1.diameter"].strip('"'), "m")))
    assert CaptureBounds(case).at("balls.1", "jar", 1e-3) is None


def test_bins_outside_the_bounds_are_counted():
    bounds = CaptureBounds(captured_case())
    low, high = bounds.at("balls.1", "jar.side", 1e-3)

    def bin_of(grains, other="jar.side"):
        return Bin("balls.1", other, 1e-3, 1.0, grains, 0.0, 0.0)
    bins = [bin_of(low), bin_of(high), bin_of(0.9 * low), bin_of(1.1 * high), bin_of(1.0, "jar")]
    assert counted_bins(bounds, bins) == (4, 2)


@pytest.mark.parametrize("factors, holds", [((1.0, 1.1), "yes"), ((1.0, 0.5), "partly"), ((0.5, 0.9), "no"),
                                            ((), "undecided")])
def test_captures_are_judged_by_the_bins_of_all_points(monkeypatch, factors, holds):
    case = captured_case()
    low, _ = CaptureBounds(case).at("balls.1", "jar.side", 1e-3)
    bins = [Bin("balls.1", "jar.side", 1e-3, 1.0, factor * low, 0.0, 0.0) for factor in factors]
    monkeypatch.setattr(captures, "result_at", lambda spot: SimpleNamespace(case=case))
    monkeypatch.setattr(captures, "bins_of", lambda result: bins)
    points = Points(["powder.size"], {}, [Point(["40 um"], {}, {})])
    assert C.captures_within_bounds().judge(points).holds == holds


def result(changed=()):
    paper = Paper(title="T", source="S")
    rule = C.rises("collision_rate", **KEY)
    paper.check("1", "we add", rule, own=True)
    paper.check("1", "it rises | <b>", rule, why="for reasons")
    return PaperResult(paper, [Verdict("a", "no"), Verdict("b <i>", "yes")], [], [], {"c": 1.5}, list(changed),
                       "", "")


def test_our_own_statements_stand_apart_from_the_claims_of_the_paper():
    made = result()
    for told in (page(made, {}), checks_text(made), checks_markdown(made)):
        assert told.index("it rises") < told.index("we add")
    assert "Of 1 claim: yes 1. Of 1 statement of ours: no 1." in checks_text(made)
    assert "| figure | we say | we find |" in checks_markdown(made)
    assert checks_csv(made).startswith("figure,the_paper_says,we_find,holds,why,own\n1,we add,a,no,,yes\n")


@pytest.mark.parametrize("own", [False, True])
def test_a_table_without_statements_is_left_out(own):
    paper = Paper(title="T", source="S")
    paper.check("1", "it rises", C.rises("collision_rate", **KEY), own=own)
    made = PaperResult(paper, [Verdict("a", "yes")], [], [], {"c": 1.5}, [], "", "")
    assert checks_markdown(made).count("|---|---|---|---|---|") == 1
    assert page(made, {}).count("<th>Holds</th>") == 1


def test_the_page_and_the_tables_escape_what_a_paper_says():
    assert "it rises | &lt;b&gt;" in page(result(), {}) and "b &lt;i&gt;" in page(result(), {})
    assert r"it rises \| <b>" in checks_markdown(result())


def test_words_about_its_own_settings_are_left_out_where_others_were_run():
    assert "for reasons" in page(result(), {})
    made = result(["run.time = 2 s"])
    for told in (page(made, {}), checks_text(made)):
        assert "for reasons" not in told
        assert "Run with run.time = 2 s, unlike the campaigns of the paper." in told
    assert "for reasons" not in checks_csv(made) + checks_markdown(made)


def test_the_overview_counts_sets_and_verdicts():
    paper = Paper(title="T", source="S")
    agreement = C.agrees_with(measured(paper, ("5 W", "1 W")), "drawn_power")
    paper.check("1", "power", agreement)
    made = PaperResult(paper, [Verdict("measured 5 W", "yes", 0.05)], [], [], {}, [], "", "")
    rows = rows_of(made, "mill")
    assert score(rows) == ("1 sets of measured data, 1 with a verdict. Of 1 claims: yes 1. In 1 sets a whole band "
                           "lies within 10 % of the measured values: mill.")
    assert overview_csv(rows).splitlines()[1] == "mill,power,measured 5 W,yes,0.05,quoted"
    assert "| [mill](../validation/mill/README.md) | power | measured 5 W | yes | 5 % | quoted |" in (
        overview_markdown(rows))
