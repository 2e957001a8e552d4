# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The share of the grains that broke against the work of the plate by their mass, and its slope.

    slope.py CAMPAIGN_FOLDER

The slope A is that of a line through the shares from 0.08 to 0.92 against the logarithm of the energy, K the energy
at which the line begins.
"""
import collections
import csv
import json
import math
import pathlib
import sys

folder = pathlib.Path(sys.argv[1])
points = collections.defaultdict(list)
for row in csv.DictReader((folder / "campaign.csv").open()):
    summary = json.loads((folder / row["folder"] / "summary.json").read_text())
    mass = 0.39e-3  # [kg]
    work = summary["parts_power"]["value"] * summary["simulated_time"]["value"] / mass
    sizes = list(csv.DictReader((folder / row["folder"] / "bed_sizes.csv").open()))
    points[row["breakage.sigma"]].append((work, float(sizes[1]["passing"])))

print("sigma  work (J/kg): share broken")
for sigma, found in points.items():
    print(f"{sigma:5}  " + ", ".join(f"{work:.0f}: {share:.3f}" for work, share in found))
    line = [(math.log(work), share) for work, share in found if 0.08 <= share <= 0.92]
    x, y = (sum(p[k] for p in line) / len(line) for k in (0, 1))
    slope = sum((a - x) * (b - y) for a, b in line) / sum((a - x) ** 2 for a, _ in line)
    print(f"       A = {slope:.3f}, K = {math.exp(x - y / slope):.0f} J/kg, K exp(1/A) = "
          f"{math.exp(x + (1 - y) / slope):.0f} J/kg")
