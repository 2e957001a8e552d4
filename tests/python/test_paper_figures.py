# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Figures of papers: their series, numbers, panels and files, on campaigns made by hand."""
import json
import math
import re

import pytest

from mahlwerk.papers import Paper, PaperCampaign
from mahlwerk.papers.figures import captions_markdown, made_figures
from mahlwerk.papers.lines import Point, Points

NAN = math.nan
C = PaperCampaign("c")
FREQUENCY = {"against": "mill.frequency"}


def campaign(quantity, unit, rows):
    """Points over a frequency and a free number."""
    return Points(["mill.frequency", "breakage.f_mat"], {quantity: unit, "replicates": "1"},
                  [Point([x, f_mat], {quantity: value, "replicates": 5.0}, {quantity: ci95})
                   for x, f_mat, value, ci95 in rows])


def rows(csv, kind):
    return [[float(c) if c else NAN for c in line.split(f",{kind},")[1].split(",")]
            for line in csv.splitlines() if f",{kind}," in line]


@pytest.mark.parametrize("quantity, unit, low, high", [
    ("ball_speed_seen_from_carrier", "m/s", 0, 1.1), ("flight_share", "1", 0, 1),
    ("power_imbalance", "1", 0.23 - 0.25, 1.1)])
def test_no_interval_leaves_the_range_of_its_quantity(quantity, unit, low, high):
    c = campaign(quantity, unit, [("10 Hz", "1", 0.23, 0.25), ("20 Hz", "1", 0.9, 0.2)])
    made = rows(C.curve(quantity, **FREQUENCY).plot(c).csv(), "mean")
    assert made[0][2] == pytest.approx(low) and made[1][3] == pytest.approx(high)


def test_the_axes_and_the_legend_say_quantity_unit_replicates_and_law():
    c = campaign("energy_contact_point_mean", "J",
                 [(f"{f} Hz", "1", 1e-5 * f * f, 1e-5) for f in (10, 13, 16, 20, 25)])
    plot = C.curve("energy_contact_point_mean", **FREQUENCY, law="power").plot(c)
    law, mean = plot.series
    assert mean.legend == "mean of 5 replicates, bars: 95 % interval"
    assert law.name.startswith("$E_{c}$ = ") and "^{2}, $R$²" in law.name
    assert plot.csv().startswith("series,kind,mill_frequency_Hz,energy_contact_point_mean_J,low_J,high_J\n")
    ax = drawn(plot)
    assert ax.get_xlabel().replace("\n", " ") == "vibration frequency, $f$ (Hz)"
    assert ax.get_ylabel().replace("\n", " ").endswith(r"energy, $E_{\mathrm{c}}$ (mJ)")


def drawn(plot):
    from matplotlib.figure import Figure
    ax = Figure().subplots()
    plot.draw(ax, 44)
    return ax


def test_of_several_lines_each_is_named_once_in_legend_and_csv():
    c = campaign("collision_rate", "1/s", [(f"{f} Hz", f_mat, float(f * f), 1.0)
                                           for f_mat in ("1", "2") for f in (10, 13, 16, 20, 25)])
    plain = C.curve("collision_rate", **FREQUENCY).plot(c)
    assert [s.legend for s in plain.series] == ["f mat 1", "f mat 2"]
    assert plain.note == "points: mean of 5 replicates, bars: 95 % interval"
    fitted = C.curve("collision_rate", **FREQUENCY, law="power").plot(c)
    names = [s.name if s.legend is None else s.legend for s in fitted.series]
    assert names[1] == names[3] == "" and names[2].startswith("f mat 2: $n$ = ")
    assert "\nf mat 2,mean,10,100,99,101\n" in fitted.csv()


def test_measured_values_are_drawn_with_their_errors():
    paper = Paper(title="T", source="S")
    measured = paper.measured("X 1999", source="s", status="verified",
                              values=[("12 Hz", "2.1 mJ", "0.5 mJ"), ("18 Hz", "2.4 mJ", "3 mJ")])
    c = campaign("energy_normal_mean", "J", [("10 Hz", "1", 0.002, 0.0001), ("20 Hz", "1", 0.003, 0.0002)])
    made = rows(C.curve("energy_normal_mean", **FREQUENCY, measured=measured).plot(c).csv(), "measured")
    assert made[0] == pytest.approx([12, 0.0021, 0.0016, 0.0026])
    assert made[1][2] == 0, "an energy is not negative"


FREE = [("10 Hz", "1", 5, 1), ("10 Hz", "2", 7, 2), ("10 Hz", "3", 2, 3),
        ("20 Hz", "1", 8, 0.5), ("20 Hz", "2", 9, NAN), ("20 Hz", "3", 8.5, 1)]


def test_a_band_holds_all_values_of_the_free_numbers_with_their_intervals():
    def plot(**more):
        return C.curve("d90", **FREQUENCY, band_over=["breakage.f_mat"], **more).plot(campaign("d90", "m", FREE))
    made = plot(nominal={"breakage.f_mat": "2"})
    # 2 - 3 is cut at 0, 7 + 2; 8 - 0.5, 8.5 + 1.
    assert [row[2:] for row in rows(made.csv(), "band")] == [[0, 9], [7.5, 9.5]]
    assert [row[1] for row in rows(made.csv(), "mean")] == [7, 9]
    assert made.series[0].name == "all values of $f_{Mat}$, with 95 % intervals"
    assert rows(plot().csv(), "mean") == []


def test_a_band_keeps_lines_of_other_keys_and_the_selected_points():
    c = campaign("d90", "m", FREE)
    c.keys.append("jar.material")
    steel = [Point([*p.values, "steel"], p.value, p.ci95) for p in c.points]
    agate = [Point([*p.values, "agate"], {**p.value, "d90": p.value["d90"] + 100}, p.ci95) for p in c.points]
    c.points = steel + agate
    plot = C.curve("d90", **FREQUENCY, band_over=["breakage.f_mat"],
                   at={"breakage.f_mat": ["1", "2"]}).plot(c)
    first, second = plot.series
    assert first.name.startswith("material steel: ") and second.name.startswith("material agate: ")
    assert (first.low[0], second.low[0]) == (4, 104), "without the third value, 2 - 3"


def paper_with(*numbers, about=""):
    paper = Paper(title="T", source="S")
    for number in numbers:
        paper.figure(number, "rate <b>", C.curve("collision_rate", **FREQUENCY), about=about)
    return paper


POINTS = {"c": campaign("collision_rate", "1/s", [("10 Hz", "1", 1.0, 0.1), ("20 Hz", "1", 2.0, 0.1)])}


def test_figures_with_the_same_number_are_lettered_panels_of_one_file():
    made = made_figures(paper_with("4", "4", "6b", "6", "2.2", "4"), POINTS)
    assert [one.file for one in made] == ["figure-4", "figure-6", "figure-2-2"]
    # 6b keeps the paper's letter; the panel without a letter gets the next free one.
    assert [name for one in made for name in sorted(one.tables)] == [
        "figure-4a.csv", "figure-4b.csv", "figure-4c.csv", "figure-6a.csv", "figure-6b.csv", "figure-2-2.csv"]
    assert [one.caption for one in made[1:]] == ["b: rate <b>. a: rate <b>.", "rate <b>."]
    assert captions_markdown(made[2:]) == "**Figure 2.2.** rate <b>.\n"


@pytest.mark.parametrize("count, width", [(1, 90), (2, 180), (3, 180)])
def test_a_figure_has_the_width_of_a_journal_with_fonts_in_it_and_the_same_bytes_again(count, width):
    (figure,) = made_figures(paper_with(*["4"] * count), POINTS)
    files = figure.files()
    assert sorted(files) == ["figure-4.pdf", "figure-4.png", "figure-4.svg"]
    svg = files["figure-4.svg"].decode()
    points = float(re.search(r'width="([\d.]+)pt"', svg)[1])
    assert points / 72 * 25.4 == pytest.approx(width, rel=1e-3)
    assert "<text" not in svg, "letters are outlines"
    assert b"FontFile2" in files["figure-4.pdf"], "letters are embedded"
    assert files == figure.files()


def test_no_legend_covers_an_axis_and_no_text_is_cut():
    import matplotlib
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    from mahlwerk.papers.figures import rows_of, sheet
    from mahlwerk.papers.style import style

    (figure,) = made_figures(paper_with("4", "4", "4"), POINTS)
    with matplotlib.rc_context(style()):
        fig = sheet(rows_of(figure.sections))
        FigureCanvasAgg(fig).draw()
        whole = fig.bbox
        for part in fig.subfigs:
            for ax in part.axes:
                if not ax.get_visible():
                    continue
                assert not ax.get_legend().get_window_extent().overlaps(ax.get_window_extent())
                box = ax.get_tightbbox()
                assert box.x0 >= whole.x0 - 1 and box.x1 <= whole.x1 + 1
                assert box.y0 >= whole.y0 - 1 and box.y1 <= whole.y1 + 1


def test_text_is_wrapped_between_words_by_what_is_seen():
    from mahlwerk.papers.style import wrapped

    assert wrapped("one two three", 7) == ["one two", "three"]
    assert wrapped("energy, $E_{n}$ (mJ)", 15) == ["energy, $E_{n}$ (mJ)"]
    assert len(wrapped("energy, $E_{n}$ (mJ)", 14)) == 2
    assert wrapped("incomprehensible word", 5) == ["incomprehensible", "word"]
    assert wrapped("", 5) == []


def film(words, frames):
    times = [0.0, 0.1] if frames else []
    ball = {"number": 1, "grain": False, "radius_m": 0.005, "speed_m_per_s": 0.5,
            "carrier": [[0.025, 0.02], [0.0, 0.01], [0.001, 0.002]], "jar": [[0, 1], [0, 1], [0, 1]]}
    grain = {"number": 2, "grain": True, "radius_m": 0.001, "speed_m_per_s": 0.1,
             "carrier": [[0.01], [0.0], [0.0]], "jar": [[0], [0], [0]]}
    return {"half_m": 0.05, "round": True,
            "replicates": [{"replicate": 3, "words": words, "times_s": times,
                            "balls": [ball, grain] if frames else []}]}


def filmed(tmp_path, frames=True):
    folder = tmp_path / "run"
    folder.mkdir()
    (folder / "film.json").write_text(json.dumps(film("cascading, replicate 3 of 8", frames)))
    points = campaign("collision_rate", "1/s", [("10 Hz", "1", 1.0, 0.1), ("20 Hz", "1", 1.0, 0.1)])
    points.points[1].folder = folder
    return {"c": points}


def test_pictures_of_points_with_a_film_have_its_title_and_numbers(tmp_path):
    paper = Paper(title="T", source="S")
    paper.figure("7a", "paths", C.trajectories())
    paper.figure("7b", "balls", C.snapshots())
    (made,) = made_figures(paper, filmed(tmp_path))
    assert made.tables["figure-7a.csv"] == ("replicate,ball,time_s,x_m,y_m\n3,1,0,0.025,0\n3,1,0.1,0.02,0.01\n")
    assert made.tables["figure-7b.csv"].splitlines()[1:] == [
        "3,1,ball,0.1,0.005,0.02,0.01,0.002,0.5", "3,2,grain,0.1,0.001,0.01,0,0,0.1"]
    assert made.sections[0].panels[0].title == "frequency 20 Hz: cascading, replicate 3 of 8"
    assert made.caption.startswith("a: paths. b: balls. Trajectories are those")
    assert len(made.files()["figure-7.svg"]) > 1000


def test_without_a_film_there_is_no_picture(tmp_path):
    paper = Paper(title="T", source="S")
    paper.figure("7a", "paths", C.trajectories())
    (made,) = made_figures(paper, filmed(tmp_path, frames=False))
    assert made.empty and made.tables == {}


def test_keys_that_are_swept_together_with_the_axis_do_not_split_a_curve():
    def mills(following):
        return Points(["mill.speed", "jar.diameter"], {"power": "W"}, [
            Point([x, d], {"power": y}, {"power": 0.1}) for x, d, y in
            (("10 rpm", "9 m", 3.0), ("11 rpm", "7 m", 2.0), ("12 rpm", "9 m", 5.0))], following)
    together = mills(frozenset(["jar.diameter"]))
    lines = together.lines({}, "mill.speed", "power")
    assert [[s.value for s in line.spots] for line in lines] == [[3.0, 2.0, 5.0]] and lines[0].others == ""
    assert together.mixed({}, "mill.speed"), "the points are not joined"
    apart = mills(frozenset()).lines({}, "mill.speed", "power")
    assert sorted(line.others for line in apart) == ["diameter 7 m", "diameter 9 m"]
