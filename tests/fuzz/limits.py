#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Draws values at, beside and far beyond the limits that every key declares (mahlwerk list keys
--json: range, plausible magnitudes, words), sets one key of a case to each, and lets the program
check the case and run it for a moment with each engine:

    limits.py PROGRAM [--count N] [--seed S] [--all] [--jobs N]

--all takes every value of every key instead of N drawn ones. The program must end with exit code 0,
2 or 3 within 8 GB, with 2 and a remedy; a check within 60 CPU seconds, after which a run is ended.
Prints every value for which it does not, and how many were tried."""
import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import random
import resource
import signal
import subprocess
import tempfile

#: A case, by section; a key whose section has kinds gets a section of its own.
CASE = {
    "mill": {"kind": "planetary", "speed": "300 rpm", "orbit_radius": "70 mm", "ratio": "-2"},
    "jar": {"kind": "cylinder", "diameter": "40 mm", "height": "38 mm"},
    "balls": {"count": "3", "diameter": "10 mm", "density": "7850 kg/m3"},
    "powder": {"mass": "2 g", "size": "40 um", "density": "4000 kg/m3"},
    "contact": {"restitution": "0.6"},
    "run": {"time": "5 ms", "settle": "0 s", "replicates": "2", "sensitivity": "off"},
}
GRINDING = {"capture": {"model": "trapped-volume", "thickness": "80 um"},
            "breakage": {"model": "vogel-peukert", "f_mat": "0.944 kg/J/m", "x_w_min": "0.12 J m/kg"},
            "fragments": {"model": "binary"}, "grinding": {"time": "10 s"}}
#: What else the keys of a section need.
NEEDS = {**dict.fromkeys(GRINDING, GRINDING),
         "kinetics": {"kinetics": {"model": "dose", "dose_constant": "10 J/g"},
                      "milling": {"time": "1 h"}},
         "liquid": {"liquid": {"kind": "film", "film": "10 um", "viscosity": "1 mPa s"}},
         "thermocouple": {"heat": {}}, "heat": {"heat": {}},
         "optimise": {"optimise": {"maximise": "dissipated_power"}}}
#: Sections that a kind needs; and values that neither start nor default nor example give.
KINDS = {
    ("jar.kind", "periodic-box"): {"mill": {"kind": "still"}, "": {"gravity": "0 m/s2"}},
    ("jar.kind", "periodic-cylinder"): {"mill": {"kind": "tumbling", "speed": "70 %"}},
    ("jar.kind", "periodic-lifter-cylinder"): {"mill": {"kind": "tumbling", "speed": "70 %"}},
    ("liquid.kind", "flooded"): {"liquid": {"kind": "flooded", "viscosity": "1 mPa s",
                                            "density": "1 g/cm3"}},
    ("fragments.model", "t10"): {"fragments": {"model": "t10", "t10": "30 %"}},
    ("kinetics.model", "by-impact"): {
        "kinetics": {"model": "by-impact", "processed_share": "1 %", "mass_per_hit": "1 mg"}},
    ("kinetics.model", "thermal"): {
        "kinetics": {"model": "thermal", "temperature": "60 degC", "attempts": "constant",
                     "frequency_factor": "1 1/s", "activation_energy": "100 kJ/mol"}},
    ("kinetics.model", "ignition"): {
        "kinetics": {"model": "ignition", "trigger": "dose", "ignition_dose": "100 J/g"}},
}
SPREADS = {"balls": "1.2", "powder": "2"}
FAR = ("1e308", "-1e308", "1e-308", "nan", "inf", "-inf", "1e400", "", "0", "-1", "x")


def keys(program):
    """Every key with its section."""
    for section in json.loads(subprocess.run([program, "list", "keys", "--json"], check=True,
                                             capture_output=True, text=True).stdout):
        for key in section["keys"]:
            yield section, key


def ends_of(key):
    """The limits of a number: of its range, and those that are only plausible."""
    plausible = key.get("plausible") or {}
    found = [key["least"], key["most"], plausible.get("least"), plausible.get("most")]
    return [end for end in found if end is not None]


def texts(key):
    """Values at, beside and beyond the limits of a key, as a user writes them."""
    if key["type"] == "word":
        return [*key["words"], "", "x" * 5000, "\x1b[2J"]
    if key["type"] == "flag":
        return ["true", "false", "maybe"]
    if key["type"] == "integer":
        beside = {int(end) + step for end in ends_of(key) for step in (-1, 0, 1)}
        return [*map(str, sorted(beside)), "0", "-1", "2.5", str(2 ** 63), "1" * 400, "nan", ""]
    if key["type"] != "number":
        return ["", "x", "[]", "[[]]", "\u0000".join("ab"), "[1e308, -1e308, nan]", "x" * 100000]
    unit = key["unit"]
    numbers = set()
    for end in ends_of(key):
        numbers |= {end, math.nextafter(end, -math.inf), math.nextafter(end, math.inf), 2 * end,
                    0.5 * end, -end, 1e6 * end}
    return [*(f"{n!r} {unit}".strip() for n in sorted(numbers)),
            *(f"{text} {unit}".strip() for text in FAR)]


def case_for(every, section, key):
    """The case, by section, in which the key has a meaning, without the key."""
    own = section["section"]
    made = {name: dict(keys) for name, keys in {**CASE, **NEEDS.get(own, {})}.items()}
    for name, keys in KINDS.get((section["choice"], section["kind"]), {}).items():
        made[name] = dict(keys)
    table = made.setdefault(own, {})
    if section["kind"]:
        word = section["choice"].split(".")[-1]
        if table.get(word) != section["kind"] and own != "contact":
            table = made[own] = {}
        table[word] = section["kind"]
        for other, one in every:
            if other["section"] == own and other["kind"] == section["kind"] and one["required"]:
                table.setdefault(one["key"], one["start"] or one["default"] or one["example"])
    for choice, words in key["under"].items():
        place, word = choice.rsplit(".", 1)
        made.setdefault(place, {})[word] = words[0]
        if word == "distribution" and words[0] != "equal":
            table["spread"] = SPREADS[own]
        if words[0] in ("sieves", "uniform"):
            table.pop("diameter", None), table.pop("size", None), table.pop("spread", None)
    for other in (key["key"], key["instead_of"], *(key["alternatives"] or [])):
        table.pop((other or "").split(".")[-1], None)
    return made


def toml(made):
    """The text of a case."""
    lines = [f"{key} = {json.dumps(value)}" for key, value in made.get("", {}).items()]
    for name, keys in made.items():
        if name:
            lines.append("[[balls]]" if name == "balls" else f"[{name}]")
            lines += [f"{key} = {value if value.isdigit() else json.dumps(value)}"
                      for key, value in keys.items() if value is not None]
    return "\n".join(lines) + "\n"


MEMORY = 8_000_000_000  # [bytes]


def limit(memory=True):
    resource.setrlimit(resource.RLIMIT_CPU, (60, 60))
    if memory:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def limit_for(program):
    """Limits under which the program starts: a sanitizer reserves terabytes of addresses."""
    starts = subprocess.run([program, "--version"], preexec_fn=limit, check=False,
                            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0
    return limit if starts else lambda: limit(memory=False)


def tried(program, limits, text, setting, command):
    """Whether the program takes the case, and what is wrong with its answer; empty if nothing is."""
    with tempfile.TemporaryDirectory() as folder:
        case = pathlib.Path(folder) / "case.toml"
        case.write_text(text)
        words = [program, command[0], str(case)]
        if command[0] == "run":
            words += ["--out", f"{folder}/out", "--quiet", "--threads", "1",
                      "--set", f"run.engine={command[1]}"]
        words += ["--set", setting.replace("\u0000", "\\u0000")]
        ended = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               preexec_fn=limits, check=False)
    said = ended.stdout.decode(errors="replace")
    if command[0] == "run" and ended.returncode == -signal.SIGKILL:
        return True, ""  # a long run, still at work after 60 CPU seconds
    taken = ended.returncode in (0, 3)
    if not taken and ended.returncode != 2:
        return taken, f"exit code {ended.returncode}: {said[-200:]}"
    if ended.returncode == 2 and "remedy:" not in said:
        return taken, f"no remedy: {said[-200:]}"
    return taken, said[-200:] if "internal error" in said else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    every, limits = list(keys(options.program)), limit_for(options.program)
    drawn = []
    for section, key in every:
        text = toml(case_for(every, section, key))
        place = {"": "", "balls": "balls.1."}.get(section["section"], section["section"] + ".")
        drawn += [(text, f"{place}{key['key']}={value}", command) for value in texts(key)
                  for command in (("check",), ("run", "event"), ("run", "soft"))]
    names = {setting.split("=")[0] for _, setting, _ in drawn}
    if not options.all:
        drawn = random.Random(options.seed).sample(drawn, min(options.count, len(drawn)))
    bad, reached = 0, set()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        answers = pool.map(lambda one: tried(options.program, limits, *one), drawn)
        for (_, setting, command), (taken, wrong) in zip(drawn, answers):
            if taken:
                reached.add(setting.split("=")[0])
            if wrong:
                bad += 1
                print(f"{' '.join(command)} {setting[:80]!r}: {wrong}", flush=True)
    print(f"{len(drawn)} values of keys tried, {bad} answered wrongly; "
          f"{len(reached)} of {len(names)} keys had a value that was taken")
    if options.all:
        print("never taken:", ", ".join(sorted(names - reached)))
    return 1 if bad else 0


if __name__ == "__main__":
    raise SystemExit(main())
