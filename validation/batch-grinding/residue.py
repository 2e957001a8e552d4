# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The share of the mass that is left in the top class over time, and the exponent of the time between two rows.

    residue.py CAMPAIGN_FOLDER
"""
import csv
import math
import pathlib
import sys

folder = pathlib.Path(sys.argv[1])
print("sigma  time (s)  left   fines  exponent")
before = None
for row in csv.DictReader((folder / "campaign.csv").open()):
    sizes = list(csv.DictReader((folder / row["folder"] / "bed_sizes.csv").open()))
    sigma, time, left = row["breakage.sigma"], float(row["run.time_s"]), 1 - float(sizes[1]["passing"])
    exponent = ""
    if before and before[0] == sigma:
        exponent = f"{math.log(math.log(left) / math.log(before[2])) / math.log(time / before[1]):.2f}"
    print(f"{sigma:5}  {time:8}  {left:.3f}  {float(row['fines_share']):.3f}  {exponent}")
    before = (sigma, time, left)
