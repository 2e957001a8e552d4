# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Quantities of test_quantities.py computed a second time: those of a slice of a ball mill, by the formulas of mill
power, and those of a vessel with blades, by its tables of parts and mixing."""
import math

import numpy as np

GRAVITY = 9.81


def bulk_of_slice():
    """Mass [kg] and bulk density [kg/m3] of the balls, and their bulk volume over that of the slice."""
    mass = 120 * 7850 * math.pi / 6 * 0.2**3
    # A bar is a rectangle on the chord between its feet, with the segment of the circle under it (geo.14).
    chord = math.sqrt(1.2**2 - 0.1**2)
    bar = 0.2 * (chord - 1.1) + 1.2**2 * math.asin(0.1 / 1.2) - 0.1 * chord
    area = math.pi * 1.2**2 - 12 * bar
    return mass, 0.6 * 7850, mass / 7850 / 0.6 / (area * 0.6)


SLICE_SPEED = 20 / 60 / (math.sqrt(2 * GRAVITY / 2.4) / (2 * math.pi))  # over the critical speed of Bond


def bond():
    mass, _, filling = bulk_of_slice()
    return mass * 4.879 * 2.4**0.3 * (3.2 - 3 * filling) * SLICE_SPEED * (1 - 0.1 / 2**(9 - 10 * SLICE_SPEED))


def hogg_fuerstenau():
    _, density, filling = bulk_of_slice()
    return (238 * (2.4 / 0.3048)**2.5 * 0.6 / 0.3048 * SLICE_SPEED * density / 1000 * filling
            * (1 - 1.065 * filling) * math.sin(math.radians(35)))


def morrell():
    """Power [W], toe and shoulder [deg from the lowest point]: the layers of the charge are lifted from toe to
    shoulder and leave with their kinetic energy, summed over the radius (Morrell 1993)."""
    _, density, j = bulk_of_slice()
    top, turns, phi = 1.2, 1 / 3, SLICE_SPEED
    late = max(phi, 0.35 * (3.364 - j))
    toe = math.pi / 2 + 2.5307 * (1.2796 - j) * (1 - math.exp(-19.42 * (late - phi)))
    shoulder = math.pi / 2 - (toe - math.pi / 2) * (0.3386 + 0.1041 * phi + (1.54 - 2.5673 * phi) * j)
    arc, lift = 2 * math.pi + shoulder - toe, math.sin(shoulder) - math.sin(toe)
    in_bed = arc / (math.pi * turns)
    flying = math.sqrt(top * (1 + math.sqrt(1 - 2 * math.pi * j / arc)) * lift / GRAVITY)
    inner = top * math.sqrt(1 - 2 * math.pi * j / arc * in_bed / (in_bed + flying))
    still = (1 - j)**0.4532 * inner  # radius at which the charge would not turn
    edges = np.linspace(inner, top, 20001)
    r = (edges[1:] + edges[:-1]) / 2
    speed = 2 * math.pi * turns * top * (r - still) / (top - still)
    layers = density * 0.6 * (GRAVITY * r * speed * lift + speed**3 / 2)
    return 1.26 * layers.sum() * (top - inner) / 20000, math.degrees(toe) - 270, math.degrees(shoulder) + 90


SLICE = {
    "power_per_charge": lambda run: run["drawn_power"] / bulk_of_slice()[0],
    "power_per_length": lambda run: run["drawn_power"] / 1000 / 0.6,
    "power_of_whole_mill": lambda run: 6 * run["drawn_power"],
    "bond_power": lambda run: bond(),
    "power_over_bond": lambda run: run["drawn_power"] / bond(),
    "hogg_fuerstenau_power": lambda run: hogg_fuerstenau(),
    "power_over_hogg_fuerstenau": lambda run: run["drawn_power"] / hogg_fuerstenau(),
    "morrell_power": lambda run: morrell()[0],
    "power_over_morrell": lambda run: run["drawn_power"] / morrell()[0],
    "morrell_toe_angle": lambda run: morrell()[1],
    "morrell_shoulder_angle": lambda run: morrell()[2],
}


def late(column):
    """The mean of the samples of the second half of the counted time (mix.3)."""
    def of(run):
        table = run.result.table("mixing")
        times = table["time_s"]
        return float(np.mean(table[column][times >= times[-1] / 2 - 1e-9]))
    return of


def dispersion(table):
    """[m2/s] Half the slope of the mean square way, by its ends in the second half of the samples (mix.6)."""
    times, way = table["time_s"], table["axial_spread_m2"]
    half = len(times) // 2
    return 0.5 * float((way[-1] - way[half]) / (times[-1] - times[half]))


def mixing_time(table):
    """[s] Until one minus the neighbour mixing index has fallen to 1/e of its first value (mix.3)."""
    times, apart = table["time_s"], 1 - table["neighbour_mixing_index"]
    wanted = apart[0] / math.e
    at = int(np.argmax(apart <= wanted))
    return times[at - 1] + (apart[at - 1] - wanted) / (apart[at - 1] - apart[at]) * (times[at] - times[at - 1])


BLADES = {
    "parts_power": (lambda run: run["parts_torque"] * 300 * 2 * math.pi / 60, 1e-9),
    "parts_torque": (lambda run: run.result.table("parts")["torque_N_m"].sum(), 1e-9),
    "lacey_index": (late("lacey_index"), 1e-6),
    "neighbour_mixing_index": (late("neighbour_mixing_index"), 1e-6),
    "segregation_radial": (late("segregation_radial"), 1e-6),
    "segregation_vertical": (late("segregation_vertical"), 1e-6),
    "packing_fraction": (late("packing_fraction"), 1e-6),
    "bed_porosity": (lambda run: 1 - late("packing_fraction")(run), 1e-6),
    "bed_height": (late("bed_height_m"), 1e-6),
    "mixing_time": (lambda run: mixing_time(run.result.table("mixing")), 1e-6),
    "axial_dispersion": (lambda run: dispersion(run.result.table("mixing")), 1e-6),
    "wear_rate_parts": (lambda run: run["contamination_rate"] * 2 / 3600e9 - run["wear_rate_balls"]
                        - run["wear_rate_jar"], 1e-6),
}
