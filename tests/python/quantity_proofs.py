# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Quantities of test_quantities.py computed a second time: those of a slice of a ball mill, by the formulas of mill
power, those of a vessel with blades, by its tables of parts and mixing,
of a bed, by its balls, of a hopper and of a drum with a motor, by their tables."""
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
    """[s] Time constant of the exponential of the least sum of squares (mix.3)."""
    times, index = table["time_s"], table["neighbour_mixing_index"]

    def squares(constant):
        basis = np.stack([np.ones_like(times), np.exp(-times / constant)], axis=1)
        return np.sum((index - basis @ np.linalg.lstsq(basis, index, rcond=None)[0])**2)
    least, most = times[1] / 4, 10 * times[-1]
    for _ in range(8):  # each grid a tenth as wide as the one before
        grid = np.geomspace(least, most, 200)
        best = min(grid, key=squares)
        width = (most / least)**0.05
        least, most = best / width, best * width
    return best


def packing(run):
    """Around random places of the bed at the end (mix.5): those at least R from the wall and with no place within
    R + d where another ball would fit."""
    balls = run.result.table("final-1")
    d, drum, period = 8e-3, 48e-3, 19.2e-3
    axis = next(a for a in "xyz" if np.abs(balls[f"{a}_m"]).max() <= period / 2 + 1e-9)
    along = balls[f"{axis}_m"]
    y, z = (balls[f"{a}_m"] for a in "xyz" if a != axis)
    centres = np.concatenate([np.stack([y, z, along + k * period], axis=1) for k in range(-3, 4)])
    random = np.random.default_rng(1)

    def places(count, wall):
        at = random.uniform(-drum, drum, (count, 3))
        at[:, 2] *= (0.5 + 2) * period / drum if wall < d else 0.5 * period / drum
        return at[np.hypot(at[:, 0], at[:, 1]) < drum - wall]

    def nearest(points, others):
        return np.array([np.sqrt(np.min(np.sum((others - p)**2, axis=1))) for p in points])
    room = places(20000, d / 2)
    room = room[nearest(room, centres) > d]
    points = places(4000, 1.5 * d)
    points = points[nearest(points, room) > 2.5 * d]
    filled = []
    for p in points:
        gap = np.sqrt(np.sum((centres - p)**2, axis=1))
        cap = np.clip(2 * d - gap, 0, None)
        lens = math.pi * cap**2 * (gap**2 + 4 * d * gap - 3 * d**2) / (12 * gap)
        filled.append(np.sum(np.where(gap <= d, math.pi / 6 * d**3, lens)) / (4 * math.pi / 3 * (1.5 * d)**3))
    return float(np.mean(filled))


BLADES = {
    "parts_power": (lambda run: run["parts_torque"] * 300 * 2 * math.pi / 60, 1e-9),
    "parts_torque": (lambda run: run.result.table("parts")["torque_N_m"].sum(), 1e-9),
    "lacey_index": (late("lacey_index"), 1e-6),
    "neighbour_mixing_index": (late("neighbour_mixing_index"), 1e-6),
    "segregation_radial": (late("segregation_radial"), 1e-6),
    "segregation_vertical": (late("segregation_vertical"), 1e-6),
    "segregation_axial": (late("segregation_axial"), 1e-6),
    "bed_height": (late("bed_height_m"), 1e-6),
    "mixing_time": (lambda run: mixing_time(run.result.table("mixing")), 1e-6),
    "axial_dispersion": (lambda run: dispersion(run.result.table("mixing")), 1e-6),
    "wear_rate_parts": (lambda run: run["contamination_rate"] * 2 / 3600e9 - run["wear_rate_balls"]
                        - run["wear_rate_jar"], 1e-6),
}


def residence(moment):
    """[s] The mean of t, or [s^2] that of t^2, by the steps of the distribution in residence.csv (flo.7)."""
    def of(run):
        table = run.result.table("residence")
        times, inside = table["time_s"], 1 - table["share_left"]
        assert inside[-1] < 1e-9, "the last ball that was followed has left"
        return float(np.sum(inside[:-1] * np.diff(times**moment)))
    return of


def passed(column):
    """Per second, by the last row of flow.csv."""
    return lambda run: run.result.table("flow")[column][-1] / run.time


def inside(column):
    """The mean over the rows of flow.csv."""
    return lambda run: np.mean(run.result.table("flow")[column])


HOPPER = {
    "discharge_rate": (passed("left"), 1e-4),  # a window ends at a step
    "discharge_mass_rate": (lambda run: run["discharge_rate"] * 7850 * math.pi / 6 * 3e-3**3, 1e-6),
    "feed_rate": (passed("entered"), 1e-4),
    "feed_mass_rate": (lambda run: run["feed_rate"] * 7850 * math.pi / 6 * 3e-3**3, 1e-6),
    "holdup": (inside("inside"), 2e-3),
    "holdup_mass": (lambda run: run["holdup"] * 7850 * math.pi / 6 * 3e-3**3, 1e-6),
    "residence_time": (lambda run: run["holdup"] / run["discharge_rate"], 1e-6),
    "tracer_residence_time": (residence(1), 0.01),
    "residence_time_spread": (lambda run: math.sqrt(residence(2)(run) - residence(1)(run)**2), 0.01),
}


def passing_size(share):
    """[m] By bed_sizes.csv, on a straight line in the logarithm of the size."""
    def of(run):
        table = run.result.table("bed_sizes")
        size, passing = table["size_m"][::-1], table["passing"][::-1]
        return float(np.exp(np.interp(share, passing, np.log(size))))
    return of


def finer_than_spheres(run):
    """Spheres have the sizes 1.5 mm 2^(-k/3) down to 0.7 mm, the middles of their classes."""
    table = run.result.table("bed_sizes")
    return float(np.interp(1.5e-3 * 2**(-3.5 / 3), table["size_m"][::-1], table["passing"][::-1]))


BREAKING = {
    "broken_grain_rate": (lambda run: run.result.table("bed_breakage")["broken"][-1] / run.time, 1e-3),
    "bed_d10": (passing_size(0.1), 1e-3),
    "bed_d50": (passing_size(0.5), 1e-3),
    "bed_d90": (passing_size(0.9), 1e-3),
    "fines_share": (finer_than_spheres, 1e-3),
    "breakage_power": (lambda run: run["dissipated_power"] - run["dissipated_power_normal"]
                       - run["dissipated_power_tangential"] - run["dissipated_power_rolling"], 1e-6),
}


def rebound(at_jar):
    """By the hits of the run (fbk.1), each of which loses 0.1 mJ more than a clean one, or all of its rebound."""
    def of_hits(hits):
        chosen = hits[(hits["other"] < 0) == at_jar]
        energy = chosen["mass"] * chosen["approach"]**2 / 2
        return math.sqrt(0.36 - np.minimum(1e-4, 0.36 * energy).sum() / energy.sum())
    return lambda run: run.mean(of_hits)


DAMPED = {  # the accuracy that the case asks for, and bins of the spectrum
    "restitution_balls_with_powder": (rebound(False), 0.05),
    "restitution_jar_with_powder": (rebound(True), 0.05),
}


def per_time(column):
    """The change of a column of drive.csv over the counted time."""
    def of(run):
        table = run.result.table("drive")
        return float((table[column][-1] - table[column][0]) / (table["time_s"][-1] - table["time_s"][0]))
    return of


DRIVEN = {
    "driven_speed": (lambda run: per_time("angle_rad")(run) * 30 / math.pi, 1e-6),
    "driven_speed_end": (lambda run: float(run.result.table("drive")["speed_rpm"][-1]), 1e-6),
    "drive_torque": (lambda run: 0.05 * (1 - float(run.result.table("drive")["speed_rpm"].mean()) / 90), 1e-6),
    "drive_power": (per_time("motor_work_J"), 1e-6),
}
