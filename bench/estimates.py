#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Compares what `mahlwerk check` says of the time of a run with the run itself:

    bench/estimates.py PROGRAM CASE... [--set KEY=VALUE]...

Prints a row per case: the estimate [s], the run [s], their ratio. Run it on a machine that does nothing
else: the estimate comes from a pilot run of the same moment."""
import argparse
import json
import subprocess
import sys
import tempfile
import time


def estimate(program, case, settings):
    """[s] of the line run_time of `check`."""
    said = subprocess.run([program, "check", case, "--json", *settings], capture_output=True, text=True,
                          check=True)
    return json.loads(said.stdout)[0]["follows"]["run_time"]["value"]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("cases", nargs="+")
    parser.add_argument("--set", action="append", default=[])
    options = parser.parse_args()
    settings = [word for key in options.set for word in ("--set", key)]
    within = 0
    print("| case | estimate, s | run, s | ratio |\n|---|---|---|---|")
    for case in options.cases:
        expected = estimate(options.program, case, settings)
        begin = time.monotonic()
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([options.program, "run", case, "--out", f"{folder}/out", "--quiet", *settings],
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        took = time.monotonic() - begin
        within += 0.5 <= expected / took <= 2
        print(f"| {case} | {expected:.2g} | {took:.2g} | {expected / took:.2f} |", flush=True)
    print(f"within a factor of two: {within} of {len(options.cases)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
