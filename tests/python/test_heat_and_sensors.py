# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""The tables of heat and sensors, computed a second time: from the records and the equations of docs/theory."""
import math

import numpy as np
import pytest

from quantity_runs import run_of
from test_quantities import heard, jar_work
from test_tables import is_same, quarters

CELSIUS = 273.15
BALL = 7850 * math.pi / 6 * 8e-3**3  # [kg] of 8 mm


def exponential(matrix):
    """exp(matrix) by squaring a Taylor series."""
    squarings = max(0, int(np.ceil(np.log2(np.abs(matrix).sum(axis=0).max() + 1e-300))) + 6)
    small = matrix / 2.0**squarings
    term = total = np.eye(len(matrix))
    for k in range(1, 16):
        term = term @ small / k
        total = total + term
    for _ in range(squarings):
        total = total @ total
    return total


def after(matrix, source, start, time):
    """The solution of y' = matrix y + source at a time."""
    n = len(start)
    whole = np.zeros((n + 1, n + 1))
    whole[:n, :n], whole[:n, n] = matrix, source
    return (exponential(whole * time) @ np.append(start, 1))[:n]


# Heat: a ball of steel in a jar of steel, 3 mm thick. It mills three times for 10 min with pauses of 5 min.

class Heat:
    """Temperatures of balls and jar, and the reading of a thermocouple in the gas (hea.1 to hea.3, sns.7, sns.8)."""
    MILLING, PAUSE, LAG, SHARE, AMBIENT = 600, 300, 60, 0.4, 20

    def __init__(self, run, power):
        wall = run.result.table("wall_map")["area_m2"].sum()  # the drawn wall, of facets
        balls = math.pi * 8e-3**2
        c_b, c_j = BALL * 460, wall * 3e-3 * 7850 * 460
        g_bj, g_ja = 50 * balls, 15 * wall
        gas = balls / (balls + wall)
        self.matrix = np.array([[-g_bj / c_b, g_bj / c_b, 0],
                                [g_bj / c_j, -(g_bj + g_ja) / c_j, 0],
                                [gas / self.LAG, (1 - gas) / self.LAG, -1 / self.LAG]])
        self.heating = np.array([self.SHARE * power / c_b, (1 - self.SHARE) * power / c_j, 0])
        self.gas = gas

    def at(self, time):
        """Balls, jar and reading [degC] at a time of the clock."""
        above, begin = np.zeros(3), 0.0
        while begin < time:
            for length, source in ((self.MILLING, self.heating), (self.PAUSE, np.zeros(3))):
                step = min(length, time - begin)
                if step > 0:
                    above, begin = after(self.matrix, source, above, step), begin + step
        return above + self.AMBIENT

    def clock(self, milling):
        """The time of the clock at a milling time, without the pause that follows it."""
        return milling + self.PAUSE * max(0, math.ceil(milling / self.MILLING - 1e-9) - 1)


@pytest.fixture(scope="module")
def heat():
    run = run_of("cycled")
    return Heat(run, run["dissipated_power"])


def test_temperatures_are_those_of_two_lumps(heat):
    rows = run_of("cycled").result.table("temperature")
    assert rows["time_s"][0] == 0 and rows["time_s"][-1] == pytest.approx(3 * 900)
    assert {600, 900, 1500, 1800, 2400} <= set(np.round(rows["time_s"], 6))
    found = np.array([heat.at(time) for time in rows["time_s"]])
    is_same(rows["balls_degC"], found[:, 0], "balls", rel=1e-8)
    is_same(rows["jar_degC"], found[:, 1], "jar", rel=1e-8)


def test_the_thermocouple_lags_behind_the_gas(heat):
    rows = run_of("cycled").result.table("thermocouple")
    found = np.array([heat.at(time) for time in rows["time_s"]])
    is_same(rows["surroundings_degC"], heat.gas * found[:, 0] + (1 - heat.gas) * found[:, 1], "gas", rel=1e-8)
    is_same(rows["reading_degC"], found[:, 2], "reading", rel=1e-8)


def test_temperatures_after_milling_are_those_before_the_last_pause(heat):
    run = run_of("cycled")
    for i, power in enumerate(run.by_replicate("dissipated_power")):
        end = Heat(run, power).at(2400)
        for name, value in zip(("temperature_balls", "temperature_jar", "thermocouple_reading"), end):
            assert run.by_replicate(name)[i] == pytest.approx(value, rel=1e-8), name


def test_arrhenius_reads_the_temperature_of_the_balls_over_milling_and_pauses():
    run = run_of("cycled")
    rows = run.result.table("conversion")
    assert len(rows) == 201
    is_same(rows["time_s"], np.linspace(0, 1800, 201), "milling time")
    of = [Heat(run, power) for power in run.by_replicate("dissipated_power")]
    for row in rows[[0, 50, 66, 67, 150, 200]]:
        temperatures, shares = [], []
        for heat in of:
            clock = heat.clock(row["time_s"])
            grid = np.linspace(0, clock, 601)
            kelvin = np.array([heat.at(time)[0] for time in grid]) + CELSIUS
            rate = 1e7 * np.exp(-60e3 / (8.31446261815324 * kelvin))
            shares.append(1 - math.exp(-np.trapz(rate, grid)))
            temperatures.append(kelvin[-1])
        assert row["temperature_K"] == pytest.approx(np.mean(temperatures), rel=1e-8)
        assert row["conversion"] == pytest.approx(np.mean(shares), rel=1e-4, abs=1e-12)  # of the quadrature


# Sensors.

def test_the_power_meter_reads_the_work_of_the_jar():
    run = run_of("frictionless")
    rows = run.result.table("power_meter")
    is_same(rows["time_s"], np.arange(1, 21) * 0.05, "end of the reading")
    hits = run.hits[0]
    at = hits["time"] + hits["duration"] - run.begin
    w = 2 * math.pi * 20
    for row in rows:
        those = hits[(at > row["time_s"] - 0.05) & (at <= row["time_s"])]
        # A record sums the bounces of 20 us: so much later, the jar has another speed.
        unsure = 2 * 20e-6 * w * 8e-3 * w * np.sum(those["impulse"]) / 0.05
        assert row["drawn_power_W"] == pytest.approx(jar_work(those, run) / 0.05, abs=unsure + 1e-9)
    is_same(rows["motor_power_W"], 5 + 3 * rows["drawn_power_W"] / 0.8, "motor")
    assert rows["drawn_power_W"].mean() == pytest.approx(run.by_replicate("drawn_power")[0], rel=1e-9)
    assert run.by_replicate("motor_power_scatter")[0] == pytest.approx(rows["motor_power_W"].std(ddof=1), rel=1e-9)


@pytest.mark.parametrize("name, speed", [("planetary", 300 * math.pi / 30), ("stirred", 300 * math.pi / 30)])
def test_the_power_meter_reads_the_torque_of_a_shaft(name, speed):
    run = run_of(name)
    rows = run.result.table("power_meter")
    is_same(rows["torque_N_m"], 2 * rows["drawn_power_W"] / speed, "torque of two jars")
    lengths = np.diff(np.append(0, rows["time_s"]))  # the soft engine reads at the end of a time step
    assert np.average(rows["drawn_power_W"], weights=lengths) == pytest.approx(
        run.by_replicate("drawn_power")[0], rel=1e-9)


def test_the_microphone_counts_the_hits_that_it_hears_by_energy():
    run = run_of("flying")
    rows = run.result.table("microphone")
    low, high = rows["energy_low_J"], rows["energy_high_J"]
    assert quarters(low, high)
    loud = np.concatenate([heard(hits) for hits in run.hits])
    time = run.time * len(run.hits)
    is_same(rows["rate_per_s"], [np.sum((loud >= a) & (loud < b)) / time for a, b in zip(low, high)], "rate")
    is_same(rows["rate_above_per_s"], [np.sum(loud >= a) / time for a in low], "above")


def filtered(values, step, bandwidth, start):
    """x'' + sqrt(2) w x' + w^2 x = w^2 u at the end of each step, u constant in each (sns.6)."""
    w = 2 * math.pi * bandwidth
    matrix = np.array([[0, 1], [-w * w, -math.sqrt(2) * w]])
    move, state, made = exponential(matrix * step), np.array([start, 0.0]), []
    for u in values:
        steady = np.array([u, 0.0])
        state = steady + move @ (state - steady)
        made.append(state[0])
    return np.array(made)


def test_the_accelerometer_follows_the_jar_and_the_impacts():
    run = run_of("warm")
    rows, hits = run.result.table("accelerometer"), run.hits[0]
    step, mass, w = 1 / 40e3, 0.4, 2 * math.pi * 20
    is_same(rows["time_s"], np.arange(1, 1501) * 1e-4, "samples")
    middle = run.begin + step * (np.arange(6000) + 0.5)
    motion = filtered(-8e-3 * w * w * np.sin(w * middle), step, 1e3, -8e-3 * w * w * math.sin(w * middle[0]))
    is_same(rows["of_motion_m_per_s2"], motion[3::4], "motion", rel=1e-7, least=1e-7)
    edges = run.begin + step * np.arange(6001)
    impulse = np.zeros(6000)
    for h in hits[hits["other"] < 0]:
        end = h["time"] + h["duration"]
        inside = np.clip(np.minimum(end, edges[1:]) - np.maximum(h["time"], edges[:-1]), 0, None)
        impulse += h["impulse"] * h["normal_z"] * inside / h["duration"]
    of_impacts = filtered(impulse / (step * mass), step, 1e3, 0)
    largest = np.abs(of_impacts).max()
    is_same(rows["of_impacts_m_per_s2"], of_impacts[3::4], "impacts", rel=1e-6, least=1e-6 * largest)
    is_same(rows["acceleration_m_per_s2"], (motion + of_impacts)[3::4], "signal", rel=1e-6, least=1e-6 * largest)
    whole = motion + of_impacts
    for name, value in {"acceleration_rms": math.sqrt(np.mean(whole**2)),
                        "acceleration_rms_of_impacts": math.sqrt(np.mean(of_impacts**2)),
                        "acceleration_peak": np.abs(whole).max()}.items():
        assert run.by_replicate(name)[0] == pytest.approx(value, rel=1e-6), name
