#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Prints the force of the piston over its travel, from the power that it draws: force = power / speed.

    python3 examples/13-parts/force.py results/piston/timeseries.csv
"""

import csv
import math
import sys

AMPLITUDE, OMEGA = 6e-3, 2 * math.pi * 2  # m, rad/s: those of piston.toml

with open(sys.argv[1]) as file:
    rows = [(float(row["time_s"]), float(row["drawn_power_W"])) for row in csv.DictReader(file)]
window = rows[1][0] - rows[0][0]
print("travel (mm)  force (N)")
for time, power in rows[9::10]:
    middle = time - window / 2
    travel = AMPLITUDE * (1 - math.cos(OMEGA * middle))
    print("%11.2f  %9.2f" % (1e3 * travel, power / (AMPLITUDE * OMEGA * math.sin(OMEGA * middle))))
