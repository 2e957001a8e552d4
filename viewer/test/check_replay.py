#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Opens made-up reports in a headless Chromium and checks what their replay does.

    viewer/test/check_replay.py [--pictures FOLDER]

Exit code 0: all statements hold; 1: one does not; 77: skipped, as there is no Chromium. Needs
python3 and Debian's chromium alone. --pictures keeps a screenshot of every picture judged.
"""

import argparse
import json
import pathlib
import re
import shutil
import sys
import tempfile

import synthetic
from browser import Browser
from pictures import changed, colours, pixels
from quantities import check_quantities_and_hits

viewer = pathlib.Path(__file__).resolve().parents[1]
report_style = viewer.parent / "src/mahlwerk/report/page.cpp"
dataset = "document.querySelector('#replay').dataset"


def page(data, script=None):
    """A report with nothing but a replay, in the report's own style."""
    style = re.search(r'R"css\((.*?)\)css"', report_style.read_text(), re.S).group(1)
    script = (viewer / "dist/replay.js").read_text() if script is None else script
    return ('<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>replay</title>'
            '<meta name="viewport" content="width=device-width,initial-scale=1">'
            f'<style>{style}</style></head><body><main><h1>Replay</h1>'
            '<section id="replay"></section>'
            f'<script type="application/json" id="replay-data">{json.dumps(data)}</script>'
            f"<script>{script}</script></main></body></html>")


class Checks:
    def __init__(self, browser, folder, pictures):
        self.browser, self.folder, self.pictures = browser, folder, pictures
        self.passed, self.failed = 0, 0

    def say(self, statement, found, expected, holds):
        self.passed, self.failed = self.passed + holds, self.failed + (not holds)
        print(f"{'fine' if holds else 'WRONG'}: {statement}: found {found}, expected {expected}",
              flush=True)

    def open(self, name, data, script=None):
        path = self.folder / f"{name}.html"
        path.write_text(page(data, script))
        self.name = name
        self.browser.open(path)
        self.browser.wait_for(f"{dataset}.state")

    def state(self, key):
        return self.browser.ask(f"{dataset}.{key}")

    def quiet(self):
        found = self.browser.faults
        self.say(f"{self.name}_reports_no_error", found or "none", "none", not found)

    def do(self, script):
        """Does something on the page and waits until it is drawn."""
        self.browser.ask(script)
        self.browser.ask("new Promise(d => requestAnimationFrame(() => requestAnimationFrame(d)))")

    def picture(self, of):
        png = self.browser.picture("#replay .scene")
        if self.pictures:
            (self.pictures / f"{self.name}-{of}.png").write_bytes(png)
        return png

    def scrub(self, frame):
        self.do("(s => { s.value = %d; s.dispatchEvent(new Event('input')); })"
                "(document.querySelector('#replay input[type=range]'))" % frame)

    def views(self):
        return self.browser.ask("[...document.querySelectorAll('#replay [aria-label=View] button')]"
                                ".map(b => b.dataset.key)")

    def press_view(self, key):
        self.do(f"document.querySelector('#replay [data-key={key}]').click()")


def check_case(checks, name, data, views):
    """What holds for every replay. A lit ball alone has hundreds of shades, an empty picture with
    its legend (a gradient of 150 pixels and grey letters) stays below 400 colours."""
    checks.open(name, data)
    checks.say(f"{name}_is_drawn", checks.state("state"), "drawn", checks.state("state") == "drawn")
    checks.say(f"{name}_offers_its_views", checks.views(), views, checks.views() == views)
    first = checks.picture("first")
    count = colours(first)
    checks.say(f"{name}_is_not_blank", f"{count} colours", "above 400", count > 400)
    checks.scrub(len(data["times"]) // 2)
    middle = checks.picture("middle")
    frame = str(len(data["times"]) // 2)
    checks.say(f"{name}_goes_to_the_frame_of_its_slider", checks.state("frame"), frame,
               checks.state("frame") == frame)
    part = changed(first, middle)
    checks.say(f"{name}_shows_another_frame_as_another_picture", f"{part:.2%} of pixels changed",
               "above 0.2%", part > 0.002)
    for key in views:
        checks.press_view(key)
        count = colours(checks.picture(key))
        good = checks.state("view") == key and count > 400
        checks.say(f"{name}_draws_view_{key}", f"{checks.state('view')}, {count} colours",
                   f"{key}, above 400 colours", good)
    checks.quiet()


def check_frames_of_views(checks):
    """In the jar-fixed view nothing but balls moves, in the laboratory the jar does: the empty jar
    tells (positions all zero, one ball hidden in the middle)."""
    data = synthetic.planetary()
    for key in ("positions", "speeds"):
        size = 30 if key == "positions" else 10
        data[key] = synthetic.packed("B", [0] * size * len(data["times"]))
    checks.open("planetary_at_rest", data)
    for key, moves in (("laboratory", True), ("carrier", True), ("centre", True), ("fixed", False)):
        checks.press_view(key)
        checks.browser.ask("document.querySelector('#replay .written').style.display = 'none'")
        checks.scrub(0)
        first = checks.picture(f"{key}-0")
        checks.scrub(37)
        part = changed(first, checks.picture(f"{key}-37"))
        # The disc below is hidden in the jar-fixed view; light and shadow ride with the camera.
        holds = part > 0.005 if moves else part < 0.001
        checks.say(f"jar_{'moves' if moves else 'rests'}_in_view_{key}", f"{part:.2%} changed",
                   "above 0.5%" if moves else "below 0.1%", holds)
    checks.quiet()


def check_balls_outside(checks):
    """Balls that are not in the jar leave the picture of balls without size."""
    data = synthetic.vial()
    numbers = 3 * data["count"] * len(data["times"])
    pictures = {}
    for name, change in (("inside", {}),
                         ("outside", {"positions": synthetic.packed("h", [-32768] * numbers)}),
                         ("empty", {"radius": synthetic.packed("f", [1e-9] * data["count"])})):
        checks.open(f"vial_{name}", {**data, **change})
        pictures[name] = checks.picture(name)
        checks.quiet()
    part = changed(pictures["outside"], pictures["empty"])
    seen = changed(pictures["inside"], pictures["empty"])
    checks.say("balls_outside_are_not_drawn", f"{part:.2%} changed, a ball {seen:.2%}",
               "below 0.01%, a ball above 0.2%", part < 1e-4 and seen > 0.002)


def check_bodies(checks):
    """Bodies have faces in place of their spheres; one is picked by a click on it, and its path is drawn."""
    pictures = {}
    for name, faces in (("spheres", False), ("faces", True)):
        checks.open(f"cube_{name}", synthetic.turning_cube(faces))
        checks.scrub(9)
        pictures[name] = checks.picture(name)
        checks.quiet()
    part = changed(pictures["spheres"], pictures["faces"])
    checks.say("faces_take_the_place_of_spheres", f"{part:.2%} changed", "above 1%", part > 0.01)
    checks.do("(s => { const r = s.getBoundingClientRect(); for (const kind of ['pointerdown', 'pointerup'])"
              " s.dispatchEvent(new PointerEvent(kind, {button: 0, pointerId: 1, clientX: r.left + r.width / 2,"
              " clientY: r.top + r.height / 2})); })(document.querySelector('#replay .scene'))")
    checks.browser.wait_for(f"{dataset}.picked === '0'", 10)
    checks.say("a_click_picks_the_body", checks.state("picked"), "0", checks.state("picked") == "0")
    part = changed(pictures["faces"], checks.picture("picked"))
    checks.say("a_picked_body_is_marked", f"{part:.2%} changed", "above 0.5%", part > 0.005)
    checks.quiet()


def check_keys(checks):
    """Keys, as a person without a mouse uses them."""
    browser = checks.browser
    checks.open("vial_keys", synthetic.vial())
    browser.ask("document.querySelector('#replay .scene').focus()")
    for key, what, expected in (("ArrowRight", "frame", "1"), ("ArrowRight", "frame", "2"),
                                ("ArrowLeft", "frame", "1"), ("v", "view", "centre"),
                                ("c", "colour", "species"), ("b", "picked", "0"),
                                ("Escape", "picked", "none"), (" ", "playing", "true"),
                                (" ", "playing", "false")):
        browser.key(key)
        browser.wait_for(f"{dataset}.{what} === '{expected}'", 10)
        found = checks.state(what)
        name = {" ": "space"}.get(key, key)
        checks.say(f"key_{name}_sets_{what}", found, expected, found == expected)
    nameless = browser.ask("[...document.querySelectorAll('#replay :is(button,input,select)')]"
                           ".filter(e => !(e.getAttribute('aria-label') || e.textContent.trim() ||"
                           " e.closest('label'))).length")
    checks.say("every_control_has_a_name", nameless, 0, nameless == 0)
    checks.quiet()


def check_playing(checks):
    browser = checks.browser
    browser.media(prefers_reduced_motion="no-preference", prefers_color_scheme="light")
    checks.open("vial_playing", synthetic.vial())
    moved = browser.wait_for(f"+{dataset}.frame > 2", 30)
    checks.say("replay_plays_of_its_own_accord", checks.state("frame"), "above 2", moved)
    browser.ask("dispatchEvent(new Event('beforeprint'))")
    playing = checks.state("playing")
    checks.say("printing_pauses", playing, "false", playing == "false")
    drawn = browser.ask("(c => new Set(c.getContext('2d').getImageData("
                        "0, 0, c.width, c.height).data).size)"
                        "(document.querySelector('#replay .print'))")
    checks.say("the_print_shows_the_picture", f"{drawn} levels", "above 100", drawn > 100)
    browser.media(prefers_reduced_motion="reduce", prefers_color_scheme="light")
    checks.open("vial_reduced", synthetic.vial())
    checks.say("reduced_motion_starts_paused", checks.state("playing"), "false",
               checks.state("playing") == "false")
    light = checks.picture("light")
    browser.media(prefers_reduced_motion="reduce", prefers_color_scheme="dark")
    checks.do("0")
    dark = checks.picture("dark")
    corner = sum(pixels(light)[1][80][5]) - sum(pixels(dark)[1][80][5])
    checks.say("theme_follows_the_system_live", f"corner darker by {corner}", "above 300",
               corner > 300)
    browser.media(prefers_reduced_motion="reduce", prefers_color_scheme="light")
    checks.quiet()


def check_mouse(checks):
    browser = checks.browser
    checks.open("vial_mouse", synthetic.vial())
    first = checks.picture("first")
    x, y = browser.ask("(r => [r.x + r.width / 2, r.y + r.height / 2])"
                       "(document.querySelector('#replay .scene').getBoundingClientRect())")
    browser.mouse("mousePressed", x, y, button="left", clickCount=1)
    browser.mouse("mouseMoved", x + 90, y + 60, button="left", buttons=1)
    browser.mouse("mouseReleased", x + 90, y + 60, button="left", clickCount=1)
    checks.do("0")
    part = changed(first, checks.picture("turned"))
    checks.say("dragging_turns_the_picture", f"{part:.2%} changed", "above 1%", part > 0.01)
    checks.quiet()


def check_saving(checks):
    browser = checks.browser
    checks.open("vial_saving", synthetic.vial())
    wide = browser.ask("document.querySelector('#replay .scene').clientWidth")
    browser.ask("[...document.querySelectorAll('#replay button')]"
                ".find(b => b.textContent === 'Picture').click()")
    png = browser.downloaded(".png")
    found = pixels(png)[0] if png else None
    checks.say("saved_picture_is_twice_as_wide", found, 2 * wide, found == 2 * wide)
    browser.ask("(s => { s.value = Math.max(...[...s.options].map(o => +o.value));"
                " s.dispatchEvent(new Event('change')); })"
                "(document.querySelector('#replay select'))")
    browser.ask("[...document.querySelectorAll('#replay button')]"
                ".find(b => b.textContent === 'Video').click()")
    video = browser.downloaded(".webm")
    # The magic number of EBML, RFC 8794 section 11.2.1.
    holds = bool(video) and video[:4] == b"\x1a\x45\xdf\xa3" and len(video) > 2000
    checks.say("saved_video_is_webm", f"{len(video or b'')} bytes", "above 2000, EBML", holds)
    checks.quiet()


def check_bad_data(checks):
    """What is wrong with the data is said in a sentence, without an exception."""
    good = synthetic.vial()
    for name, change, word in (
            ("another_version", {"version": 2}, "version 2"),
            ("short_positions", {"positions": good["positions"][:-8]}, '"positions" holds'),
            ("falling_times", {"times": good["times"][::-1]}, "increase"),
            ("no_meshes", {"meshes": None}, '"meshes" is missing')):
        checks.open(name, {**good, **change})
        said = checks.browser.ask("document.querySelector('#replay').textContent")
        holds = checks.state("state") == "failed" and word in said
        checks.say(f"{name}_is_named", said, f"... {word} ...", holds)
        checks.quiet()


def check_without_webgl(program, folder):
    browser = Browser(program, "--disable-3d-apis")
    try:
        checks = Checks(browser, folder, None)
        checks.open("no_webgl", synthetic.vial())
        said = browser.ask("document.querySelector('#replay').textContent")
        checks.say("without_webgl_a_sentence_says_so", said, "... WebGL ...",
                   checks.state("state") == "no-webgl" and "WebGL" in said)
        exceptions = [fault for fault in browser.faults if "replay" in fault.lower()]
        checks.say("without_webgl_nothing_is_thrown", exceptions or "none", "none", not exceptions)
    finally:
        browser.close()
    return checks


def check_asset():
    """Size and safety of the bundle, without a browser."""
    checks = Checks(None, None, None)
    code = (viewer / "dist/replay.js").read_bytes()
    checks.say("asset_is_below_700_kB", f"{len(code)} bytes", "below 700000", len(code) < 700_000)
    ends = re.findall(rb"</script|<!--", code, re.I)
    checks.say("asset_is_safe_inside_a_script_element", ends or "none", "none", not ends)
    checks.say("asset_begins_with_its_licences", code[:3].decode(), "/*!",
               code.startswith(b"/*!") and b"three.js authors" in code[:3000])
    return checks


def check_pages(checks):
    rides = ["laboratory", "centre", "fixed"]
    checks.browser.media(prefers_reduced_motion="reduce", prefers_color_scheme="light")
    checks.browser.size(1200, 1000)
    check_case(checks, "planetary", synthetic.planetary(), [rides[0], "carrier", *rides[1:]])
    check_case(checks, "drum", synthetic.drum(), rides)
    checks.browser.size(420, 900)
    check_case(checks, "vial", synthetic.vial(), rides)
    wide = checks.browser.ask("document.documentElement.scrollWidth")
    checks.say("nothing_sticks_out_of_a_narrow_page", wide, "at most 420", wide <= 420)
    check_case(checks, "attritor", synthetic.attritor(), rides)
    check_frames_of_views(checks)
    check_balls_outside(checks)
    check_bodies(checks)
    check_quantities_and_hits(checks)
    check_keys(checks)
    check_playing(checks)
    check_mouse(checks)
    check_saving(checks)
    check_bad_data(checks)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--pictures", type=pathlib.Path, help="folder to keep screenshots in")
    options = parser.parse_args()
    program = shutil.which("chromium")
    if not program:
        print("check_replay: skipped, as chromium is not installed (apt install chromium)")
        return 77
    if options.pictures:
        options.pictures.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="replay-pages-") as folder:
        folder = pathlib.Path(folder)
        browser = Browser(program)
        checks = Checks(browser, folder, options.pictures)
        try:
            check_pages(checks)
        finally:
            browser.close()
        all_checks = [check_asset(), checks, check_without_webgl(program, folder)]
    passed, failed = (sum(getattr(c, what) for c in all_checks) for what in ("passed", "failed"))
    print(f"check_replay: {passed} passed, {failed} failed")
    return 1 if failed else 0


sys.exit(main())
