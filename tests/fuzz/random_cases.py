#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Draws random valid cases over mill x jar x balls x parts x law x restitution x friction x filling for
both engines, runs each for a short time, and checks properties that every valid case has:

    random_cases.py PROGRAM COUNT [--seed S] [--first I] [--jobs N] [--slow FACTOR] [--keep FOLDER]

The run ends with 0 or a stated reason, no number is NaN, no energy is gained, no ball is outside,
the energy balance closes or a warning is given, and the program ends within a second after SIGINT
(times FACTOR, for a build with sanitizers). Failing cases are kept as TOML with a description of
the fault."""
import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time


def decades(rng, low, high):
    return 10 ** rng.uniform(math.log10(low), math.log10(high))


def mill(rng, size, jar_kind):
    """A mill as TOML lines; `size` [mm] of the jar. A slice of a drum turns, but for a few that are refused."""
    kind = rng.choice(["vibration", "planetary", "tumbling", "arc-shaker", "circular", "still"])
    if jar_kind == "periodic-lifter-cylinder" and rng.random() < 0.9:
        kind = "tumbling"
    lines = {
        "vibration": f'frequency = "{decades(rng, 1, 120):.4g} Hz"\n'
                     f'amplitude = "{decades(rng, 0.1, 30):.4g} mm"',
        "planetary": f'speed = "{decades(rng, 10, 1500):.4g} rpm"\n'
                     f'orbit_radius = "{rng.uniform(30, 150):.4g} mm"\n'
                     f'ratio = {rng.choice([-3, -2, -1.18, -1, -0.5, 1])}',
        "tumbling": f'speed = "{decades(rng, 5, 300):.4g} %"',
        "arc-shaker": f'frequency = "{decades(rng, 1, 40):.4g} Hz"\narm = "150 mm"\n'
                      f'swing = "{rng.uniform(0.5, 10):.4g} deg"',
        "circular": f'speed = "{decades(rng, 60, 2400):.4g} rpm"\n'
                    f'radius = "{decades(rng, 1, 20):.4g} mm"',
        "still": "",
    }[kind]
    return f'[mill]\nkind = "{kind}"\n{lines}\n'


def jar(rng, size, exact):
    d, h = size, size * rng.uniform(0.6, 2)
    kinds = ["cylinder", "capsule", "rounded-cylinder", "sphere", "box"]
    kind = rng.choice(kinds if exact else kinds + ["lifter-cylinder", "periodic-lifter-cylinder"])
    lifters = f'lifters = 4\nlifter_height = "{0.06 * d:.5g} mm"\nlifter_width = "{0.08 * d:.5g} mm"'
    lines = {
        "cylinder": f'diameter = "{d:.5g} mm"\nheight = "{h:.5g} mm"',
        "capsule": f'diameter = "{d:.5g} mm"\nheight = "{h:.5g} mm"',
        "rounded-cylinder": f'diameter = "{d:.5g} mm"\nheight = "{h:.5g} mm"\n'
                            f'fillet = "{rng.uniform(0.05, 0.45) * min(d, h):.5g} mm"',
        "sphere": f'diameter = "{d:.5g} mm"',
        "box": f'width = "{d:.5g} mm"\ndepth = "{d * rng.uniform(0.7, 1.5):.5g} mm"\n'
               f'height = "{h:.5g} mm"',
        "lifter-cylinder": f'diameter = "{d:.5g} mm"\nheight = "{h:.5g} mm"\n{lifters}',
        "periodic-lifter-cylinder": f'diameter = "{d:.5g} mm"\nlength = "{h:.5g} mm"\n{lifters}',
    }[kind]
    return f'[jar]\nkind = "{kind}"\n{lines}\n', kind


def balls(rng, size):
    text = ""
    for _ in range(rng.choice([1, 1, 1, 2])):
        diameter = size * rng.choice([rng.uniform(0.08, 0.45), rng.uniform(0.2, 0.3)])
        number = (f"count = {rng.choice([1, 2, 3, 5, 12, 30, 60])}" if rng.random() < 0.6 else
                  f'filling = "{rng.uniform(2, 25):.3g} %"')
        text += (f'[[balls]]\ndiameter = "{diameter:.5g} mm"\n{number}\n'
                 f'density = "{rng.choice([1200, 2500, 6000, 7850, 15000])} kg/m3"\n')
    return text


def solid(rng, size):
    """A shape of a part as TOML lines."""
    kind = rng.choice(["disc", "cylinder", "cone", "blade", "plane"])
    wide, thin = size * rng.uniform(0.1, 0.5), size * rng.uniform(0.03, 0.1)
    lines = {
        "disc": f'diameter = "{wide:.5g} mm"\nthickness = "{thin:.5g} mm"',
        "cylinder": f'diameter = "{thin:.5g} mm"\nlength = "{wide:.5g} mm"',
        "cone": f'diameter = "{wide:.5g} mm"\nlength = "{wide:.5g} mm"',
        "blade": f'length = "{wide:.5g} mm"\nthickness = "{thin:.5g} mm"\nheight = "{wide:.5g} mm"',
        "plane": "",
    }[kind]
    return f'kind = "{kind}"\n{lines}\n', kind


def motion(rng, size):
    """A motion of a part as TOML lines."""
    kind = rng.choice(["fixed", "turning", "oscillating", "swinging"])
    lines = {
        "fixed": "",
        "turning": f'speed = "{decades(rng, 10, 1000):.4g} rpm"',
        "oscillating": f'frequency = "{decades(rng, 1, 40):.4g} Hz"\n'
                       f'amplitude = "{size * rng.uniform(0.01, 0.1):.4g} mm"',
        "swinging": f'frequency = "{decades(rng, 1, 20):.4g} Hz"\nswing = "{rng.uniform(1, 60):.4g} deg"',
    }[kind]
    return f'motion = "{kind}"\n{lines}\n'


def parts(rng, size):
    """Bodies of the mill in the jar."""
    text = ""
    for number in range(rng.choice([0, 0, 1, 2])):
        shape, kind = solid(rng, size)
        low = -0.4 if kind == "plane" else rng.uniform(-0.3, 0.3)
        axis = rng.choice(["[0, 0, 1]", "[0, 0, 1]", "[1, 0, 0]", "[1, 1, 1]"])
        frame = rng.choice(["jar", "jar", "laboratory"])
        text += (f'[[parts]]\nname = "part{number}"\n{shape}axis = {axis}\nframe = "{frame}"\n'
                 f'position = ["0 mm", "{size * rng.uniform(-0.2, 0.2):.5g} mm", "{size * low:.5g} mm"]\n'
                 + motion(rng, size))
    return text


def case(seed, index):
    """The case of a seed and an index, as TOML."""
    rng = random.Random(f"{seed}/{index}")
    engine = rng.choice(["event", "event", "soft", "auto"])
    size = decades(rng, 10, 300)
    jar_text, kind = jar(rng, size, engine == "event")
    e = rng.choice([0, 0, 1, 1, 0.05, 0.3, 0.5, 0.8, 0.95, round(rng.random(), 3)])
    mu = rng.choice([0, 0.001, 0.1, 0.3, 0.8, 1.5])
    contact = f"[contact]\nrestitution = {e}\nfriction = {mu}\n"
    if engine == "event":
        contact += f"tangential_restitution = {rng.choice([1, 0.5, 0, -0.5, -1])}\n"
    if engine == "soft":
        law = rng.choice(["hertz-mindlin", "linear-spring", "hertz-tsuji"])
        contact += f'law = "{law}"\nsoftening = {rng.choice([0.01, 0.1])}\n'
        if law == "linear-spring":
            contact += 'stiffness = "100 kN/m"\n'
    rolling = rng.choice([0, 0.01, 0.5])
    contact += f"rolling_friction = {rolling}\n"
    speed = rng.choice([0, 0.1, 0.1, 5, 100])
    time_span = rng.choice([0.005, 0.02, 0.05])
    settle = rng.choice([0, 0.005])
    if speed == 100:  # fast balls need short time steps of the soft engine
        time_span, settle = time_span / 20, settle / 20
    return (f'title = "random case {index}"\nseed = {rng.randrange(1000000)}\n'
            f'gravity = "{rng.choice([9.81, 9.81, 0])} m/s2"\n' + mill(rng, size, kind) + jar_text +
            balls(rng, size) + (parts(rng, size) if engine != "event" else "") + contact +
            f'[run]\nengine = "{engine}"\ntime = "{time_span} s"\n'
            f'settle = "{settle} s"\nreplicates = 1\nstart_speed = "{speed} m/s"\n')


def nans(value, path=""):
    if isinstance(value, dict):
        for key, one in value.items():
            yield from nans(one, f"{path}.{key}")
    elif isinstance(value, list):
        for i, one in enumerate(value):
            yield from nans(one, f"{path}[{i}]")
    elif isinstance(value, float) and not math.isfinite(value):
        yield path


def quantity(summary, name):
    found = summary.get(name, {})
    return found.get("value") if isinstance(found, dict) else None


def wrong_with_result(folder):
    """Faults that no result of a valid case may have; a list of sentences."""
    text = (folder / "summary.json").read_text()
    summary = json.loads(text)
    codes = {n["code"] for n in summary.get("_about", {}).get("notices", [])}
    wrong = [f"{path} is not finite" for path in nans(summary)]
    soft = summary.get("_about", {}).get("engine") == "soft"  # may gain energy, and reports it
    if codes & {"no-result", "energy-residual"} or ("energy-gained" in codes and not soft):
        wrong.append(f"notices {sorted(codes)}")
    lost = quantity(summary, "dissipated_power")
    drawn = quantity(summary, "drawn_power") or 0
    if lost is not None and lost < -1e-6 * (1e-3 + abs(drawn)) and not soft:
        wrong.append(f"dissipated power {lost} W")
    overlap = quantity(summary, "deepest_overlap")
    if overlap is not None and not overlap < 0.2 and "deep-overlap" not in codes:
        wrong.append(f"overlap {overlap} without a warning")
    return wrong


def run(program, text, folder, slow, interrupt):
    """Runs one case. Returns the fault as a sentence, or None, and how the run ended."""
    folder.mkdir(parents=True)
    (folder / "case.toml").write_text(text)
    out = folder / "out"
    command = [program, "run", str(folder / "case.toml"), "--out", str(out), "--quiet", "--jobs", "1"]
    if interrupt:
        command += ["--set", "run.time=1e6 s"]
    with open(folder / "stderr", "wb") as err:
        # In a background job SIGINT is ignored, and the program would inherit that.
        process = subprocess.Popen(
            command, stdout=err, stderr=err,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
    try:
        if interrupt:
            time.sleep(interrupt * slow)
            process.send_signal(signal.SIGINT)
            began = time.monotonic()
            code = process.wait(timeout=60)
            took = time.monotonic() - began
            if took > 1.0 * slow:
                return f"answered SIGINT after {took:.1f} s", "interrupted"
        else:
            code = process.wait(timeout=60 * slow)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
        return "did not end", "hung"
    said = (folder / "stderr").read_text(errors="replace")
    if code in (2, 3) and len(said.strip()) < 20:
        return f"exit code {code} without a reason", "silent"
    if code == -signal.SIGINT and interrupt and not out.exists():  # before the run began
        return None, "interrupted"
    if code not in (0, 2, 3, 130) or (code == 130 and not interrupt):
        return f"exit code {code}: {said.strip()[-1500:]}", "failed"
    if code == 3:  # stopped by physics, with a reason
        return None, "stopped"
    if (out / "summary.json").exists():
        wrong = [] if interrupt else wrong_with_result(out)
        if wrong:
            return "; ".join(wrong), "wrong"
    elif code == 0:
        return "no summary.json", "wrong"
    return None, {0: "fine", 2: "refused", 130: "interrupted"}[code]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("count", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--slow", type=float, default=1.0)
    parser.add_argument("--keep", type=pathlib.Path)
    args = parser.parse_args()
    work = pathlib.Path(tempfile.mkdtemp(prefix="mahlwerk-fuzz-"))
    ends, bad = {}, 0

    def one(index):
        text = case(args.seed, index)
        folder = work / str(index)
        # Every tenth case would run for ever and is interrupted at some time in its first second.
        interrupt = 0.05 + (index * 37 % 100) / 125 if index % 10 == 9 else 0
        wrong, end = run(args.program, text, folder, args.slow, interrupt)
        if wrong and args.keep:
            args.keep.mkdir(parents=True, exist_ok=True)
            (args.keep / f"{args.seed}-{index}.toml").write_text(f"{text}\n# {wrong!r}\n")
        shutil.rmtree(folder, ignore_errors=True)
        return index, wrong, end

    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for index, wrong, end in pool.map(one, range(args.first, args.first + args.count)):
            ends[end] = ends.get(end, 0) + 1
            if wrong:
                bad += 1
                print(f"case {index} of seed {args.seed}: {wrong}", flush=True)
    shutil.rmtree(work, ignore_errors=True)
    print(f"{args.count} cases of seed {args.seed}: " +
          ", ".join(f"{n} {end}" for end, n in sorted(ends.items())) + f"; {bad} wrong")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
