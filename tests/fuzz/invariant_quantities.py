#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Runs plain mills (those of first_answers.py) with settings of the computation that are no
properties of the mill, and compares every quantity of summary.json:

    invariant_quantities.py PROGRAM [MILLS] [--jobs N] [--keep FILE]

The settings: contacts softened, half the time step, the event engine, and its contact time
quartered. A quantity is invariant if, over the mills that give no warning, the mean of its relative
change is within SYSTEMATIC or four of its standard errors, and no mill changes it by more than
LARGE beyond four times both intervals. SAID lists the quantities that depend on a setting by
definition, and where the documents say so."""
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
SOFTENING = 0.03
SAID = {
    "softening": {},
    "step": {},
    "event": {},
    "contact_time": {},
}
PAIRS = {"softening": ("soft", "softer"), "step": ("soft", "finer"), "event": ("soft", "event"),
         "contact_time": ("event", "shorter")}


def mills(count):
    """Plain mills that take few seconds: index, case, period [s]."""
    index = 0
    while count > 0:
        text, period, balls = first_answers.case("invariant", index)
        if period * balls < 0.8 and balls > 1:
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
    window = f'time = "{max(0.2, 15 * period):.4g} s"\nsettle = "{6 * period:.4g} s"\nreplicates = 4\n'
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


def change(one, other):
    """Relative change of a quantity, and over both intervals; None if it has no number."""
    a, b = one["value"], other["value"]
    if a is None or b is None or one["ci95"] is None or other["ci95"] is None:
        return None
    size = max(abs(a), abs(b))
    if size == 0:
        return 0.0, 0.0
    both = math.hypot(one["ci95"], other["ci95"])
    return (b - a) / size, abs(b - a) / both if both > 0 else math.inf if a != b else 0.0


def judge(made, setting, name):
    """What is wrong with a quantity under a setting, in words; None if it is invariant."""
    first, second = PAIRS[setting]
    found, large = [], []
    for (index, _, _), runs in made:
        one, other = runs[first], runs[second]
        if name not in one or name not in other or warnings(one) | warnings(other):
            continue
        if (difference := change(one[name], other[name])) is None:
            continue
        found.append(difference[0])
        if abs(difference[0]) > LARGE and difference[1] > 4:
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
        silent = sum(not (warnings(runs[first]) | warnings(runs[second])) for _, runs in made)
        names = {n for _, runs in made for n in runs[first] if not n.startswith("_")}
        print(f"{setting}: {silent} of {len(made)} mills give no warning, {len(names)} quantities")
        for name in sorted(names - SAID[setting].keys()):
            if said := judge(made, setting, name):
                print("  " + said)
                wrong += 1
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
