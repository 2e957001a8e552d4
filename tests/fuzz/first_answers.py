#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Draws plain cases as users write them (mill x jar x balls x restitution x friction x speed, in the
words of a mill, engine and settling left out), runs each with the defaults and as a careful run of
the soft engine (settled, stiff contacts, longer), and compares power, rate of hits
above the threshold and their mean energy:

    first_answers.py PROGRAM COUNT [--seed S] [--first I] [--jobs N] [--limit SECONDS]
                     [--reference FILE] [--careful PROGRAM] [--warned]

A quantity is right if it is within 10 %, or within its interval and that of the careful run. A case
is fine if all three are right or a warning is given; it is bad if one is off by more than 20 %,
beyond the intervals, without a warning. The careful runs are kept in the reference file, so that a
second program is compared with the same ones. Prints each case that is not fine, and the shares."""
import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import random
import resource
import subprocess
import tempfile

QUANTITIES = ("dissipated_power", "collision_rate_above_threshold",
              "energy_normal_mean_above_threshold")
NEAR, FAR = 0.10, 0.20


def decades(rng, low, high):
    return 10 ** rng.uniform(math.log10(low), math.log10(high))


def mill(rng):
    """Lines of [mill], inner diameter of a usual jar [mm], a period of the mill [s]."""
    kind, = rng.choices(["planetary", "mixer", "shaker", "vibration", "drum"], [3, 2, 2, 2, 1])
    if kind == "planetary":
        name, low, high, jars = rng.choice([
            ("retsch-pm100", 150, 600, (38, 64)), ("retsch-pm400", 100, 400, (64, 100)),
            ("fritsch-p7-classic", 200, 800, (40, 40)), ("fritsch-p5-classic", 100, 400, (75, 100))])
        speed = rng.uniform(low, high)
        return f'model = "{name}"\nspeed = "{speed:.4g} rpm"', rng.uniform(*jars), 60 / speed
    if kind == "mixer":
        frequency = rng.uniform(10, 30)
        return (f'kind = "arc-shaker"\nfrequency = "{frequency:.4g} Hz"\narm = "136 mm"\n'
                f'swing = "3.9 deg"'), rng.uniform(15, 30), 1 / frequency
    if kind == "shaker":
        frequency = rng.uniform(10, 20)
        return (f'kind = "figure-eight"\nfrequency = "{frequency:.4g} Hz"\n'
                f'stroke_along = "25 mm"\nstroke_across = "5 mm"\nstroke_up = "5 mm"'), 38, \
            1 / frequency
    if kind == "vibration":
        frequency = rng.uniform(10, 50)
        amplitude = 1e3 * rng.uniform(2, 12) * 9.81 / (2 * math.pi * frequency) ** 2
        return (f'kind = "vibration"\nfrequency = "{frequency:.4g} Hz"\n'
                f'amplitude = "{amplitude:.4g} mm"'), rng.uniform(15, 40), 1 / frequency
    size = rng.uniform(60, 120)
    share = rng.uniform(30, 90)
    critical = math.sqrt(2 * 9.81 / (0.85e-3 * size))
    return (f'kind = "tumbling"\nspeed = "{share:.3g} %"'), size, \
        2 * math.pi / (share / 100 * critical)


def case(seed, index):
    """The case without [run], the period of its mill [s], and its number of balls."""
    rng = random.Random(f"{seed} {index}")
    words, size, period = mill(rng)
    drum = "tumbling" in words
    height = size * (rng.uniform(0.3, 0.6) if drum else rng.uniform(0.8, 1.6))
    ball = size * (rng.uniform(0.16, 0.24) if drum else rng.uniform(0.15, 0.42))
    most = 0.3 * (math.pi / 4 * size ** 2 * height) / (math.pi / 6 * ball ** 3)
    count = max(1, min(15, round(decades(rng, 1, max(1.1, most)))))
    if drum:
        count = max(6, min(14, round(most * rng.uniform(0.3, 0.8))))
    density, = rng.choices([7850, 6050, 14900, 3900], [5, 3, 1, 1])
    return (f'title = "plain case {index}"\nseed = {index + 1}\n[mill]\n{words}\n'
            f'[jar]\nkind = "cylinder"\ndiameter = "{size:.4g} mm"\nheight = "{height:.4g} mm"\n'
            f'[[balls]]\ncount = {count}\ndiameter = "{ball:.4g} mm"\ndensity = "{density} kg/m3"\n'
            f'[powder]\nmass = "2 g"\nsize = "40 um"\ndensity = "4000 kg/m3"\n'
            f'[contact]\nrestitution = {rng.uniform(0.2, 0.9):.3g}\n'
            f'friction = {rng.uniform(0.05, 0.6):.3g}\n'), period, count


def run(program, text, folder, limit):
    """The quantities and the codes of the warnings of a run; None if it takes more than `limit` CPU
    seconds, or writes no result."""
    path = pathlib.Path(folder) / "case.toml"
    path.write_text(text)
    subprocess.run([program, "run", path, "--out", f"{folder}/out", "--force", "--quiet",
                    "--threads", "1"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit)),
                   check=False)
    try:
        result = json.loads((pathlib.Path(folder) / "out/summary.json").read_text())
    except (OSError, ValueError):
        return None
    found = {name: result[name] for name in QUANTITIES}
    values = {name: (q["value"], q.get("ci95") or 0) for name, q in found.items()}
    codes = [n["code"] for n in result["_about"]["notices"] if n["severity"] in ("warning", "invalid")]
    return values, codes


def careful(program, text, period, balls, folder):
    """A settled run with stiff contacts: three turns of a drum, 6 to 12 of a planetary mill's disc,
    25 to 60 oscillations of other mills, more for fewer balls."""
    turning = "rpm" in text or "tumbling" in text
    settle = (2 if turning else 12) * period
    least, most = (3, 3) if "tumbling" in text else (6, 12) if turning else (25, 60)
    counted = min(most, max(least, 60 / balls)) * period
    return run(program, text + f'softening = 1\n[run]\nengine = "soft"\nsettle = "{settle:.4g} s"\n'
               f'time = "{counted:.4g} s"\nreplicates = 3\n', folder, 600)


def off(found, right):
    """Relative error of a quantity, and whether it is beyond both intervals."""
    (value, half), (true, true_half) = found, right
    if value is None or true is None or true == 0:
        return 0.0, False
    error = value / true - 1
    return error, abs(value - true) > math.hypot(half or 0, true_half or 0)


def examine(options, known, index):
    text, period, balls = case(options.seed, index)
    counted = max(0.3, 5 * period)
    with tempfile.TemporaryDirectory() as folder:
        right = known.get(str(index)) or careful(options.careful or options.program, text, period,
                                                 balls, folder)
        plain = run(options.program, text + f'[run]\ntime = "{counted:.3g} s"\n', folder,
                    options.limit)
    if right is None:
        return index, "no-reference", "", right
    if plain is None:
        return index, "bad", f"does not end in {options.limit} CPU s", right
    values, codes = plain
    errors = {name: off(values[name], right[0][name]) for name in QUANTITIES}
    wrong = {n: e for n, (e, sure) in errors.items() if abs(e) > NEAR and sure}
    text_of = ", ".join(f"{n} {e:+.0%}" for n, e in wrong.items())
    if not wrong:
        return index, "right", "", right
    if codes:
        return index, "warned", f"{text_of} ({', '.join(codes)})", right
    return index, "bad" if any(abs(e) > FAR for e in wrong.values()) else "off", text_of, right


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("count", type=int)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--reference", type=pathlib.Path)
    parser.add_argument("--limit", type=int, default=300, help="CPU seconds that a run may take")
    parser.add_argument("--warned", action="store_true", help="print the cases with warnings too")
    parser.add_argument("--careful", help="the program of the careful runs, if another")
    options = parser.parse_args()
    known = {}
    if options.reference and options.reference.exists():
        known = json.loads(options.reference.read_text())
    tally, kept = {}, dict(known)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        indices = range(options.first, options.first + options.count)
        for index, verdict, words, right in pool.map(
                lambda i: examine(options, known, i), indices):
            tally[verdict] = tally.get(verdict, 0) + 1
            kept[str(index)] = right
            if verdict not in ("right", "warned") or options.warned and verdict == "warned":
                print(f"case {index}: {verdict}: {words}", flush=True)
            if options.reference:
                options.reference.write_text(json.dumps(kept))
    done = sum(tally.values()) - tally.get("no-reference", 0)
    fine = tally.get("right", 0) + tally.get("warned", 0)
    print(f"{done} cases: {100 * fine / max(1, done):.1f} % right or warned "
          f"({tally.get('right', 0)} right, {tally.get('warned', 0)} warned), "
          f"{tally.get('off', 0)} off, {tally.get('bad', 0)} bad, "
          f"{tally.get('no-reference', 0)} without a reference")
    return 0 if 100 * fine >= 99 * done and not tally.get("bad") else 1


if __name__ == "__main__":
    raise SystemExit(main())
