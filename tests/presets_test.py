#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Every name that a test preset excludes is the name of a test, and docs/developers/tests.md names the slow tests.

    presets_test.py CMakePresets.json BUILD_FOLDER

Otherwise a renamed test would run under the sanitizers again, unnoticed, and the nightly list would be wrong.
"""
import json
import pathlib
import re
import subprocess
import sys


def alternatives(pattern):
    """`a.(b|c)|d` -> a.b, a.c, d."""
    made, depth, part = [], 0, ""
    for character in pattern + "|":
        depth += {"(": 1, ")": -1}.get(character, 0)
        if character == "|" and depth == 0:
            made.append(part)
            part = ""
        else:
            part += character
    return [whole for part in made for whole in expanded(part)]


def expanded(part):
    group = re.search(r"\(([^()]*)\)", part)
    if not group:
        return [part]
    return [whole for choice in group.group(1).split("|")
            for whole in expanded(part[:group.start()] + choice + part[group.end():])]


def not_in_nightly_list(presets, build):
    """Tests with the label slow that the nightly list of docs/developers/tests.md does not name."""
    text = (pathlib.Path(presets).parent / "docs/developers/tests.md").read_text()
    named = re.findall(r"`(\w+\.\w*)`", text.split("## The nightly list")[1].split("\n## ")[0])
    shown = subprocess.run(["ctest", "--show-only=json-v1", "--test-dir", build], capture_output=True,
                           text=True, check=True)
    slow = [test["name"] for test in json.loads(shown.stdout)["tests"] for key in test.get("properties", ())
            if key["name"] == "LABELS" and {"slow", "verification_slow"} & set(key["value"])]
    return [name for name in slow if not name.startswith(tuple(named))], len(slow)


def main(presets, build):
    with open(presets) as file:
        filters = [preset["filter"]["exclude"]["name"] for preset in json.load(file)["testPresets"]
                   if "name" in preset.get("filter", {}).get("exclude", {})]
    listed = subprocess.run(["ctest", "-N", "--test-dir", build], capture_output=True, text=True, check=True)
    tests = re.findall(r"Test +#\d+: (\S+)", listed.stdout)
    names = [name for pattern in filters for name in alternatives(pattern)]
    unknown = [name for name in names if not any(re.search(name, test) for test in tests)]
    print(f"expected: each of {len(names)} names is that of a test; found: {unknown or 'all are'}")
    # CMake's regular expressions have nine groups at most; with more a filter matches nothing.
    groups = max(pattern.count("(") for pattern in filters)
    print(f"expected: at most 9 groups in a filter; found: {groups}")
    missing, slow = not_in_nightly_list(presets, build)
    print(f"expected: docs/developers/tests.md names each of {slow} slow tests; found: {missing or 'it does'}")
    return 1 if unknown or not names or groups > 9 or missing or not slow else 0


sys.exit(main(*sys.argv[1:]))
