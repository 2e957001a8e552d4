# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Files of parts in the jar lie beside the case of a result, which runs again."""
import json

CASE = """title = "Parts from files"
[mill]
kind = "tumbling"
speed = "60 rpm"
[jar]
kind = "cylinder"
diameter = "100 mm"
height = "40 mm"
[[parts]]
name = "liner"
kind = "mesh"
file = "bar.csv"
unit = "mm"
length = "30 mm"
rows = 3
[[parts]]
name = "scraper"
kind = "blade"
length = "10 mm"
height = "10 mm"
thickness = "4 mm"
frame = "laboratory"
position = ["0 mm", "0 mm", "20 mm"]
motion = "tabulated"
motion_file = "path.csv"
[[balls]]
diameter = "8 mm"
count = 60
density = "7850 kg/m3"
[contact]
restitution = 0.5
friction = 0.4
softening = 1e-3
[run]
engine = "soft"
time = "0.1 s"
settle = "0.1 s"
replicates = 1
sensitivity = "off"
"""
BAR = "x,y\n50,-6\n43,-3\n43,3\n50,6\n"
PATH = ("time_s,x_m,y_m,z_m,roll_rad,pitch_rad,yaw_rad\n0,0,0,0,0,0,0\n0.1,0,0.001,0,0.1,0,0.2\n"
        "0.2,0,0.002,0,0,0.1,0\n0.3,0,0.001,0,-0.1,0,-0.2\n0.4,0,0,0,0,0,0\n")


def test_a_resolved_case_with_files_of_parts_runs_again_with_the_same_result(program, tmp_path):
    for name, text in {"case.toml": CASE, "bar.csv": BAR, "path.csv": PATH}.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    code, _, said = program("run", str(tmp_path / "case.toml"), "--out", str(tmp_path / "one"))
    assert code == 0, said
    for name in ("bar.csv", "path.csv"):
        (tmp_path / name).unlink()
    code, _, said = program("run", str(tmp_path / "one" / "case.resolved.toml"), "--out", str(tmp_path / "two"))
    assert code == 0, said
    one, two = (json.loads((tmp_path / name / "summary.json").read_text(encoding="utf-8"))
                for name in ("one", "two"))
    # The surface is written as numbers of single precision.
    assert one["drawn_power"]["value"] > 0
    assert abs(two["drawn_power"]["value"] / one["drawn_power"]["value"] - 1) < 0.2
    assert [part["name"] for part in two["_parts"]] == ["liner", "scraper"]


def test_a_liner_outside_the_drum_is_named(program, tmp_path):
    (tmp_path / "bar.csv").write_text("x,y\n62,-6\n55,-3\n55,3\n62,6\n", encoding="utf-8")
    (tmp_path / "path.csv").write_text(PATH, encoding="utf-8")
    (tmp_path / "case.toml").write_text(CASE, encoding="utf-8")
    code, text, said = program("run", str(tmp_path / "case.toml"), "--out", str(tmp_path / "out"))
    assert code == 0, said
    assert "No ball touched these parts: liner" in text
