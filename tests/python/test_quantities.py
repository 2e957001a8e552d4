# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Every quantity of the register, computed a second time: plainly, over all records of collisions, or from its
definition. A quantity that no record holds names the test that proves it."""
import json
import math
from pathlib import Path

import numpy as np
import pytest

from quantity_proofs import BLADES, BREAKING, DAMPED, DRIVEN, GRAVITY, HOPPER, SLICE, late, packing
from quantity_runs import run_of

TESTS = Path(__file__).resolve().parents[1]
ABOVE = "_above_threshold"


def strong(hits):
    return hits[hits["approach"] >= 0.1]


def everything(hits):
    return hits


def energies(hits):
    m, u, s, g = (hits[name] for name in ("mass", "approach", "slip", "glide"))
    return {"normal": m * u**2 / 2, "contact_point": m * (u**2 + s**2) / 2, "centre": m * (u**2 + g**2) / 2,
            "tangential": m * s**2 / 2, "lost": hits["lost_normal"] + hits["lost_tangential"]}


def angles(hits):
    return np.degrees(np.arctan2(hits["slip"], hits["approach"]))


def lost(hits):
    return energies(hits)["lost"].sum()


def jar_work(hits, run):
    """[J] of the jar's normal impulses: the jar moves along z by 8 mm sin(2 pi 20 Hz t)."""
    w = 2 * math.pi * 20
    of_jar = hits[hits["other"] < 0]
    return float(np.sum(-of_jar["impulse"] * of_jar["normal_z"] * 8e-3 * w * np.cos(w * of_jar["time"])))


def rate(select):
    return lambda run: run.mean(lambda hits: len(select(hits))) / run.time


def mean_energy(kind, select):
    return lambda run: run.mean(lambda hits: energies(select(hits))[kind].mean())


def mean_of(of, select):
    return lambda run: run.mean(lambda hits: of(select(hits)).mean())


def power(of):
    return lambda run: run.mean(lambda hits: of(hits).sum()) / run.time


def dose_rate(run):
    return run["dissipated_power"] / 2  # 2 g of powder


def heard(hits):
    """Energies of the impacts that the microphone tells apart: those within 2 ms of the last one join it."""
    jar = hits[hits["other"] < 0]
    loud = np.sort(jar[energies(jar)["normal"] >= 0.2e-3], order="time")
    groups, last = [], -math.inf
    for time, energy in sorted(zip(loud["time"] + loud["duration"], energies(loud)["normal"])):
        if time - last < 2e-3:
            groups[-1] = max(groups[-1], energy)
        else:
            groups.append(energy)
        last = time
    return np.array(groups)


def wear(hits, jar):
    """[kg] worn off the jar, or off all balls, with k = 2e-4 and a hardness of 600 HV (wea.4, wea.6)."""
    total = 0.0
    for h in hits:
        if jar and h["other"] >= 0:
            continue
        u, t = h["approach"], h["slip"]
        speed = u * u + t * t
        angle = math.atan2(u, t)  # from the surface
        f = math.sin(2 * angle) - 3 * math.sin(angle)**2 if math.tan(angle) <= 1 / 3 else math.cos(angle)**2 / 3
        times = 1 if jar or h["other"] < 0 else 2
        total += times * h["mass"] * speed * f
    return total * 2e-4 / (600 * 9.80665e6) * 7850


def drum(run):
    """Radius that the centre of a ball at the wall has, and the drum's angular velocity."""
    arm = 0.05 - 0.004
    return arm, 0.3 * math.sqrt(GRAVITY / arm)


def collision_quantities():
    proofs = {}
    for suffix, select in (("", everything), (ABOVE, strong)):
        pairs = lambda hits, s=select: s(hits)[s(hits)["other"] >= 0]
        walls = lambda hits, s=select: s(hits)[s(hits)["other"] < 0]
        proofs["collision_rate" + suffix] = rate(select)
        proofs["collision_rate_between_balls" + suffix] = rate(pairs)
        proofs["collision_rate_with_jar" + suffix] = rate(walls)
        for kind in ("normal", "contact_point", "centre", "lost", "tangential"):
            proofs[f"energy_{kind}_mean{suffix}"] = mean_energy(kind, select)
        proofs["impact_speed_normal_mean" + suffix] = mean_of(lambda h: h["approach"], select)
        proofs["impact_speed_tangential_mean" + suffix] = mean_of(lambda h: h["slip"], select)
        proofs["impact_angle_mean" + suffix] = mean_of(angles, select)
        proofs["grazing_share" + suffix] = mean_of(lambda h: angles(h) >= 80, select)
        proofs["impacts_per_ball" + suffix] = lambda run, s=select, p=pairs: run.mean(
            lambda hits: len(s(hits)) + len(p(hits))) / run.time / run.balls
    return proofs


def k(run, share=0.5):
    """[1/s] of the first or the second reaction: each hit processes a share of 2 ug of the 2 g."""
    return rate(everything)(run) * share * 2e-9 / 2e-3


def yields(run):
    """A -> B -> C with the rates of both hits, by the classical solution, in each replicate."""
    made = []
    for hits in run.hits:
        a = len(hits) / run.time * 0.5 * 2e-9 / 2e-3
        b, t = a / 2, 7200
        first, second = math.exp(-a * t), math.exp(-b * t)
        product = a / (b - a) * (first - second)
        made.append([1 - first, product, 1 - first - product])
    return dict(zip(("conversion", "yield", "second_yield"), np.mean(made, axis=0)))


# name: (case, the second computation, relative tolerance)
EXACT = 1e-9
PROOFS = {name: ("flying", of, EXACT) for name, of in {
    **collision_quantities(),
    "collision_rate_in_flight": lambda run: run.mean_from(
        lambda rate, contact: rate / (1 - contact), "collision_rate_above_threshold", "contact_time_share"),
    "dissipated_power": power(lost),
    "dissipated_power_of_collisions": power(lost),
    "dissipated_power_of_lasting_contacts": lambda run: 0,
    "lasting_contacts_rate": lambda run: 0,
    "impact_efficiency": lambda run: run.mean(lambda hits: strong(hits)["lost_normal"].sum() / lost(hits)),
    "tangential_impact_power": power(lambda hits: energies(hits)["tangential"]),
    "power_imbalance": lambda run: run.mean_from(
        lambda drawn, lost: drawn / lost - 1, "drawn_power", "dissipated_power"),
    "drawn_power_of_mill": lambda run: 2 * run["drawn_power"],
    "ball_count": lambda run: 6,
    "balls_mass": lambda run: 6 * 7850e3 * math.pi / 6 * 8e-3**3,
    "specific_energy_dose_rate": dose_rate,
    "specific_energy_dose": lambda run: 7200 * dose_rate(run),
    "specific_energy_dose_per_hour": lambda run: 3600 * dose_rate(run),
    "milling_time": lambda run: 7200,
    "specific_impact_power": lambda run: power(lambda hits: energies(hits)["contact_point"])(run) / 2,
    "stress_energy": mean_energy("contact_point", strong),
    "stress_number_rate": lambda run: rate(strong)(run) / (2e-3 / (4000 * math.pi / 6 * 40e-6**3)),
    "milling_dose": lambda run: 7200 * dose_rate(run),
    "milling_dose_per_mole": lambda run: 7200 * dose_rate(run) * 60 / 1000,
    "processing_hit_rate": rate(everything),
    "processing_hit_energy": lambda run: run.mean(lambda hits: energies(hits)["normal"].mean()),
    "processed_mass_per_hit": lambda run: 0.5 * 2e-9,
    "processed_share_per_hit": lambda run: 0.5 * 2e-9 / 2e-3,
    "processing_rate": k,
    "property": lambda run: 1 + 2 * run["conversion"],
    "motor_power": lambda run: 7 + 2 * run["drawn_power"] / 0.5,
    "heard_hit_rate": lambda run: run.mean(lambda hits: len(heard(hits))) / run.time,
    "heard_hit_energy_mean": lambda run: run.mean(lambda hits: heard(hits).mean()),
    "wear_rate_jar": lambda run: run.mean(lambda hits: wear(hits, True)) / run.time,
    "wear_rate_balls": lambda run: run.mean(lambda hits: wear(hits, False)) / run.time,
    "contamination_rate": lambda run: 3600e9 * (run["wear_rate_balls"] + run["wear_rate_jar"]) / 2,
    "worn_mass": lambda run: 7200 * (run["wear_rate_balls"] + run["wear_rate_jar"]),
    "contamination": lambda run: 2 * run["contamination_rate"],
    "simulated_time": lambda run: run.time,
    "replicates": lambda run: 2,
    "time_to_dose": lambda run: run.mean_from(lambda rate: 5 / (rate / 1000), "specific_energy_dose_rate"),
}.items()}
# A hit processes a share of 5e-7 of the powder: the rates differ by this share from those of many small hits.
PROOFS["processing_rate"] = ("flying", k, 1e-6)
PROOFS.update({name: ("flying", lambda run, n=name: yields(run)[n], 2e-6)
               for name in ("conversion", "yield", "second_yield")})

# A record sums the impulses of the bounces of one contact, over 20 us: 2 pi 20 Hz 20 us of the jar's speed.
PROOFS["heat_share_in_balls"] = ("flying", lambda run: run.mean(
    lambda hits: 0.5 + 0.5 * lost(hits[hits["other"] >= 0]) / lost(hits)), 1e-6)  # (hea.12)
PROOFS["drawn_power"] = ("frictionless", lambda run: run.mean(lambda hits: jar_work(hits, run)) / run.time, 2.5e-3)
PROOFS["contact_time_share"] = ("soft", lambda run: run.mean(lambda hits: hits["duration"].sum()) / run.time, 1e-6)
PROOFS["dissipated_power_normal"] = ("soft", power(lambda hits: hits["lost_normal"]), EXACT)
PROOFS["dissipated_power_tangential"] = ("slippery", power(lambda hits: hits["lost_tangential"]), EXACT)
PROOFS["dissipated_power_sliding"] = ("slippery", power(lambda hits: hits["lost_tangential"]), 0.05)
PROOFS["dissipated_power_rolling"] = ("soft", lambda run: run["dissipated_power"] - run[
    "dissipated_power_normal"] - run["dissipated_power_tangential"], 1e-6)

DRUM = {
    "shaft_torque": lambda run: run["drawn_power"] / drum(run)[1],
    "drum_speed": lambda run: drum(run)[1] * 30 / math.pi,
    "bulk_filling": lambda run: 120 * 8e-3**3 * math.pi / 6 / 0.6 / (math.pi / 4 * 0.1**2 * 0.04),
    "void_filling": lambda run: 2e-3 / 4000 / 0.6 / (0.4 * 120 * 8e-3**3 * math.pi / 6 / 0.6),
    "froude_number": lambda run: drum(run)[1]**2 * drum(run)[0] / GRAVITY,
    "flight_share": lambda run: 1 - run["contact_time_share"],
}
PROOFS.update({name: ("drum", of, EXACT) for name, of in DRUM.items()})
PROOFS.update({name: ("slice", of, EXACT) for name, of in SLICE.items()})
PROOFS["pinning_ratio"] = ("planetary", lambda run: (1 - 2)**2 * (0.02 - 0.004) / 0.07, EXACT)
PROOFS["rotor_torque"] = ("stirred", lambda run: run["drawn_power"] / (300 * math.pi / 30), EXACT)
PROOFS["power_number"] = ("stirred", lambda run: run["drawn_power"] / (7850 * 0.6 * 5**3 * 0.08**5), EXACT)


PROOFS.update({name: ("free", lambda run, v=value: v, EXACT) for name, value in {
    "ball_speed_seen_from_carrier": 0.005, "ball_speed_seen_from_jar": 0.005, "ball_spin": 7}.items()})
PROOFS["charge_height"] = ("free", lambda run: 0.003 + 0.004 * 0.05, 1e-5)


def hertz_overlap(run):
    """Deepest overlap of an elastic sphere on a plane over its radius (Johnson 1985, 11.23): 15 m v^2/(16 E* R^0.5)
    to the power of 2/5."""
    radius, modulus = 4e-3, 1e9 / (2 * (1 - 0.3**2))
    mass = 7850 * 4 / 3 * math.pi * radius**3
    return (15 * mass * 0.25 / (16 * modulus * math.sqrt(radius)))**0.4 / radius


PROOFS["deepest_overlap"] = ("impact", hertz_overlap, 1e-3)  # at the end of the nearest time step


def steady(run, node):
    """Temperatures in the steady state (hea.5). The program's wall consists of facets, 0.04 % smaller."""
    surface = 2 * math.pi / 4 * 0.04**2 + math.pi * 0.04 * 0.04
    jar = 20 + run["dissipated_power"] / (15 * surface)
    return jar if node == "jar" else jar + 0.4 * run["dissipated_power"] / (50 * 6 * math.pi * 8e-3**2)


def final_sizes(run):
    """Edges of the classes and the shares of the mass in them, after milling."""
    table = run.result.table("size_distribution")
    last = np.sort(table[table["time_s"] == table["time_s"].max()], order="size_low_m")
    return last["size_low_m"], last["size_high_m"], last["share"]


def quantile(run, share):
    """The mass of a class is spread evenly in the logarithm of the size (siz.2). The table holds the mean sizes of
    both replicates, the quantity the mean of their quantiles."""
    low, high, shares = final_sizes(run)
    edges = np.concatenate([[low[0]], high])
    return math.exp(np.interp(share, np.concatenate([[0], np.cumsum(shares)]), np.log(edges)))


def flash(hits):
    """[K] Mean flash temperature rise of equal bodies, weighted by the energy lost (hea.7 to hea.10)."""
    e, radius, modulus = energies(hits), np.where(hits["other"] < 0, 4e-3, 2e-3), 1e9 / (2 * (1 - 0.3**2))
    d = (15 * e["normal"] / (8 * modulus * np.sqrt(radius)))**0.4
    duration = np.maximum(2.9433 * d / hits["approach"], hits["duration"])  # at least that of Hertz
    rise = 2 * e["lost"] / (math.pi * radius * d * np.sqrt(math.pi * duration) * 2 * math.sqrt(30 * 7850 * 460))
    return float(np.sum(rise * e["lost"]) / np.sum(e["lost"]))


WARM = {
    # The duration of a soft contact is known to a fiftieth, and stands under a root.
    "flash_rise_mean": (lambda run: run.mean(flash), 0.01),
    "temperature_jar": (lambda run: steady(run, "jar"), 2e-4),
    "temperature_balls": (lambda run: steady(run, "balls"), 2e-4),
    "thermocouple_reading": (lambda run: steady(run, "balls"), 2e-4),
    "captured_mass_rate": (lambda run: rate(everything)(run) * 3e-9, EXACT),
    "captured_share_rate": (lambda run: rate(everything)(run) * 3e-9 / 2e-3, EXACT),
    "captured_grains_mean": (lambda run: 3e-9 / (4000 * math.pi / 6 * 40e-6**3), EXACT),
    "captured_dose_rate": (lambda run: 0.5 * power(lost)(run) / 2, 1e-6),
    "captured_energy_mean": (lambda run: run.mean_from(
        lambda dose, mass: dose * 2 / (mass * 1000), "captured_dose_rate", "captured_mass_rate"), EXACT),
    "specific_grinding_energy": (lambda run: 36000 * run["captured_dose_rate"], EXACT),
    "ignition_time": (lambda run: run.mean_from(lambda rate: 1000 / rate, "specific_energy_dose_rate"), EXACT),
    "d10": (lambda run: quantile(run, 0.1), 5e-3),
    "d50": (lambda run: quantile(run, 0.5), 5e-3),
    "d90": (lambda run: quantile(run, 0.9), 5e-3),
    "specific_surface": (lambda run: sum(6 * share / (4000 * math.sqrt(low * high)) for low, high, share in zip(
        *final_sizes(run))), 5e-3),
    "finest_share": (lambda run: final_sizes(run)[2][0], 1e-6),
}
PROOFS.update({name: ("warm", of, tolerance) for name, (of, tolerance) in WARM.items()})
PROOFS["dissipated_power_liquid"] = ("wet", lambda run: run["dissipated_power"] - run["dissipated_power_normal"]
                                     - run["dissipated_power_tangential"] - run["dissipated_power_rolling"], 1e-6)
GRAINS = 0.1e-3 / (4000 * math.pi / 6 * 2e-3**3)
PROOFS.update({name: ("grains", lambda run, v=value: v, 1e-9) for name, value in {
    "grain_count": round(GRAINS), "coarse_graining_ratio": 4, "particles_per_grain": 64}.items()})
PROOFS.update({name: ("blades", of, tolerance) for name, (of, tolerance) in BLADES.items()})
# Places near the surface that the program leaves out, as its grid is coarser, and random ones.
PROOFS["packing_fraction"] = ("packed", packing, 0.01)
PROOFS["bed_porosity"] = ("packed", lambda run: 1 - late("packing_fraction")(run), 1e-6)
PROOFS.update({name: ("hopper", of, tolerance) for name, (of, tolerance) in HOPPER.items()})
PROOFS.update({name: ("breaking", of, tolerance) for name, (of, tolerance) in BREAKING.items()})
PROOFS.update({name: ("damped", of, tolerance) for name, (of, tolerance) in DAMPED.items()})
PROOFS.update({name: ("driven", of, tolerance) for name, (of, tolerance) in DRIVEN.items()})

# The tables of the sensors hold the readings of the first replicate.
READINGS = {
    "motor_power_scatter": (lambda run: run.result.table("power_meter")["motor_power_W"].std(ddof=1), EXACT),
    "acceleration_rms": (lambda run: np.sqrt(np.mean(
        run.result.table("accelerometer")["acceleration_m_per_s2"]**2)), 0.02),
    "acceleration_rms_of_impacts": (lambda run: np.sqrt(np.mean(
        run.result.table("accelerometer")["of_impacts_m_per_s2"]**2)), 0.02),
    "acceleration_peak": (lambda run: np.abs(run.result.table("accelerometer")["acceleration_m_per_s2"]).max(), 0.05),
}

# What no record of a collision holds: closed forms of charges and balances made by hand.
ELSEWHERE = {
    "unit/results/summary_test.cpp": ["tc_collision_share", "power_share_within_contact_time",
                                      "hit_share_within_contact_time", "withheld_power_share", "energy_residual",
                                      "energy_balance"],
    "unit/results/regime_test.cpp": ["airborne_share", "toe_angle", "shoulder_angle", "emptiest_sector",
                                     "wall_slip_ratio", "jar_lag", "intermittency"],
    "unit/results/motion_test.cpp": ["occupied_share"],
    "unit/results/motion_states_test.cpp": ["circling_share", "bouncing_share", "pinned_share", "stationary_share",
                                            "state_changes", "turns_per_cycle", "axial_ratio"],
    "unit/results/bed_test.cpp": ["charge_rise", "bed_angle", "charge_distance", "charge_lever_arm",
                                  "surface_distance", "surface_layer_bottom", "surface_speed", "surface_shear_rate"],
    "unit/results/series_test.cpp": ["settling_time"],
    "unit/results/bodies_test.cpp": ["face_hit_share", "edge_hit_share", "corner_hit_share", "side_hit_share",
                                     "cap_hit_share", "face_energy_share", "edge_energy_share",
                                     "corner_energy_share", "side_energy_share", "cap_energy_share",
                                     "nematic_order", "body_axis_angle"],
}


def test_every_quantity_of_the_register_is_proven(program):
    register = {one["name"] for one in json.loads(program("list", "quantities", "--json")[1])}
    elsewhere = {name for names in ELSEWHERE.values() for name in names}
    proven = set(PROOFS) | set(READINGS) | elsewhere
    assert not register - proven, f"{sorted(register - proven)}: prove by records in PROOFS, or name its unit test in ELSEWHERE"
    assert not proven - register, f"{sorted(proven - register)}: there is no such quantity; remove its proof"
    for file, names in ELSEWHERE.items():
        text = (TESTS / file).read_text()
        for name in names:
            assert f'"{name}"' in text, f"{name} is in no statement of {file}"


@pytest.mark.parametrize("name", sorted(READINGS))
def test_is_what_the_readings_say(name):
    of, tolerance = READINGS[name]  # the signal has ten samples for one of the table
    run = run_of("warm")
    assert run.by_replicate(name)[0] == pytest.approx(of(run), rel=tolerance)


@pytest.mark.parametrize("name", sorted(PROOFS))
def test_is_what_its_records_say(name):
    case, of, tolerance = PROOFS[name]
    run = run_of(case)
    expected, found = of(run), run[name]
    assert found == pytest.approx(expected, rel=tolerance, abs=1e-12), f"{name} of the case {case}"
