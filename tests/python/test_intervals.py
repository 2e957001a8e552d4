# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Intervals over replicates and over time, and the time series, computed a second time from the records."""
import math

import numpy as np
import pytest

from quantity_runs import run_of
from test_quantities import energies
from test_tables import RUNS, STUDENT, binned, is_same

WORST = ("energy_residual", "energy_balance", "deepest_overlap", "grain_count", "coarse_graining_ratio",
         "particles_per_grain")
OF_ALL = ("settling_time", "replicates")


@pytest.mark.parametrize("name", RUNS)
def test_a_quantity_is_the_mean_of_its_replicates_with_students_interval(name):
    run = run_of(name)
    for quantity in set(run.result.quantities) - set(OF_ALL):
        values = run.by_replicate(quantity)
        shown = run.result.summary[quantity]
        found = [np.nan if shown[key] is None else shown[key] for key in ("value", "ci95")]
        there = values[np.isfinite(values)]
        n = len(there)
        expected = [there.mean() if n > 0 else np.nan, np.nan]
        if quantity in WORST:
            expected[0] = values.max()
        elif n > 1:
            expected[1] = STUDENT[n - 1] * there.std(ddof=1) / math.sqrt(n)
        is_same(np.array(found, float), expected, quantity, rel=1e-7, least=1e-13 * abs(expected[0]) if n > 0 else 0)


def batches(values, size):
    return values[:len(values) // size * size].reshape(-1, size).mean(axis=1)


def lag_one(values):
    off = values - values.mean()
    return np.sum(off[1:] * off[:-1]) / np.sum(off**2) + 1 / len(values) if np.sum(off**2) > 0 else 0


def half_width_over_time(values, student):
    """(sta.3), (sta.4). `student`: t for 95 % by the degrees of freedom."""
    while lag_one(values) * math.sqrt(len(values)) >= 1 and len(values) // 2 >= 10:
        values = batches(values, 2)
    r, m = min(max(lag_one(values), 0), 0.9), len(values)
    return math.sqrt((1 + r) / (1 - r)) * student(m - 1) * values.std(ddof=1) / math.sqrt(m)


def student(freedom):
    """t for 95 % by Newton's method on its distribution, integrated by Simpson's rule in the angle atan(t/sqrt(n))."""
    def within(t):
        angle = np.linspace(0, math.atan(t / math.sqrt(freedom)), 2001)
        density = np.cos(angle)**(freedom - 1)
        simpson = (density[0] + 4 * density[1:-1:2].sum() + 2 * density[2:-1:2].sum() + density[-1]) * angle[1] / 3
        whole = math.sqrt(math.pi) * math.gamma(freedom / 2) / math.gamma((freedom + 1) / 2) / 2
        return simpson / whole
    low, high = 1.9, 13.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if within(middle) < 0.95 else (low, middle)
    return low


def joining_time():
    """[s] After so long no bounce belongs to a contact (man.9), and the event engine tells of it: twice the duration of
    an elastic impact on the wall at 1 mm/s."""
    energy, radius, modulus = 7850 * math.pi / 6 * 8e-3**3 * 1e-3**2 / 2, 4e-3, 1e9 / (2 * (1 - 0.3**2))
    return 2 * 2.9432750 * (15 * energy / (8 * modulus * math.sqrt(radius)))**0.4 / 1e-3


def windows(run, hits, weights):
    """Sums of a replicate in the 200 windows of its counted time, by the time at which its record is complete."""
    end = hits["time"] + hits["duration"] + joining_time() - run.begin
    edges = np.linspace(0, run.time, 201)
    return binned(end, edges, weights)


def test_the_interval_over_time_is_that_of_batches_of_windows():
    run = run_of("flying")
    length = run.time / 200
    of = {"collision_rate": lambda h: windows(run, h, np.ones(len(h))) / length,
          "collision_rate_above_threshold": lambda h: windows(run, h, (h["approach"] >= 0.1).astype(float)) / length}
    for name, series in of.items():
        halves = [half_width_over_time(series(hits), student) for hits in run.hits]
        assert run.result.summary[name]["ci95_time"] == pytest.approx(math.hypot(*halves) / 2, rel=1e-6), name
    for name in ("energy_normal_mean", "energy_contact_point_mean"):
        kind = name.removeprefix("energy_").removesuffix("_mean")
        halves = []
        for hits in run.hits:
            count = windows(run, hits, np.ones(len(hits)))
            halves.append(half_width_over_time(
                windows(run, hits, energies(hits)[kind])[count > 0] / count[count > 0], student))
        assert run.result.summary[name]["ci95_time"] == pytest.approx(math.hypot(*halves) / 2, rel=1e-6), name


@pytest.mark.parametrize("name", ["dissipated_power", "drawn_power"])
def test_the_interval_of_a_power_over_time_is_that_of_its_series(name):
    run = run_of("ground")  # one replicate
    half = half_width_over_time(run.result.table("timeseries")[f"{name}_W"], student)
    assert run.result.summary[name]["ci95_time"] == pytest.approx(half, rel=1e-6)


def test_quantities_without_a_series_have_no_interval_over_time():
    shown = run_of("flying").result.summary
    assert shown["drawn_power"]["ci95_time"] > 0
    for name in ("impact_angle_mean", "ball_count", "wear_rate_jar", "conversion"):
        assert shown[name]["ci95_time"] is None


# Over time.

def test_the_time_series_counts_the_records_of_each_window():
    run = run_of("flying")
    rows = run.result.table("timeseries")
    length = run.time / 200
    is_same(rows["time_s"], np.linspace(0, run.time, 201)[1:], "end of the window", rel=1e-9)
    mean = lambda of: np.mean([windows(run, h, of(h)) for h in run.hits], axis=0)
    count = mean(lambda h: np.ones(len(h)))
    is_same(rows["collision_rate_per_s"], count / length, "rate")
    is_same(rows["collision_rate_above_threshold_per_s"], mean(lambda h: h["approach"] >= 0.1) / length, "above")
    # The losses are those of each bounce, the record that of the whole contact.
    edges = np.linspace(0, run.time, 201)
    lost = np.mean([binned(h["time"] - run.begin, edges, energies(h)["lost"]) for h in run.hits], axis=0) / length
    lasting = np.mean([energies(h[h["duration"] > 0])["lost"].sum() for h in run.hits]) / length
    assert np.abs(rows["dissipated_power_W"] - lost).sum() <= 2 * lasting + 1e-9 * lost.sum()
    assert lasting < 0.05 * lost.sum()
    with np.errstate(invalid="ignore"):
        is_same(rows["energy_normal_mean_J"], mean(lambda h: energies(h)["normal"]) / count, "energy", least=1e-15)
