# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The tables of collisions, computed a second time from the records: plainly, by numpy, as docs/formats.md defines
their columns. A difference of 1e-9 is the rounding of sums in another order."""
import math

import numpy as np
import pytest

from quantity_runs import CASES, run_of
from test_quantities import angles, energies, strong

EXACT = 1e-9
# Student's t for 95 % with 1, 2, ... degrees of freedom; any textbook has them.
STUDENT = {1: 12.706204736432095, 2: 4.302652729911275, 9: 2.2621571628540993}
RUNS = sorted(CASES)


def is_same(found, expected, what, rel=EXACT, least=1e-15):
    """Whether two columns are the same."""
    expected = np.broadcast_to(np.asarray(expected, float), np.shape(found))
    assert found == pytest.approx(expected, rel=rel, abs=least, nan_ok=True), what


def rates(run, of, weights=None):
    """Mean over replicates of what a function of the records counts, per second."""
    return np.mean([of(hits) for hits in run.hits], axis=0) / run.time


def binned(values, edges, weights=None):
    """Counts (or sums of the weights) in bins whose lower edge belongs to them. The first one holds all below it."""
    where = np.searchsorted(edges, values, side="right") - 1
    made = np.zeros(len(edges) - 1)
    np.add.at(made, np.maximum(where, 0), 1 if weights is None else weights)
    return made


def quarters(low, high):
    """Whether edges are neighbouring powers 2^(k/4) (obs.2)."""
    k = 4 * np.log2(high)
    return np.allclose(k, np.round(k), atol=1e-9) and np.allclose(low[1:], high[:-1], rtol=1e-14) and (
        low[0] == 0 or math.isclose(high[0] / low[0], 2**0.25, rel_tol=1e-12))


def kinds_of_energy(hits):
    """By the names of the columns of spectrum.csv."""
    e = energies(hits)
    return {"normal": e["normal"], "contact_point": e["contact_point"], "centre": e["centre"], "lost": e["lost"],
            "lost_normal": hits["lost_normal"], "lost_tangential": hits["lost_tangential"]}


# Spectra.

@pytest.mark.parametrize("name", ["flying", "soft", "mixed"])
def test_the_spectrum_counts_and_sums_the_energies_of_the_records(name):
    run = run_of(name)
    table = run.result.table("spectrum")
    low, high = table["energy_low_J"], table["energy_high_J"]
    assert quarters(low, high)
    edges = np.concatenate([low, high[-1:]])
    for kind in ("normal", "contact_point", "centre", "lost", "lost_normal", "lost_tangential"):
        is_same(table[f"rate_{kind}_per_s"], rates(run, lambda h: binned(kinds_of_energy(h)[kind], edges)), kind)
        is_same(table[f"power_{kind}_W"],
                rates(run, lambda h: binned(kinds_of_energy(h)[kind], edges, kinds_of_energy(h)[kind])), kind)
    filled = sum(table[f"rate_{kind}_per_s"] for kind in kinds_of_energy(run.hits[0]))
    assert filled[0] > 0 and filled[-1] > 0, "the table begins and ends with collisions"


HISTOGRAMS = {"speeds": ("speed", "m_per_s", lambda h: h["approach"]), "durations": ("duration", "s", lambda h: h["duration"])}


@pytest.mark.parametrize("table", HISTOGRAMS)
@pytest.mark.parametrize("name", ["soft", "mixed"])
def test_a_histogram_counts_the_records(table, name):
    run = run_of(name)
    if table not in run.result.tables:
        pytest.skip("no contact of this engine lasts")
    column, unit, of = HISTOGRAMS[table]
    rows = run.result.table(table)
    low, high = rows[f"{column}_low_{unit}"], rows[f"{column}_high_{unit}"]
    assert quarters(low, high)
    is_same(rows["rate_per_s"], rates(run, lambda h: binned(of(h), np.concatenate([low, high[-1:]]))), table)
    assert rows["rate_per_s"][0] > 0 and rows["rate_per_s"][-1] > 0


def test_flash_temperatures_are_those_of_the_records():
    run = run_of("warm")
    rows = run.result.table("flashes")
    low, high = rows["rise_low_K"], rows["rise_high_K"]
    assert quarters(low, high)
    found = rates(run, lambda h: binned(rises(h), np.concatenate([low, high[-1:]])))
    # Rises within the accuracy of a duration (a fiftieth, under a root) may be in the next bin: 4 log2 1.01 of them.
    assert np.abs(rows["rate_per_s"] - found).sum() <= 2 * 4 * math.log2(1.01) * found.sum()


def rises(hits):
    """[K] Flash temperature rise of equal bodies (hea.7 to hea.11)."""
    e, radius, modulus = energies(hits), np.where(hits["other"] < 0, 4e-3, 2e-3), 1e9 / (2 * (1 - 0.3**2))
    d = (15 * e["normal"] / (8 * modulus * np.sqrt(radius)))**0.4
    duration = np.maximum(2.9433 * d / hits["approach"], hits["duration"])
    return 2 * e["lost"] / (math.pi * radius * d * np.sqrt(math.pi * duration) * 2 * math.sqrt(30 * 7850 * 460))


@pytest.mark.parametrize("name", ["flying", "soft"])
def test_angles_are_counted_by_degree(name):
    run = run_of(name)
    rows = run.result.table("angles")
    assert list(rows["angle_low_deg"]) == list(range(90)) and list(rows["angle_high_deg"]) == list(range(1, 91))
    count = lambda hits: np.bincount(np.minimum(angles(hits).astype(int), 89), minlength=90)
    is_same(rows["rate_per_s"], rates(run, count), "all")
    is_same(rows["rate_above_threshold_per_s"], rates(run, lambda hits: count(strong(hits))), "above")


@pytest.mark.parametrize("name", ["flying", "soft"])
def test_the_joint_spectrum_counts_normal_and_tangential_energies(name):
    run = run_of(name)
    rows = run.result.table("normal_tangential")
    octave = lambda e: np.floor(np.log2(np.maximum(e, 2.0**-56)))
    found = {}
    for hits in run.hits:
        for key in zip(octave(energies(hits)["normal"]), octave(energies(hits)["tangential"])):
            found[key] = found.get(key, 0) + 1 / run.time / len(run.hits)
    expected = {(math.log2(row["energy_normal_low_J"]) if row["energy_normal_low_J"] else -56,
                 math.log2(row["energy_tangential_low_J"]) if row["energy_tangential_low_J"] else -56):
                row["rate_per_s"] for row in rows}
    assert expected == pytest.approx(found, rel=EXACT)
    for row in rows:
        for kind in ("normal", "tangential"):
            assert row[f"energy_{kind}_high_J"] == 2 * row[f"energy_{kind}_low_J"] or row[f"energy_{kind}_low_J"] == 0


# By pair. The balls of the case "mixed": 4 of the first set, 5 of the second.

def partner(hits, faces):
    """Names of both sets, or of the set and of the jar (or of its face)."""
    set_of = lambda ball: np.where(ball < 4, "balls.1", "balls.2")
    face = np.array(["side", "bottom", "top"])[np.maximum(-1 - hits["other"], 0)]
    jar = np.char.add("jar.", face) if faces else np.full(len(hits), "jar")
    return set_of(hits["ball"]), np.where(hits["other"] < 0, jar, set_of(hits["other"]))


def of_pair(hits, one, other, faces):
    ones, others = partner(hits, faces)
    return hits[(ones == one) & (others == other)]


def test_spectra_by_pair_are_those_of_its_records():
    run = run_of("mixed")
    rows = run.result.table("spectra_by_pair")
    pairs = {(row["one"], row["other"]) for row in rows}
    assert ("balls.1", "jar.side") in pairs and ("balls.1", "balls.2") in pairs
    for one, other in pairs:
        those = rows[(rows["one"] == one) & (rows["other"] == other)]
        for kind in ("normal", "contact_point", "centre", "lost", "lost_normal", "lost_tangential"):
            whole = rates(run, lambda h: kinds_of_energy(of_pair(h, one, other, True))[kind].sum())
            assert those[f"power_{kind}_W"].sum() == pytest.approx(whole, rel=EXACT, abs=1e-15), (one, other, kind)
            for row in those:
                inside = lambda h: np.sum(
                    (kinds_of_energy(of_pair(h, one, other, True))[kind] >= row["energy_low_J"])
                    & (kinds_of_energy(of_pair(h, one, other, True))[kind] < row["energy_high_J"]))
                if row["energy_low_J"] > 0:
                    assert row[f"rate_{kind}_per_s"] == pytest.approx(rates(run, inside), rel=EXACT)
    count = rates(run, len)
    assert rows["rate_normal_per_s"].sum() == pytest.approx(count, rel=EXACT)
    filled = [name for name in rows.dtype.names if name.startswith("rate_")]
    assert all(any(row[name] > 0 for name in filled) for row in rows), "rows without collisions are left out"


def test_the_only_face_of_a_jar_is_the_jar():
    run = run_of("sphere")
    assert set(run.result.table("spectra_by_pair")["other"]) == {"balls.1", "balls.2", "jar"}
    assert list(run.result.table("wear")["body"]) == ["balls.1", "balls.2", "jar"]


def test_collisions_by_pair_are_those_of_its_records():
    run = run_of("mixed")
    rows = run.result.table("collisions_by_pair")
    assert [(row["one"], row["other"]) for row in rows] == [
        ("balls.1", "balls.1"), ("balls.1", "balls.2"), ("balls.1", "jar"), ("balls.2", "balls.2"), ("balls.2", "jar")]
    for row in rows:
        for suffix, select in (("", lambda h: h), ("_above_threshold", strong)):
            own = [select(of_pair(h, row["one"], row["other"], False)) for h in run.hits]
            expect = {f"collision_rate{suffix}_per_s": [len(h) / run.time for h in own]}
            for kind in ("normal", "contact_point"):
                expect[f"energy_{kind}_mean{suffix}_J"] = [energies(h)[kind].mean() for h in own]
            if not suffix:
                for kind in ("normal", "tangential"):
                    expect[f"collision_power_{kind}_W"] = [h[f"lost_{kind}"].sum() / run.time for h in own]
            for name, values in expect.items():
                values = np.array(values)
                assert row[name] == pytest.approx(values.mean(), rel=1e-9), name
                head = name.rsplit("_per_s", 1)[0] if name.endswith("_per_s") else name[:-2]
                half = f"{head}_ci95_per_s" if name.endswith("_per_s") else f"{head}_ci95_{name[-1]}"
                assert row[half] == pytest.approx(
                    STUDENT[len(values) - 1] * values.std(ddof=1) / math.sqrt(len(values)), rel=1e-7), half


def test_sizes_are_those_of_the_case():
    rows = run_of("mixed").result.table("sizes")
    balls = run_of("mixed").result.table("final-1")
    sizes, counts = np.unique(balls["radius_m"][balls["kind"] == 2], return_counts=True)
    assert list(counts.cumsum())[-1] == 5 and len(sizes) == 2
    assert [(row["set"], row["diameter_m"], row["count"]) for row in rows] == [
        ("balls.1", 8e-3, 4), *(("balls.2", 2 * size, count) for size, count in zip(sizes, counts))]
    cubes = counts * sizes**3
    is_same(rows["mass_share"], [1, *(cubes / cubes.sum())], "share of the mass of its set")


def test_contact_times_are_those_of_the_contacts():
    run = run_of("soft")  # one ball: a contact in two windows counts in both
    rows = run.result.table("timeseries")
    share = rates(run, lambda h: h["duration"].sum())
    assert rows["contact_time_share"].mean() == pytest.approx(share, rel=1e-6)
    edges = np.linspace(run.begin, run.begin + run.time, 201)
    inside = lambda h: sum(np.clip(np.minimum(h["time"][:, None] + h["duration"][:, None], edges[1:]) - np.maximum(
        h["time"][:, None], edges[:-1]), 0, None))
    found = np.mean([inside(h) for h in run.hits], axis=0) / (run.time / 200)
    assert np.abs(rows["contact_time_share"] - found).max() < 0.01


def test_work_less_losses_is_the_change_of_the_kinetic_energy():
    run = run_of("weightless")
    rows = run.result.table("timeseries")
    length = run.time / 200
    change = (rows["drawn_power_W"] - rows["dissipated_power_W"]) * length
    found = np.diff(rows["kinetic_energy_J"])
    assert found == pytest.approx(change[1:], abs=1e-9 * rows["kinetic_energy_J"].max())
    final = [run.result.table(f"final-{i}") for i in (1, 2)]
    mass = 7850 * math.pi / 6 * 8e-3**3
    w = 2 * math.pi * 20
    jar = 8e-3 * w * math.cos(w * (run.begin + run.time))  # the jar's velocity along z at the end
    energy = []
    for balls in final:
        speed = balls["velocity_x_m_per_s"]**2 + balls["velocity_y_m_per_s"]**2 + (balls["velocity_z_m_per_s"] + jar)**2
        spin = sum(balls[f"spin_{axis}_rad_per_s"]**2 for axis in "xyz")
        energy.append(np.sum(mass * speed / 2 + 0.4 * mass * 4e-3**2 * spin / 2))
    assert rows["kinetic_energy_J"][-1] == pytest.approx(np.mean(energy), rel=1e-9)


def test_each_replicate_has_its_own_row():
    run = run_of("flying")
    rows = run.result.table("replicates")
    assert list(rows["replicate"]) == [1, 2] and list(rows["complete"]) == [1, 1]
    is_same(rows["collision_rate_per_s"], [len(h) / run.time for h in run.hits], "rate")
    is_same(rows["energy_centre_mean_J"], [energies(h)["centre"].mean() for h in run.hits], "energy")
    is_same(rows["impact_angle_mean_deg"], [angles(h).mean() for h in run.hits], "angle", rel=1e-6)
