# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Frames, replay, fields and states of a ball whose path is known: it flies through a jar of a planetary mill without
weight and touches nothing, so it moves straight in the laboratory while disc and jar turn below it."""
import math
import re

import numpy as np
import pytest

import mahlwerk
from mahlwerk.plots import replay
from quantity_runs import BALLS, JAR

ORBIT, DISC, JAR_SPIN, TIME, RADIUS = 0.07, 10 * math.pi, -10 * math.pi, 0.02, 4e-3  # 300 rpm, ratio -2
START, VELOCITY, SPIN = np.array([-8e-3, -1e-3, 3e-3]), np.array([0.05, 2.2, -0.1]), np.array([5.0, -3.0, 8.0])
MASS = 7850 * math.pi / 6 * 8e-3**3
REACH = math.hypot(20e-3, 20e-3)  # of the jar from its centre


def centre(t):
    return ORBIT * np.array([np.cos(DISC * t), np.sin(DISC * t), 0 * t])


def position(t):
    """[m] Relative to the jar's centre, in the axes of the laboratory."""
    return centre(0) + START + VELOCITY * t - centre(t)


def velocity(t):
    """[m/s] Likewise."""
    return VELOCITY - ORBIT * DISC * np.array([-np.sin(DISC * t), np.cos(DISC * t), 0])


def turned(a, angle):
    return np.array([a[0] * np.cos(angle) - a[1] * np.sin(angle), a[0] * np.sin(angle) + a[1] * np.cos(angle), a[2]])


def rows_of(a):
    return [f"{x!r} {unit}" for x, unit in a]


@pytest.fixture(scope="module")
def flight(tmp_path_factory):
    """The result, and its folder with the frames."""
    text = lambda values, unit: [f"{value!r} {unit}" for value in values.tolist()]
    case = {"title": "flight", "gravity": "0 m/s2",
            "mill": {"kind": "planetary", "orbit_radius": "70 mm", "speed": "300 rpm", "ratio": -2}, "jar": JAR,
            "balls": [{**{k: v for k, v in BALLS.items() if k != "count"}, "positions": [text(START, "m")],
                       "velocities": [text(VELOCITY, "m/s")], "spins": [text(SPIN, "rad/s")]}],
            "contact": {"restitution": 0.6, "friction": 0.3},
            "observe": {"frames": "3 ms", "final_state": True},
            "run": {"engine": "event", "time": f"{TIME} s", "settle": "0 s", "replicates": 1}}
    folder = tmp_path_factory.mktemp("flight") / "result"
    result = mahlwerk.Case(case).run(folder)
    assert result["collision_rate"].value == 0
    return result, folder


def frames_of(folder):
    """Keys and columns of each frame of frames-1.xyz."""
    lines = (folder / "frames-1.xyz").read_text().splitlines()
    frames = []
    while lines:
        count = int(lines[0])
        keys = dict((key, value.strip('"')) for key, value in re.findall(r'(\w+)=("[^"]*"|\S+)', lines[1]))
        frames.append((keys, np.array([list(map(float, line.split())) for line in lines[2:2 + count]])))
        lines = lines[2 + count:]
    return frames


def vector(text):
    return np.array(list(map(float, text.split())))


def test_frames_follow_the_ball_at_their_times(flight):
    frames = frames_of(flight[1])
    assert [float(keys["Time"]) for keys, _ in frames] == pytest.approx([0.003 * k for k in range(7)])
    for keys, rows in frames:
        t = float(keys["Time"])
        expected = [1, 1, *position(t), RADIUS, *velocity(t), *SPIN]
        assert rows[0] == pytest.approx(expected, rel=1e-9, abs=1e-12)
        assert vector(keys["jar_centre"]) == pytest.approx(centre(t), abs=1e-12)
        for axis, unit in zip(("jar_x", "jar_y", "jar_z"), np.eye(3)):
            assert vector(keys[axis]) == pytest.approx(turned(unit, JAR_SPIN * t), abs=1e-12)
        assert vector(keys["Lattice"]).reshape(3, 3) == pytest.approx(2 * REACH * np.eye(3))
        assert vector(keys["Origin"]) == pytest.approx(3 * [-REACH]) and keys["pbc"] == "F F F"


def test_the_final_state_is_in_the_axes_of_the_carrier(flight):
    row = flight[0].table("final-1")[0]
    assert (row["ball"], row["kind"], row["radius_m"]) == (1, 1, RADIUS)
    for head, unit, value in (("", "m", position(TIME)), ("velocity_", "m_per_s", velocity(TIME)),
                              ("spin_", "rad_per_s", SPIN)):
        assert [row[f"{head}{axis}_{unit}"] for axis in "xyz"] == pytest.approx(
            turned(value, -DISC * TIME), rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("frame, speed", [("jar", JAR_SPIN), ("carrier", DISC)])
def test_the_replay_shows_the_ball_in_the_axes_of_a_frame(flight, frame, speed):
    shown = replay(flight[0], frame)
    # As many frames as a replay has at most, over the whole run.
    assert shown["times"] == pytest.approx(TIME * np.arange(360) / 359, abs=1e-9)
    expected = np.array([turned(position(t), -speed * t) for t in shown["times"]])
    grain = REACH / 32767  # positions are whole numbers of it, turns have single precision
    assert shown["positions"][:, 0] == pytest.approx(expected, abs=2 * grain)
    speeds = np.array([math.sqrt(sum(velocity(t)**2)) for t in shown["times"]])
    assert shown["speeds"][:, 0] == pytest.approx(speeds, rel=2e-5, abs=2e-5 * speeds.max())


def means(frame_speed):
    """Means over time of position, velocity and kinetic energy in a turning frame, and the largest change of each in
    the time between two samples: four in each of 200 windows."""
    times = (np.arange(20000) + 0.5) / 20000 * TIME
    spin = np.array([0, 0, frame_speed])
    places = np.array([turned(position(t), -frame_speed * t) for t in times])
    speeds = np.array([turned(velocity(t) - np.cross(spin, position(t)), -frame_speed * t) for t in times])
    energies = MASS * np.sum(speeds**2, axis=1) / 2
    change = lambda a: np.abs(np.diff(a, axis=0)).max(axis=0) * 20000 / 800
    return (places.mean(axis=0), change(places)), (speeds.mean(axis=0), change(speeds)), (
        energies.mean(), change(energies))


@pytest.mark.parametrize("frame, speed", [("jar", JAR_SPIN), ("carrier", DISC)])
def test_fields_hold_mass_momentum_and_energy_of_the_ball_in_their_frame(flight, frame, speed):
    rows = flight[0].table("fields")
    rows = rows[rows["frame"] == frame]
    width = 2 * 20e-3 / 48
    for name in ("x_m", "y_m"):
        assert (rows[name] + 20e-3) / width % 1 == pytest.approx(0.5, abs=1e-9), "middles of 48 cells"
    mass = rows["density_kg_per_m2"] * width**2
    assert mass.sum() == pytest.approx(MASS, rel=1e-9)
    place, momentum, energy = means(speed)
    for i, axis in enumerate("xy"):
        assert (mass * rows[f"{axis}_m"]).sum() / MASS == pytest.approx(place[0][i], abs=place[1][i])
        assert (mass * rows[f"velocity_{axis}_m_per_s"]).sum() / MASS == pytest.approx(
            momentum[0][i], abs=momentum[1][i])
    assert (rows["kinetic_energy_J_per_m2"] * width**2).sum() == pytest.approx(energy[0], abs=energy[1])
    # In each cell the velocity is that of the ball when it passes.
    times = np.linspace(0, TIME, 4001)
    places = np.array([turned(position(t), -speed * t)[:2] for t in times])
    for row in rows[mass > 0.01 * MASS]:
        near = times[np.all(np.abs(places - [row["x_m"], row["y_m"]]) < width, axis=1)]
        seen = np.array([turned(velocity(t) - np.cross([0, 0, speed], position(t)), -speed * t) for t in near])
        for i, axis in enumerate("xy"):
            assert seen[:, i].min() - 1e-9 <= row[f"velocity_{axis}_m_per_s"] <= seen[:, i].max() + 1e-9


def test_the_balls_of_a_stopped_run_are_where_they_came_to_rest():
    """A ball that falls on the bottom, without treatment of ever smaller bounces: they collapse."""
    case = {"title": "collapse", "mill": {"kind": "still"}, "jar": JAR,
            "balls": [{**{k: v for k, v in BALLS.items() if k != "count"}, "positions": [["3 mm", "-2 mm", "-10 mm"]],
                       "velocities": [["0 m/s", "0 m/s", "0 m/s"]], "spins": [["1 rad/s", "2 rad/s", "3 rad/s"]]}],
            "contact": {"restitution": 0.5, "friction": 0, "lasting": "none"},
            "run": {"engine": "event", "time": "1 s", "settle": "0 s", "replicates": 1}}
    with pytest.raises(mahlwerk.RunError) as stopped:
        mahlwerk.Case(case).run()
    row = stopped.value.result.table("stopped-1")[0]
    found = [row[name] for name in row.dtype.names]
    assert found == pytest.approx([1, 1, RADIUS, 3e-3, -2e-3, -16e-3, 0, 0, 0, 1, 2, 3], abs=1e-6)
