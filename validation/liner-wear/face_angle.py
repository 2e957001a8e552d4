# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The face angles of worn lifters, from the radius, between a quarter and three quarters of their height.

    face_angle.py RESULT_FOLDER
"""
import csv
import math
import pathlib
import sys


def width(section: list[tuple[float, float]], radius: float) -> float:
    """Where the outline crosses x = radius on the side of positive y, the leading one."""
    crossings = []
    for (ax, ay), (bx, by) in zip(section, section[1:] + section[:1]):
        if ax != bx and (ax - radius) * (bx - radius) <= 0:
            crossings.append(ay + (radius - ax) / (bx - ax) * (by - ay))
    return max(crossings)


def face_angle(section: list[tuple[float, float]], shell: float, height: float) -> float:
    low, high = shell - 0.25 * height, shell - 0.75 * height
    return math.degrees(math.atan2(width(section, low) - width(section, high), low - high))


folder = pathlib.Path(sys.argv[1])
corners = list(csv.DictReader((folder / "wear_profile.csv").open()))
print("time (h)  height (mm)  leading face (deg)  trailing face (deg)  power (kW)")
for stage in csv.DictReader((folder / "wear_evolution.csv").open()):
    outline = [(float(c["x_m"]), float(c["y_m"])) for c in corners if c["stage"] == stage["stage"]]
    mirrored = [(x, -y) for x, y in reversed(outline)]
    shell, height = 0.5 * float(stage["jar_diameter_m"]), float(stage["height_lifters_m"])
    print(f"{float(stage['time_s']) / 3600:8.0f}  {1e3 * height:11.1f}  {face_angle(outline, shell, height):18.1f}"
          f"  {face_angle(mirrored, shell, height):19.1f}  {1e-3 * float(stage['dissipated_power_W']):10.0f}")
