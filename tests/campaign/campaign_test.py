#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Campaigns on the command line: failures, extension, status and export, two processes at once.

  campaign_test.py PROGRAM TEST    exits with 77 if the test cannot run on this machine
"""

import json
import math
import re
import signal
import subprocess
import sys
import time

import campaign
from campaign import Campaign, asked, frequencies, numbers


def failures_are_kept_and_do_not_stop_the_rest(program):
    with Campaign(program, '"balls.diameter" = ["8 mm", "40 mm", "9 mm"]') as c:
        said = c.run(code=3)
        assert "1 run failed" in said, said
        assert [row[0] for row in asked(c.out, "SELECT status FROM results")] == [
            "done", "failed", "done"]
        status = c.part("status")
        assert "balls.diameter = 40 mm" in status and "failed   1" in status, status
        c.part("retry", "--quiet", code=3)
        assert asked(c.out, "SELECT attempts FROM runs WHERE status = 'failed'") == [(2,)]
        assert asked(c.out, "SELECT max(attempts) FROM runs WHERE status = 'done'") == [(1,)]


def a_case_that_fails_everywhere_is_refused(program):
    with Campaign(program, '"balls.diameter" = ["40 mm", "50 mm"]') as c:
        said = c.run(code=2)
        assert "balls.1" in said or "diameter" in said, said
    with Campaign(program, '"mill.frequancy" = ["10 Hz"]') as c:
        assert "did you mean `frequency`?" in c.run(code=2)


def warnings_reach_table_store_page_and_terminal(program):
    """A contact law with adhesion, which the event engine ignores."""
    with Campaign(program, '"contact.surface_energy" = ["0 J/m2", "1 J/m2", "2 J/m2"]') as c:
        c.case.write_text(c.case.read_text().replace("[contact]", '[contact]\nlaw = "jkr"'))
        said = c.run()
        words = "2 of 3 points: sticking-law-ignored: law = "
        assert "Warning: " + words in said, said
        assert words in (c.out / "campaign.html").read_text()
        assert [row["warnings"] for row in numbers(c.out)] == ["", "sticking-law-ignored",
                                                               "sticking-law-ignored"]
        heads, *rows = (c.out / "campaign.csv").read_text().splitlines()
        assert "sticking-law-ignored" in rows[2].split(",")[heads.split(",").index("warnings")]
        assert asked(c.out, "SELECT count(*), max(severity) FROM notices WHERE code = "
                            "'sticking-law-ignored'") == [(2, "invalid")]
        assert words in c.part("status")
        told = json.loads(c.part("status", "--json"))["notices"]
        assert told[0]["code"] == "sticking-law-ignored" and told[0]["count"] == 2, told


def more_points_run_only_what_is_new(program):
    with Campaign(program, '"mill.frequency" = ["10 Hz", "12 Hz"]') as c:
        c.run("--quiet")
        c.case.write_text(c.case.read_text().replace('"12 Hz"]', '"12 Hz", "14 Hz", "10 Hz"]'))
        said = c.run()
        assert "2 runs already done" in said and "1 run in" in said, said
        assert asked(c.out, "SELECT count(*) FROM results") == [(4,)]


def one_at_a_time_leaves_the_case_as_it_is_and_can_be_checked(program):
    sweep = ('design = "one-at-a-time"\n"mill.frequency" = { from = "8 Hz", to = "12 Hz" }\n'
             '"contact.restitution" = { from = 0.5, to = 0.95 }')
    with Campaign(program, sweep) as c:
        subprocess.run([program, "check", str(c.case)], check=True, capture_output=True)
        c.run("--quiet")
        assert asked(c.out, 'SELECT "contact.restitution", "mill.frequency_Hz" FROM results') == [
            (0.9, 10), (0.5, 10), (0.95, 10), (0.9, 8), (0.9, 12)]
        assert '"kind":"bars","title":"dissipated power"' in (c.out / "campaign.html").read_text()


SENSITIVE = ('design = "%s"\nsamples = %d\n"mill.frequency" = { from = "8 Hz", to = "12 Hz" }\n'
             '"contact.rolling_friction" = { from = 0.01, to = 0.1 }')
T_OF_TWO = math.tan(0.475 * math.pi)  # Student's t with one degree of freedom is Cauchy's law


def powers(c):
    """Dissipated power of each point, and its standard error."""
    return [(power, width / T_OF_TWO) for power, width in asked(
        c.out, 'SELECT dissipated_power_W, dissipated_power_ci95_W FROM results ORDER BY point')]


def answers(c):
    """The page's sensitivity of the power to the keys: text, figure, and the row of each key."""
    page = (c.out / "campaign.html").read_text()
    part = page[page.index("What matters"):]
    figure = [f for f in part.split("<figure>") if '"kind":"bars","title":"dissipated power"' in f][0]
    rows = {key: [float(v) if v else math.nan for v in re.findall(r'data-v="([^"]*)"', row)]
            for key, row in re.findall(r"<tr><td>([a-z_.]+)</td>(.*?)</tr>", figure)}
    return part[:part.index("<figure>")], figure, rows


def of_two_replicates_the_noise_of_effects_is_theirs(program):
    with Campaign(program, SENSITIVE % ("morris", 4)) as c:
        c.run("--quiet")
        words, figure, rows = answers(c)
        step, squares = 2 / 3, []
        places = asked(c.out, 'SELECT "mill.frequency_Hz" FROM results ORDER BY point')
        found = powers(c)
        for i in range(len(found) - 1):
            if i % 3 != 2 and places[i] != places[i + 1]:
                squares.append((found[i][1]**2 + found[i + 1][1]**2) / step**2)
        assert len(squares) == 4, places
        expected = math.sqrt(2 / math.pi * sum(squares) / 4)
        size, noise, _, _ = rows["mill.frequency"]
        assert math.isclose(noise, expected, rel_tol=1e-9), (noise, expected)
        assert size > 0 and "Effects of each key: 4." in figure, (rows, figure)
        assert rows["contact.rolling_friction"][0] == 0, rows
        assert words.count("Without effect in this case: contact.rolling_friction.") == 1, words


def of_two_replicates_the_noise_of_shares_is_theirs(program):
    with Campaign(program, SENSITIVE % ("sobol-indices", 8)) as c:
        c.run("--quiet")
        _, figure, rows = answers(c)
        found = powers(c)
        ends = [found[i] for i in range(len(found)) if i % 4 in (0, 3)]  # a and b of each group
        mean = sum(y for y, _ in ends) / len(ends)
        variance = sum((y - mean)**2 for y, _ in ends) / (len(ends) - 1)
        noise = 100 * sum(e**2 for _, e in ends) / len(ends) / variance
        said = float(re.search(r"Noise is ([0-9.]+) % of the observed variance", figure)[1])
        assert abs(said - noise) <= 0.05 * noise, (said, noise)  # printed with two digits
        assert rows["contact.rolling_friction"][1] == 0, rows
        assert "Groups of runs: 8." in figure, figure


def two_at_once_are_refused(program):
    with Campaign(program, frequencies(50), time="60 s") as c:
        first = subprocess.Popen(c.command("--quiet", "--results", "summary"))
        while not (c.out / "campaign.sqlite").exists():  # the lock comes before the store
            time.sleep(0.01)
        said = c.run(code=2)
        assert "another process is at work" in said, said
        assert "a process is running it" in c.part("status")
        first.send_signal(signal.SIGINT)
        assert first.wait() == 130
        assert "interrupted" not in c.part("status")


def export_is_what_the_store_holds(program):
    with Campaign(program, frequencies(3)) as c:
        c.run("--quiet")
        lines = c.part("export").splitlines()
        assert len(lines) == 4 and lines[0].startswith("point,mill.frequency_Hz,status,"), lines[0]
        assert c.part("export") == (c.out / "campaign.csv").read_text()


def export_replaces_nothing_unasked(program):
    with Campaign(program, frequencies(2)) as c:
        c.run("--quiet")
        notes = c.here / "notes.txt"
        notes.write_text("important")
        assert "the file already exists" in c.part("export", "--out", str(notes), code=2)
        assert notes.read_text() == "important"
        c.part("export", "--out", str(notes), "--force")
        assert notes.read_text() == (c.out / "campaign.csv").read_text()


def another_case_does_not_take_the_folder(program):
    with Campaign(program, frequencies(2)) as c:
        c.run("--quiet")
        before = numbers(c.out)
        own = c.case
        c.case = c.here / "other.toml"
        c.case.write_text(own.read_text().replace("A ball", "Another"))
        said = c.run(code=2)
        assert "holds the campaign of" in said and str(own) in said, said
        assert numbers(c.out) == before
        own.unlink()  # as if it had been moved
        c.run("--quiet")
        assert numbers(c.out) == before


if __name__ == "__main__":
    sys.exit(campaign.main(globals()))
