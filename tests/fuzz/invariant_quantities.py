#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Runs plain mills (those of first_answers.py) with settings of the computation that are no
properties of the mill, and compares every quantity of summary.json:

    invariant_quantities.py PROGRAM [MILLS] [--jobs N] [--keep FILE]

The settings: contacts softened, half the time step, the event engine, and its contact time
quartered. A quantity is invariant if the mean of its relative change over the mills is within
SYSTEMATIC or four of its standard errors, and no mill changes it by more than LARGE beyond four
times both intervals. Mills that give a warning are left out, except for softening, which always
gives one: there the quantities that no warning names are to be invariant. WEAK are the quantities
of all collisions, however weak, and of the time in contact: docs/theory/engine-choice.md says that
they depend on the engine and on softening. Power, rate of hits and their mean energy are to agree
within AGREED, or within twice the intervals, in every mill without a warning."""
import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

import first_answers

SYSTEMATIC, LARGE = 0.05, 0.20
AGREED = {"dissipated_power": 0.05, "collision_rate_above_threshold": 0.10,
          "energy_normal_mean_above_threshold": 0.10}
SOFTENING = 0.03
WEAK = {"collision_rate", "collision_rate_between_balls", "collision_rate_with_jar",
        "collision_rate_in_flight", "impacts_per_ball", "energy_normal_mean",
        "energy_contact_point_mean", "energy_centre_mean", "energy_lost_mean",
        "energy_tangential_mean", "impact_speed_normal_mean", "impact_speed_tangential_mean",
        "impact_angle_mean", "grazing_share", "tangential_impact_power", "specific_impact_power",
        "contact_time_share", "flight_share", "lasting_contacts_rate"}
SAID = {"softening": WEAK, "step": set(), "event": WEAK, "contact_time": set()}
PAIRS = {"softening": ("soft", "softer"), "step": ("soft", "finer"), "event": ("soft", "event"),
         "contact_time": ("event", "shorter")}


def mills(count):
    """Plain mills that take few seconds: index, case, period [s]."""
    index = 0
    while count > 0:
        text, period, balls = first_answers.case("invariant", index)
        if period * balls < 0.4 and balls > 1:
            yield index, text, period
            count -= 1
        index += 1


def time_step(program, text):
    """[us] The soft engine's own step."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "case.toml"
        path.write_text(text)
        said = subprocess.run([program, "check", path], capture_output=True, text=True, check=True)
    return float(re.search(r"Time step ([0-9.]+) us", said.stdout).group(1))


def run(program, text, lines, contact=""):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "case.toml"
        path.write_text(f"{text}{contact}\n[run]\n{lines}")
        done = subprocess.run([program, "run", path, "--out", f"{folder}/out", "--quiet", "--threads",
                               "1"], capture_output=True, text=True, check=False)
        try:
            return json.loads((pathlib.Path(folder) / "out/summary.json").read_text())
        except OSError:
            raise SystemExit(f"{done.stderr}\n{path.read_text()}") from None


def results(program, mill):
    """Of each setting of one mill: the quantities, and the codes of its warnings."""
    _, text, period = mill
    window = f'time = "{max(0.1, 8 * period):.4g} s"\nsettle = "{4 * period:.4g} s"\nreplicates = 4\n'
    soft = window + 'engine = "soft"\n'
    made = {"soft": run(program, text, soft, "softening = 1\n")}
    step = time_step(program, f"{text}softening = 1\n[run]\n{soft}")
    made["finer"] = run(program, text, soft + f'time_step = "{step / 2:.4g} us"\n', "softening = 1\n")
    made["softer"] = run(program, text, soft, f"softening = {SOFTENING}\n")
    event = window + 'engine = "event"\n'
    made["event"] = run(program, text, event)
    made["shorter"] = run(program, text, event, 'contact_time = "25 us"\n')
    return made


def warnings(result):
    return {n["code"] for n in result["_about"]["notices"] if n["severity"] in ("warning", "invalid")}


def change(name, one, other):
    """Relative change of a quantity, and over both intervals; None if it has no number. An imbalance
    is relative to the power, and its change is taken as it is."""
    a, b = one["value"], other["value"]
    if a is None or b is None or one["ci95"] is None or other["ci95"] is None:
        return None
    size = 1 if name == "power_imbalance" else max(abs(a), abs(b))
    if size == 0:
        return 0.0, 0.0
    both = math.hypot(one["ci95"], other["ci95"])
    return (b - a) / size, abs(b - a) / both if both > 0 else math.inf if a != b else 0.0


def judge(pairs, name, warned):
    """What is wrong with a quantity in the two results of mills, in words; None if it is invariant."""
    found, large = [], []
    for index, one, other in pairs:
        silent = not (warnings(one) | warnings(other))
        if name not in one or name not in other or not (silent or warned):
            continue
        if (difference := change(name, one[name], other[name])) is None:
            continue
        found.append(difference[0])
        # Twice both intervals of four replicates: chance exceeds them in 1 of 1000 comparisons.
        far = abs(difference[0]) > AGREED.get(name, 1) and difference[1] > 2
        if abs(difference[0]) > LARGE and difference[1] > 4 or silent and far:
            large.append(f"mill {index} {difference[0]:+.0%}")
    if len(found) < 3:
        return None
    mean, error = statistics.fmean(found), statistics.stdev(found) / math.sqrt(len(found))
    if abs(mean) > max(SYSTEMATIC, 4 * error):
        return f"{name}: {mean:+.1%} +- {error:.1%} over {len(found)} mills"
    return f"{name}: {', '.join(large)}" if large else None


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("mills", type=int, nargs="?", default=30)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--keep", type=pathlib.Path, help="file of the results, read if it exists")
    options = parser.parse_args()
    chosen = list(mills(options.mills))
    if options.keep and options.keep.exists():
        made = json.loads(options.keep.read_text())
    else:
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            made = list(zip(chosen, pool.map(lambda mill: results(options.program, mill), chosen)))
        if options.keep:
            options.keep.write_text(json.dumps(made))
    wrong = 0
    for setting, (first, second) in PAIRS.items():
        pairs = [(mill[0], runs[first], runs[second]) for mill, runs in made]
        silent = sum(not (warnings(one) | warnings(other)) for _, one, other in pairs)
        names = {n for _, one, _ in pairs for n in one if not n.startswith("_")} - SAID[setting]
        print(f"{setting}: {len(names)} quantities, {len(made)} mills, {silent} without a warning")
        for name in sorted(names):
            if said := judge(pairs, name, warned=setting == "softening"):
                print("  " + said)
                wrong += 1
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
