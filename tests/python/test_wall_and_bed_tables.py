# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The tables of the wall, of wear and of the bed of a drum, computed a second time from records and fields."""
import math

import numpy as np
import pytest

import mahlwerk
from quantity_runs import CASES, run_of
from test_quantities import energies
from test_tables import EXACT, is_same, rates

# The wall, a cylinder of 40 mm x 40 mm.

def cells(hits):
    """Part, angle about the axis from 0 to 2 pi, and height or distance from the axis of hits on the jar (obs.4)."""
    on_jar = hits[hits["other"] < 0]
    disc = np.abs(on_jar["normal_z"]) > math.sqrt(0.5)
    part = np.where(disc, np.where(on_jar["normal_z"] > 0, "top", "bottom"), "side")
    angle = np.arctan2(on_jar["where_y"], on_jar["where_x"]) % (2 * math.pi)
    across = np.where(disc, np.hypot(on_jar["where_x"], on_jar["where_y"]), on_jar["where_z"])
    return on_jar, part, angle, across


def test_the_wall_map_holds_each_hit_in_its_cell():
    run = run_of("flying")
    rows = run.result.table("wall_map")
    found = np.zeros((len(rows), 4))
    for hits in run.hits:
        on_jar, part, angle, across = cells(hits)
        normal = energies(on_jar)["normal"]
        load = on_jar["lost_tangential"] / 0.3  # (wea.3)
        for i, row in enumerate(rows):
            inside = (part == row["part"]) & (angle >= row["angle_low_rad"]) & (angle < row["angle_high_rad"]) & (
                across >= row["across_low_m"]) & (across < row["across_high_m"])
            found[i] += [inside.sum(), normal[inside].sum(), energies(on_jar)["lost"][inside].sum(), load[inside].sum()]
    found /= run.time * len(run.hits)
    for i, name in enumerate(("rate_per_s", "power_normal_W", "power_lost_W", "slid_N_m_per_s")):
        is_same(rows[name], found[:, i], name)
    assert found[:, 0].sum() == pytest.approx(rates(run, lambda h: np.sum(h["other"] < 0)), rel=EXACT)


def test_the_cells_of_the_wall_are_even_and_have_its_area():
    rows = run_of("flying").result.table("wall_map")
    side = rows[rows["part"] == "side"]
    assert len(side) == 60 * 30 and len(rows) == 60 * 30 + 2 * 6 * 30
    is_same(side["angle_high_rad"] - side["angle_low_rad"], 2 * math.pi / 60, "angle")
    is_same(side["across_high_m"] - side["across_low_m"], 0.04 / 30, "height")
    assert side["across_low_m"].min() == pytest.approx(-0.02) and side["across_high_m"].max() == pytest.approx(0.02)
    is_same(side["area_m2"], math.pi * 0.04 * 0.04 / (60 * 30), "area", rel=1e-3)  # facets of the drawn wall
    for part in ("bottom", "top"):
        disc = rows[rows["part"] == part]
        is_same(disc["across_high_m"]**2 - disc["across_low_m"]**2, 0.02**2 / 6, "rings of equal area")
        is_same(disc["angle_high_rad"] - disc["angle_low_rad"], 2 * math.pi / 30, "angle")
        assert disc["area_m2"].sum() == pytest.approx(math.pi * 0.02**2, rel=2e-3)


def erosion(hits):
    """m u^2 f(a) of each record (wea.4, wea.6)."""
    u, t = hits["approach"], hits["slip"]
    angle = np.arctan2(u, t)
    cut = np.where(3 * u <= t, np.sin(2 * angle) - 3 * np.sin(angle)**2, np.cos(angle)**2 / 3)
    return hits["mass"] * (u * u + t * t) * cut


def test_wear_by_cell_is_that_of_its_hits():
    run = run_of("flying")
    rows = run.result.table("wall_map")
    found = np.zeros(len(rows))
    for hits in run.hits:
        on_jar, part, angle, across = cells(hits)
        for i, row in enumerate(rows):
            inside = (part == row["part"]) & (angle >= row["angle_low_rad"]) & (angle < row["angle_high_rad"]) & (
                across >= row["across_low_m"]) & (across < row["across_high_m"])
            found[i] += erosion(on_jar[inside]).sum()
    found *= 2e-4 / (600 * 9.80665e6) / (run.time * len(run.hits)) / rows["area_m2"]
    is_same(rows["wear_depth_rate_m_per_s"], found, "depth", least=1e-25)


@pytest.mark.parametrize("name", ["flying", "mixed"])
def test_wear_is_that_of_the_hits_on_each_body(name):
    run = run_of(name)
    rows = {row["body"]: row for row in run.result.table("wear")}
    law = WEAR[name]
    bodies = {"balls.1": [0, 4 if name == "mixed" else 6], "balls.2": [4, 9]}
    if name == "flying":
        del bodies["balls.2"]
    for body, (low, high) in bodies.items():
        mine = lambda ball: ((ball >= low) & (ball < high)).astype(float)
        volume = rates(run, lambda h: np.sum((mine(h["ball"]) + mine(h["other"])) * law(h))) / VICKERS[name][body]
        assert rows[body]["volume_rate_m3_per_s"] == pytest.approx(volume, rel=EXACT)
        assert rows[body]["mass_rate_kg_per_s"] == pytest.approx(7850 * volume, rel=EXACT)
    faces = {"jar.side": -1, "jar.bottom": -2, "jar.top": -3}
    assert set(rows) == {*bodies, *faces}
    for body, number in faces.items():
        volume = rates(run, lambda h: np.sum((h["other"] == number) * law(h))) / 600
        assert rows[body]["volume_rate_m3_per_s"] == pytest.approx(volume, rel=EXACT)
        assert rows[body]["mass_rate_kg_per_s"] == pytest.approx(DENSITY_OF_JAR[name] * volume, rel=EXACT)


HARDNESS = 9.80665e6  # [Pa] of 1 HV (wea.2)
VICKERS = {"flying": {"balls.1": 600}, "mixed": {"balls.1": 600, "balls.2": 400}}
WEAR = {"flying": lambda h: 2e-4 * erosion(h) / HARDNESS,
        "mixed": lambda h: 1e-3 * h["lost_tangential"] / 0.3 / HARDNESS}  # Archard (wea.1, wea.3), over the hardness
DENSITY_OF_JAR = {"flying": 7850, "mixed": 7000}


# The bed of a drum, from the cells of its fields; one replicate.

CELLS, DRUM_RADIUS = 48, 0.05
CELL = 2 * DRUM_RADIUS / CELLS


class Bed:
    def __init__(self, run):
        rows = run.result.table("fields")
        rows = rows[rows["frame"] == "carrier"]
        self.density, self.momentum = np.zeros((CELLS, CELLS)), np.zeros((CELLS, CELLS, 2))
        for row in rows:
            i, j = (round((row[axis] + DRUM_RADIUS) / CELL - 0.5) for axis in ("x_m", "y_m"))
            self.density[i, j] = row["density_kg_per_m2"]
            self.momentum[i, j] = row["density_kg_per_m2"] * np.array(
                [row["velocity_x_m_per_s"], row["velocity_y_m_per_s"]])
        self.middles = (np.arange(CELLS) + 0.5) * CELL - DRUM_RADIUS
        whole = self.density.sum()
        self.centre = np.array([(self.density.sum(axis=1) * self.middles).sum(),
                                (self.density.sum(axis=0) * self.middles).sum()]) / whole
        self.down = self.centre / np.hypot(*self.centre)
        self.across = np.array([-self.down[1], self.down[0]])  # in the sense of rotation

    def at(self, distance):
        """Density and velocity across the line, bilinear between the middles of cells (obs.11)."""
        place = np.clip((distance * self.down + DRUM_RADIUS) / CELL - 0.5, 0, CELLS - 1)
        i, j = np.minimum(place.astype(int), CELLS - 2)
        a, b = place - [i, j]
        density = momentum = 0.0
        for di, dj, weight in ((0, 0, (1 - a) * (1 - b)), (1, 0, a * (1 - b)), (0, 1, (1 - a) * b), (1, 1, a * b)):
            density += weight * self.density[i + di, j + dj]
            momentum += weight * self.momentum[i + di, j + dj] @ self.across
        return density, momentum / density if density > 0 else math.nan


@pytest.fixture(scope="module")
def bed():
    return Bed(run_of("drum"))


def test_the_line_through_the_bed_is_that_of_its_fields(bed):
    rows = run_of("drum").result.table("bed")
    is_same(rows["distance_m"], np.arange(-CELLS, CELLS + 1) * CELL / 2, "half cells", least=1e-15)
    found = np.array([bed.at(distance) for distance in rows["distance_m"]])
    is_same(rows["density_kg_per_m2"], found[:, 0], "density", least=1e-9 * found[:, 0].max())
    there = found[:, 0] > 1e-9 * found[:, 0].max()
    is_same(rows["velocity_m_per_s"][there], found[there, 1], "velocity", rel=1e-6)
    assert np.all(np.isnan(rows["velocity_ci95_m_per_s"])), "one replicate"


def test_numbers_of_the_bed_are_those_of_its_line(bed):
    run = run_of("drum")
    rows = run.result.table("bed")
    x, y = bed.centre
    assert run["charge_distance"] == pytest.approx(np.hypot(x, y), rel=1e-9)
    assert run["charge_lever_arm"] == pytest.approx(x, rel=1e-9)
    assert run["bed_angle"] == pytest.approx(math.degrees(math.atan2(x, -y)), rel=1e-9)
    place, density, velocity = (rows[name] for name in ("distance_m", "density_kg_per_m2", "velocity_m_per_s"))
    dense = density.max() / 2
    top = int(np.argmax(density > dense))
    surface = np.interp(dense, density[top - 1:top + 1], place[top - 1:top + 1])
    assert run["surface_distance"] == pytest.approx(surface, rel=1e-9)
    turns = next(k for k in range(top, len(place) - 1) if velocity[k] < 0 <= velocity[k + 1])
    bottom = np.interp(0, velocity[turns:turns + 2], place[turns:turns + 2])
    assert run["surface_layer_bottom"] == pytest.approx(bottom, rel=1e-9)
    assert run["surface_speed"] == pytest.approx(-velocity[top:turns + 1].min(), rel=1e-9)
    layer = (place >= surface + CELL) & (place <= bottom)
    assert np.sum(layer) >= 3, "the case has a layer"
    assert run["surface_shear_rate"] == pytest.approx(np.polyfit(place[layer], velocity[layer], 1)[0], rel=1e-6)


def test_the_occupied_share_counts_cells_with_a_tenth_of_an_even_charge(bed):
    x, y = np.meshgrid(bed.middles, bed.middles, indexing="ij")
    within = bed.density[np.hypot(x, y) < DRUM_RADIUS - 4e-3]
    even = bed.density.sum() / len(within)
    assert run_of("drum")["occupied_share"] == pytest.approx(np.mean(within > 0.1 * even), rel=1e-12)


@pytest.mark.parametrize("replicates", (1, 40))  # many are summed up as they end
def test_the_map_of_a_part_holds_its_hits_and_its_wear(replicates):
    case = mahlwerk.Case({**CASES["blades"], "run": {**CASES["blades"]["run"], "time": "0.05 s",
                                                     "replicates": replicates}})
    result = case.run()
    rows = result.table("part_map")
    pairs = result.table("collisions_by_pair")
    hits = pairs[pairs["other"] == "parts.paddle"]
    assert set(rows["part"]) == {"paddle"}
    assert rows["rate_per_s"].sum() == pytest.approx(hits["collision_rate_per_s"].sum(), rel=EXACT)
    lost = (hits["collision_power_normal_W"] + hits["collision_power_tangential_W"]).sum()
    assert rows["power_lost_W"].sum() == pytest.approx(lost, rel=EXACT)
    worn = (rows["wear_depth_rate_m_per_s"] * rows["area_m2"]).sum() * 7730  # kg/m3
    assert worn == pytest.approx(result["wear_rate_parts"].value, rel=EXACT)
    areas = {side: rows["area_m2"][rows["side"] == side].sum() for side in set(rows["side"])}
    for axis, area in (("x", 4 * 20), ("y", 40 * 20), ("z", 40 * 4)):
        assert areas["minus_" + axis] == pytest.approx(area * 1e-6) == areas["plus_" + axis]
    # It turns anticlockwise: the half with x > 0 pushes with the face to +y, the other with that to -y.
    def pushed(side, sign):
        chosen = rows[(rows["side"] == side) & (sign * rows["along_low_m"] >= 0)]
        return chosen["power_normal_W"].sum()
    assert pushed("plus_y", 1) > 5 * pushed("minus_y", 1)
    assert pushed("minus_y", -1) > 5 * pushed("plus_y", -1)
