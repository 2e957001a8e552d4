# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The tables of the powder, computed a second time: from the records and the equations of docs/theory."""
import math

import numpy as np
import pytest

from quantity_runs import run_of
from test_heat_and_sensors import exponential
from test_quantities import energies, strong
from test_tables import EXACT, is_same, rates

# Captured powder: grains of 0.3 mm in a layer of 50 um, of which 0.6 is solid.

SOLID, LAYER, GRAIN, POWDER, SHARE = 0.6 * 4000, 50e-6, 0.3e-3, 2e-3, 0.8
MODULUS = 1e9 / (2 * (1 - 0.3**2))
RADII = {"balls.1": 2e-3, "jar.bottom": 4e-3, "jar.top": 4e-3,
         "jar.side": 1 / math.sqrt(1 / 4e-3 * (1 / 4e-3 - 1 / 20e-3))}  # (cap.3)


FACES_OF_BOX = {"left": ("x", -1), "right": ("x", 1), "front": ("y", -1), "back": ("y", 1), "bottom": ("z", -1),
                "top": ("z", 1)}  # axis and sign of the normal from a ball to the face


def grain_mass(size):
    return 4000 * math.pi / 6 * size**3


def captured(partner, energy):
    """Contact radius (cap.1) and captured mass (cap.10)."""
    radius = (15 * energy / (8 * MODULUS))**0.2 * np.array([RADII[one] for one in partner])**0.4
    return radius, SOLID * math.pi * radius**2 * LAYER


def test_capture_is_what_the_contact_area_holds():
    run = run_of("ground")
    rows = run.result.table("capture")
    assert set(rows["other"]) == set(RADII) and set(rows["one"]) == {"balls.1"}
    radius, mass = captured(rows["other"], rows["energy_J"])
    grains = mass / grain_mass(GRAIN)
    is_same(rows["radius_m"], radius, "radius", rel=1e-6)
    is_same(rows["mass_kg"], mass, "mass", rel=1e-6)
    is_same(rows["grains"], grains, "grains", rel=1e-6)
    assert min(grains) < 1 < max(grains), "the case has both kinds of hits"
    each = SHARE * rows["energy_J"] / np.maximum(1, grains)
    is_same(rows["energy_per_grain_J"], each, "energy of a grain", rel=1e-6)
    is_same(rows["specific_energy_J_per_kg"], each / grain_mass(GRAIN), "by mass", rel=1e-6)


def test_captures_are_those_of_the_collisions():
    run = run_of("ground")
    rows = run.result.table("capture")
    assert rows["rate_per_s"].sum() == pytest.approx(rates(run, len), rel=EXACT)
    power = rates(run, lambda h: energies(h)["normal"].sum())
    assert (rows["rate_per_s"] * rows["energy_J"]).sum() == pytest.approx(power, rel=EXACT)
    faces = {"balls.1": lambda h: h["other"] >= 0, "jar.side": lambda h: h["other"] == -1,
             "jar.bottom": lambda h: h["other"] == -2, "jar.top": lambda h: h["other"] == -3}
    for partner, of in faces.items():
        those = rows[rows["other"] == partner]
        assert those["rate_per_s"].sum() == pytest.approx(rates(run, lambda h: of(h).sum()), rel=EXACT)
        # One row for each quarter of an octave, at the mean energy of its collisions.
        k = np.floor(4 * np.log2(those["energy_J"]))
        assert len(set(k)) == len(k)
        for row, low in zip(those, k):
            inside = lambda h: energies(h)["normal"][of(h) & (np.floor(4 * np.log2(energies(h)["normal"])) == low)]
            assert row["rate_per_s"] == pytest.approx(rates(run, lambda h: len(inside(h))), rel=EXACT)
            assert row["energy_J"] == pytest.approx(np.mean(np.concatenate([inside(h) for h in run.hits])), rel=EXACT)


def test_capture_rates_are_the_sums_of_their_table():
    run = run_of("ground")
    rows = run.result.table("capture")
    grains = np.maximum(1, rows["mass_kg"] / grain_mass(GRAIN))
    chance = np.minimum(1, rows["mass_kg"] / grain_mass(GRAIN))
    mass = (rows["rate_per_s"] * rows["mass_kg"]).sum()
    power = SHARE * (rows["rate_per_s"] * chance * rows["energy_J"]).sum()
    of_energy = rows["rate_per_s"] * rows["energy_J"]
    for name, value in {"captured_mass_rate": mass, "captured_share_rate": mass / POWDER,
                        "captured_dose_rate": power / POWDER / 1000, "captured_energy_mean": power / mass / 1000,
                        "captured_grains_mean": (of_energy * chance * grains).sum() / of_energy.sum(),
                        "specific_grinding_energy": 1200 * power / POWDER / 1000,
                        "milling_dose": 1200 * power / POWDER / 1000,
                        "milling_dose_per_mole": 1200 * power / POWDER * 0.06 / 1000}.items():
        assert run[name] == pytest.approx(value, rel=1e-6), name


def test_captured_grains_are_binned_by_their_number():
    run = run_of("ground")
    rows, table = run.result.table("capture"), run.result.table("captured_grains")
    chance = np.minimum(1, rows["grains"])
    grains = np.maximum(1, rows["mass_kg"] / grain_mass(GRAIN))
    bins = np.where(grains > 1, 1 + np.floor(4 * np.log2(grains)), 0)
    is_same(table["grains_low"], [1 if b == 0 else 2**((b - 1) / 4) for b in sorted(set(bins))], "lower edge")
    is_same(table["grains_high"], [1 if b == 0 else 2**(b / 4) for b in sorted(set(bins))], "upper edge")
    assert 0 in bins and len(table) > 3, "the case has single grains and many"
    for row, b in zip(table, sorted(set(bins))):
        inside = bins == b
        assert row["rate_per_s"] == pytest.approx((rows["rate_per_s"] * chance)[inside].sum(), rel=EXACT)
        assert row["power_W"] == pytest.approx((rows["rate_per_s"] * chance * rows["energy_J"])[inside].sum(), rel=EXACT)


def test_a_coating_is_captured_by_the_contact_area():
    """(cap.11), by the energy of the contact points, in a box: the effective radius is that of the ball on a plane."""
    run = run_of("coated")
    rows = run.result.table("capture")
    assert set(rows["other"]) == {"balls.1", *(f"jar.{face}" for face in FACES_OF_BOX)}
    radius = np.where(rows["other"] == "balls.1", 2e-3, 4e-3)
    spot = (15 * rows["energy_J"] / (8 * MODULUS))**0.2 * radius**0.4
    is_same(rows["radius_m"], spot, "radius", rel=1e-6)
    is_same(rows["mass_kg"], 2 * 0.1 * math.pi * spot**2, "mass", rel=1e-6)
    power = rates(run, lambda h: energies(h)["contact_point"].sum())
    assert (rows["rate_per_s"] * rows["energy_J"]).sum() == pytest.approx(power, rel=EXACT)
    for face, (axis, sign) in FACES_OF_BOX.items():
        count = rates(run, lambda h: np.sum((h["other"] < 0) & (h[f"normal_{axis}"] * sign > 0.5)))
        assert rows["rate_per_s"][rows["other"] == f"jar.{face}"].sum() == pytest.approx(count, rel=EXACT)
    for table in ("grinding", "size_distribution", "conversion"):
        assert table not in run.result.tables
    assert not {"no-ignition", "no-hit-above-threshold"} & {notice.code for notice in run.result.notices}


# Sizes: a hit breaks a grain into halves, with the probability of (brk.1).

class Balance:
    """The population balance (pbm.1, pbm.2) on the classes of the table, from coarse to fine."""

    def __init__(self, run):
        table = run.result.table("size_distribution")
        first = np.sort(table[table["time_s"] == 0], order="size_low_m")[::-1]
        self.low, self.high, self.start = first["size_low_m"], first["size_high_m"], first["share"]
        self.middle = np.sqrt(self.low * self.high)
        hits = run.result.table("capture")
        _, mass = captured(hits["other"], hits["energy_J"])
        rate = []
        for size in self.middle:
            grain = grain_mass(size)
            work = SHARE * hits["energy_J"] / (np.maximum(1, mass / grain) * grain)
            chance = 1 - np.exp(-0.1 * np.maximum(0, size * work - 0.01))
            rate.append((hits["rate_per_s"] * mass / POWDER * chance).sum())
        rate[-1] = 0  # the finest class does not break
        n = len(rate)
        self.matrix = -np.diag(rate)
        for i in range(n):
            self.matrix[min(i + 2, n - 1), i] += rate[i]  # a third of an octave finer: two classes

    def shares(self, time):
        return exponential(self.matrix * time) @ self.start

    def quantile(self, shares, part):
        """(siz.2)"""
        edges = np.log(np.append(self.low[::-1], self.high[0]))
        return math.exp(np.interp(part, np.append(0, np.cumsum(shares[::-1])), edges))

    def surface(self, shares):
        return np.sum(6 * shares / (4000 * self.middle))  # (siz.3)


@pytest.fixture(scope="module")
def balance():
    return Balance(run_of("ground"))


def test_the_feed_is_one_class_of_a_sixth_of_an_octave(balance):
    is_same(balance.high / balance.low, 2**(1 / 6), "width", rel=1e-12)
    is_same(balance.high[1:], balance.low[:-1], "neighbours", rel=1e-12)
    assert balance.start.max() == 1 and balance.middle[balance.start.argmax()] == pytest.approx(GRAIN, rel=1e-12)
    assert balance.low[-1] <= 20e-6 <= balance.high[-1] * 2**(1 / 6)


def test_a_feed_of_many_sizes_is_in_the_classes_that_its_distribution_says():
    table = run_of("spread").result.table("size_distribution")
    start = table[table["time_s"] == 0]
    low, high = start["size_low_m"], start["size_high_m"]
    is_same(high / low, 2**(1 / 3), "classes of a third of an octave", rel=1e-12)
    middle = np.sqrt(low * high)
    assert np.abs(middle / 40e-6 - 1).min() < 1e-12, "the median is in the middle of a class"
    normal = np.array([math.erf(math.log(x / 40e-6) / math.log(1.5) / math.sqrt(2)) for x in high]) / 2 + 0.5
    assert start["passing"] == pytest.approx(normal, abs=2e-6)  # the ends hold the rest, a millionth each
    largest = 16 * 40e-6 * 1.5**4.753424308822899  # room for grains that weld, above the 1 - 1e-6 quantile
    assert high[-2] < largest <= high[-1] and low[0] <= 4e-6 < high[0]


def test_the_size_distribution_solves_the_balance(balance):
    table = run_of("ground").result.table("size_distribution")
    times = 1200 * np.array([0, 1 / 16, 1 / 8, 1 / 4, 1 / 2, 1])
    assert list(np.unique(table["time_s"])) == pytest.approx(list(times))
    for time in times:
        rows = table[np.isclose(table["time_s"], time)]
        assert list(rows["size_low_m"]) == sorted(rows["size_low_m"]), "from fine to coarse"
        shares = balance.shares(time)[::-1]
        is_same(rows["share"], shares, "share", rel=1e-6, least=1e-12)
        is_same(rows["passing"], np.cumsum(shares), "passing", rel=1e-6, least=1e-12)
        is_same(rows["density"], shares / (math.log(2) / 6), "density", rel=1e-6, least=1e-12)


def test_sizes_over_time_are_those_of_the_balance(balance):
    run = run_of("ground")
    rows = run.result.table("grinding")
    first = 1200 / 2**12
    times = [*(first * np.arange(17) / 16), *(first * 2.0**k * (1 + i / 16) for k in range(12) for i in range(1, 17))]
    is_same(rows["time_s"], times, "output times")
    is_same(rows["specific_energy_J_per_g"], run["captured_dose_rate"] * rows["time_s"], "energy")
    for row in rows[[0, 1, 100, 150, 190, 208]]:
        shares = balance.shares(row["time_s"])
        for name, part in (("d10_m", 0.1), ("d50_m", 0.5), ("d90_m", 0.9)):
            assert row[name] == pytest.approx(balance.quantile(shares, part), rel=1e-5), name
        assert row["specific_surface_m2_per_kg"] == pytest.approx(balance.surface(shares), rel=1e-6)
    shares = balance.shares(1200)
    for name, value in {"d10": balance.quantile(shares, 0.1), "d50": balance.quantile(shares, 0.5),
                        "d90": balance.quantile(shares, 0.9), "specific_surface": balance.surface(shares),
                        "finest_share": shares[-1]}.items():
        assert run[name] == pytest.approx(value, rel=1e-5), name


def test_a_sample_agrees_with_the_balance_and_with_itself(balance):
    run = run_of("ground")
    table, rows = run.result.table("size_distribution"), run.result.table("grinding")
    for time in np.unique(table["time_s"]):
        those = table[table["time_s"] == time]
        # 10 000 grains; four standard deviations of a share of a half
        assert np.abs(those["sample_passing"] - those["passing"]).max() <= 4 * 0.5 / math.sqrt(10000)
        is_same(those["sample_passing"], np.cumsum(those["sample_share"]), "passing")
        is_same(those["sample_density"], those["sample_share"] / (math.log(2) / 6), "density")
        row = rows[np.isclose(rows["time_s"], time)][0]
        shares = those["sample_share"][::-1]
        for name, part in (("d10", 0.1), ("d50", 0.5), ("d90", 0.9)):
            assert row[f"sample_{name}_m"] == pytest.approx(balance.quantile(shares, part), rel=1e-9), name
        assert row["sample_specific_surface_m2_per_kg"] == pytest.approx(balance.surface(shares), rel=1e-9)
    assert np.abs(table["sample_share"] - table["share"]).max() > 0, "the sample is another method"


# Conversion.

def test_conversion_follows_the_dose_of_captured_powder():
    run = run_of("ground")
    rows = run.result.table("conversion")
    is_same(rows["time_s"], np.linspace(0, 1200, 201), "milling time")
    dose = run["captured_dose_rate"] * rows["time_s"]
    is_same(rows["dose_J_per_g"], dose, "dose")
    assert dose[-1] > 2, "the onset is passed"
    is_same(rows["conversion"], 1 - np.exp(-(np.maximum(0, dose - 2) / 10)**1.5), "(dos.1)", rel=1e-9, least=1e-15)
    assert run["conversion"] == pytest.approx(rows["conversion"][-1], rel=EXACT)


def test_conversion_by_impact_follows_the_hits():
    run = run_of("flying")
    rows = run.result.table("conversion")
    is_same(rows["time_s"], np.linspace(0, 7200, 201), "milling time")
    is_same(rows["dose_J_per_g"], run["specific_energy_dose_rate"] * rows["time_s"], "dose")
    a = np.array([[len(hits) / run.time * 0.5 * 2e-9 / 2e-3] for hits in run.hits])
    first, second = np.exp(-a * rows["time_s"]), np.exp(-a / 2 * rows["time_s"])
    product = 2 * (second - first)  # a sequence whose second rate is half of the first (rea.5)
    # One hit processes a share of 5e-7 of the powder: rates differ by this share from those of many small hits.
    for name, value in {"conversion": 1 - first, "yield": product, "second_yield": 1 - first - product,
                        "property": 1 + 2 * (1 - first)}.items():
        is_same(rows[name], value.mean(axis=0), name, rel=2e-6, least=1e-12)


def test_a_reaction_by_impact_attempts_with_the_hits_above_the_threshold():
    run = run_of("reacting")
    rows = run.result.table("conversion")
    assert np.all(rows["temperature_K"] == 350)
    rate = np.array([[100 * len(strong(hits)) / run.time] for hits in run.hits]) * math.exp(
        -60e3 / (8.31446261815324 * 350))  # (rea.6)
    is_same(rows["conversion"], np.mean(1 - np.exp(-rate * rows["time_s"]), axis=0), "(rea.7)", rel=1e-9, least=1e-12)
