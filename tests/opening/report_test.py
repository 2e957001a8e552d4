#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""A report opens from disk in a browser, draws, logs no errors, and has the numbers of summary.json.

    report_test.py PROGRAM      exit code 77 if Chromium is not installed
"""
import json
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "viewer" / "test"))
from browser import Browser  # noqa: E402

SKIPPED = 77
CASE = """
title = "A <report> & its numbers"
[mill]
kind = "planetary"
orbit_radius = "70 mm"
speed = "400 rpm"
ratio = "1:-2"
[jar]
kind = "cylinder"
diameter = "42 mm"
height = "32.5 mm"
[[balls]]
count = 5
diameter = "10 mm"
density = "7850 kg/m3"
[powder]
mass = "2 g"
material = "quartz"
size = "200 um"
[contact]
restitution = 0.6
friction = 0.3
[run]
engine = "event"
time = "1 s"
settle = "0.2 s"
replicates = 2
[wear]
[heat]
milling = "30 min"
[capture]
model = "barrios"
fracture_energy = "500 J/kg"
energy_share = 0.1
[breakage]
model = "vogel-peukert"
f_mat = "0.1 kg/J/m"
x_w_min = "0.01 J m/kg"
[fragments]
model = "austin"
share = 0.4
gamma = 0.8
beta = 3
[grinding]
method = "both"
[kinetics]
dose_constant = "5 kJ/g"
property = "amorphous content"
initial = 0
final = 100
"""
NUMBERS = """Object.fromEntries([...document.querySelectorAll('[data-quantity]')]
             .map(cell => [cell.dataset.quantity, Number(cell.dataset.value)]))"""
HEADINGS = {"Replay", "Results", "All quantities", "Collisions by pair", "Impact energies",
            "Wall impacts and charge motion",
            "Time series", "Wear", "Temperatures", "Powder captured by collisions", "Fineness", "Dose",
            "Methods paragraph", "Assumptions and sources"}


def colours(png):
    """Number of colours in a PNG of 8 bits per channel."""
    at, data = 8, b""
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        body = png[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, _, colour = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            data += body
        at += 12 + length
    channels = {2: 3, 6: 4}[colour]
    raw, row, above, seen = zlib.decompress(data), width * channels, None, set()
    for y in range(height):
        kind, line = raw[y * (row + 1)], bytearray(raw[y * (row + 1) + 1:(y + 1) * (row + 1)])
        above = above or bytearray(row)
        for i in range(row):
            a, b = line[i - channels] if i >= channels else 0, above[i]
            c = above[i - channels] if i >= channels else 0
            nearest = min((a, b, c), key=lambda v: abs(a + b - c - v))
            line[i] = (line[i] + (0, a, b, (a + b) // 2, nearest)[kind]) & 255
        above = line
        seen.update(bytes(line[i:i + 3]) for i in range(0, row, channels))
    return len(seen)


class Statements:
    wrong = 0

    def say(self, statement, found, expected, holds):
        self.wrong += not holds
        print(f"{'fine' if holds else 'WRONG'}: {statement}: found {found}, expected {expected}")


def check(browser, folder, states):
    summary = json.loads((folder / "summary.json").read_text())
    browser.size(1000, 900)
    browser.open(folder / "report.html")
    drawn = browser.wait_for("document.querySelector('#replay').dataset.state")
    state = browser.ask("document.querySelector('#replay').dataset.state")
    states.say("the_replay_draws", state, "drawn", drawn and state == "drawn")
    shown = browser.ask(NUMBERS)
    wrong = [name for name, value in shown.items() if summary[name]["value"] != value]
    states.say("numbers_on_the_page_are_those_of_summary_json", wrong, [], not wrong)
    told = {n for n, q in summary.items() if not n.startswith("_") and q["value"] is not None}
    states.say("every_quantity_is_on_the_page", sorted(told - set(shown)), [],
               told == set(shown))
    headings = set(browser.ask("[...document.querySelectorAll('h2')].map(h => h.textContent)"))
    states.say("every_part_is_there", sorted(HEADINGS - headings), [], HEADINGS <= headings)
    states.say("the_page_loads_nothing",
               browser.ask("performance.getEntriesByType('resource').map(e => e.name)"), [],
               not browser.ask("performance.getEntriesByType('resource').length"))
    for theme in ("light", "dark"):
        browser.media(prefers_color_scheme=theme)
        seen = colours(browser.picture("#replay .scene"))
        states.say(f"the_replay_is_not_blank_in_a_{theme}_theme", f"{seen} colours", "> 100",
                   seen > 100)
    check_plots(browser, folder, states)
    check_maps(browser, folder, states)
    states.say("the_browser_has_no_complaint", browser.faults or "none", "none",
               not browser.faults)
    size = (folder / "report.html").stat().st_size
    states.say("the_page_is_below_3_MB", f"{size / 1e6:.2f} MB", "< 3 MB", size < 3e6)


INK = """[...document.querySelectorAll('.chart canvas')].map(canvas => {
           const of = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
           let seen = 0;
           for (let i = 3; i < of.length; i += 4) seen += of[i] > 0;
           return seen / (of.length / 4); })"""
MARKS = "document.querySelector('.chart .chart-tools [aria-pressed]').getAttribute('aria-pressed')"
WHOLE = "document.querySelector('.chart-tools button').hidden"
OVER = """(r => [r.x, r.y, r.width, r.height])
          (document.querySelector('.chart .u-over').getBoundingClientRect())"""


def check_plots(browser, folder, states):
    """The first plot is the spectrum."""
    inked = browser.ask(INK)
    states.say("every_plot_is_drawn", f"{len(inked)}, least ink {min(inked):.3f}",
               ">= 15, more than 1 % of the pixels", len(inked) >= 15 and min(inked) > 0.01)
    browser.ask("document.querySelector('.chart .u-over').scrollIntoView({block: 'center'})")
    x, y, width, height = browser.ask(OVER)
    browser.mouse("mouseMoved", x + 0.5 * width, y + 0.5 * height)
    browser.wait_for("!document.querySelector('.chart-tip').hidden", 10)
    told = browser.ask("document.querySelector('.chart-tip').innerText")
    states.say("the_pointer_tells_the_bin_and_both_series", told.split("\n"),
               "A to B, normal motion, contact point",
               " to " in told and "normal motion" in told and "contact point" in told)
    button = {"button": "left", "buttons": 1, "clickCount": 1}
    browser.mouse("mousePressed", x + 0.5 * width, y + 0.3 * height, **button)
    browser.mouse("mouseMoved", x + 0.8 * width, y + 0.6 * height, button="left", buttons=1)
    browser.mouse("mouseReleased", x + 0.8 * width, y + 0.6 * height, **button)
    zoomed = browser.wait_for(f"!{WHOLE}", 10)
    browser.ask("document.querySelector('.chart-tools button').click()")
    states.say("a_drag_zooms_and_a_button_shows_the_whole_again", [zoomed, browser.ask(WHOLE)],
               [True, True], zoomed and browser.ask(WHOLE))
    before = browser.ask(MARKS)
    browser.ask("document.querySelector('.chart .chart-tools [aria-pressed]').click()")
    states.say("an_axis_may_become_linear", [before, browser.ask(MARKS)], ["true", "false"],
               [before, browser.ask(MARKS)] == ["true", "false"])
    browser.ask("[...document.querySelectorAll('.chart-tools button')]"
                ".find(b => b.textContent === 'CSV').click()")
    saved = (browser.downloaded(".csv") or b"").decode().splitlines()
    heads = (folder / "spectrum.csv").read_text().splitlines()
    column = heads[0].split(",").index("rate_normal_per_s")
    rates = [float(line.split(",")[column]) for line in heads[1:]]
    found = [float(line.rsplit(",", 1)[1]) for line in saved if line.startswith("normal")]
    states.say("saved_numbers_are_those_of_spectrum_csv", f"{len(found)} bins, sum {sum(found):.6g}",
               f"{len(rates)} bins, sum {sum(rates):.6g}",
               len(found) == len(rates) > 0 and abs(sum(found) / sum(rates) - 1) < 1e-6)


MAP = """[...document.querySelectorAll('.figure-canvas')]
         .find(c => c.querySelector('svg')?.getAttribute('aria-label') === 'Impacts on the wall')"""
SAVE = "[...MAP.closest('.chart').querySelectorAll('button')].find(b => b.textContent === '{}').click()"


def check_maps(browser, folder, states):
    """The wall in colours: its cells tell their numbers, which are those of wall_map.csv."""
    maps = browser.ask("document.querySelectorAll('.figure-canvas > svg').length")
    states.say("maps_are_drawn", maps, ">= 3", maps >= 3)
    browser.ask(f"{MAP}.scrollIntoView({{block: 'center'}})")
    x, y, _, _ = browser.ask(f"(r => [r.x, r.y, r.width, r.height])({MAP}.getBoundingClientRect())")
    browser.mouse("mouseMoved", x + 150, y + 60)
    tip = f"{MAP}.parentElement.querySelector('.chart-tip')"
    browser.wait_for(f"!{tip}.hidden", 10)
    told = browser.ask(f"{tip}.innerText")
    states.say("a_cell_tells_its_value_and_place", told.split("\n"), "N W/m², angle and height",
               "W/m²" in told and "angle" in told and "height" in told)
    browser.ask(SAVE.replace("MAP", MAP).format("CSV"))
    saved = (browser.downloaded("wall.csv") or b"").decode().splitlines()
    found = [float(line.rsplit(",", 1)[1]) for line in saved[1:]]
    heads, *rows = [line.split(",") for line in (folder / "wall_map.csv").read_text().splitlines()]
    area, lost = heads.index("area_m2"), heads.index("power_lost_W")
    expected = [float(r[lost]) / float(r[area]) for r in rows if float(r[area]) > 0]
    states.say("saved_cells_are_those_of_wall_map_csv", f"{len(found)} cells, sum {sum(found):.4g}",
               f"{len(expected)} cells, sum {sum(expected):.4g}",
               len(found) == len(expected) > 0 and abs(sum(found) / sum(expected) - 1) < 5e-4)
    first = SAVE.replace("MAP.closest('.chart')", "document.querySelector('.chart')")
    for label, save in (("plot", first), ("map", SAVE.replace("MAP", MAP))):
        browser.ask(save.format("SVG"))
        svg = (browser.downloaded(".svg") or b"").decode()
        whole = svg.startswith("<svg") and "NaN" not in svg and "undefined" not in svg
        if whole:
            xml.etree.ElementTree.fromstring(svg)
        states.say(f"the_saved_svg_of_a_{label}_is_whole", f"{len(svg)} letters", "an <svg>", whole)


def main(program):
    chromium = shutil.which("chromium")
    if not chromium:
        print("skipped: chromium is not installed (apt install chromium)")
        return SKIPPED
    with tempfile.TemporaryDirectory(prefix="report-") as folder:
        folder = pathlib.Path(folder)
        (folder / "case.toml").write_text(CASE)
        subprocess.run([program, "run", folder / "case.toml", "--out", folder / "out", "--quiet"],
                       check=True)
        browser, states = Browser(chromium), Statements()
        try:
            check(browser, folder / "out", states)
        finally:
            browser.close()
    return 1 if states.wrong else 0


sys.exit(main(sys.argv[1]))
