# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Frames, replay, fields and states of a ball whose path is known: it flies through a jar of a planetary mill without
weight and touches nothing, so it moves straight in the laboratory while disc and jar turn below it."""
import base64
import math
import re
from xml.etree import ElementTree

import numpy as np
import pytest

import mahlwerk
from mahlwerk.replay import replay
from quantity_runs import BALLS, CASES, JAR

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


@pytest.fixture(scope="module")
def flight(tmp_path_factory):
    """The result, and its folder with the frames."""
    text = lambda values, unit: [f"{value!r} {unit}" for value in values.tolist()]
    case = {"title": "flight", "gravity": "0 m/s2",
            "mill": {"kind": "planetary", "orbit_radius": "70 mm", "speed": "300 rpm", "ratio": -2}, "jar": JAR,
            "balls": [{**{k: v for k, v in BALLS.items() if k != "count"}, "positions": [text(START, "m")],
                       "velocities": [text(VELOCITY, "m/s")], "spins": [text(SPIN, "rad/s")]}],
            "contact": {"restitution": 0.6, "friction": 0.3},
            "observe": {"frames": "3 ms", "frames_format": "both", "final_state": True},
            "run": {"engine": "event", "time": f"{TIME} s", "settle": "0 s", "replicates": 2}}
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


def vtk_of(file):
    """The arrays of a file of PolyData by name, one row for each tuple; and the attributes of its piece."""
    root = ElementTree.parse(file).getroot()
    found = {}
    for array in root.iter("DataArray"):
        columns = int(array.get("NumberOfComponents", 1))
        if array.get("format") == "ascii":
            values = np.array(list(map(float, array.text.split())))
        else:
            data = base64.b64decode(array.text)
            assert np.frombuffer(data[:8], "<u8")[0] == len(data) - 8
            values = np.frombuffer(data[8:], {"Float64": "<f8", "Int32": "<i4"}[array.get("type")])
        found[array.get("Name")] = values.reshape(-1, columns)
    piece = next(root.iter("Piece")).attrib
    return found, {key: int(value) for key, value in piece.items()}


def listed(folder):
    """Time, part and file of each entry of frames-1.pvd."""
    return [(float(one.get("timestep")), int(one.get("part")), folder / one.get("file"))
            for one in ElementTree.parse(folder / "frames-1.pvd").getroot().iter("DataSet")]


COLUMNS = {"id": (0, 1), "species": (1, 2), "Points": (2, 5), "radius": (5, 6), "velocity": (6, 9), "spin": (9, 12),
           "force": (12, 15)}


def has_the_balls_of(frames, folder, forces):
    """Whether the files for ParaView have the same numbers as frames-1.xyz."""
    balls = [entry for entry in listed(folder) if entry[1] == 0]
    assert [time for time, _, _ in balls] == [float(keys["Time"]) for keys, _ in frames]
    for (time, _, file), (keys, rows) in zip(balls, frames):
        found, piece = vtk_of(file)
        assert piece == {"NumberOfPoints": len(rows), "NumberOfVerts": len(rows), "NumberOfLines": 0,
                         "NumberOfStrips": 0, "NumberOfPolys": 0}
        assert rows.shape[1] == (15 if forces else 12) and ("force" in found) == forces
        for name, (low, high) in COLUMNS.items():
            if forces or name != "force":
                assert np.array_equal(found[name], rows[:, low:high]), name
        assert found["TimeValue"][0, 0] == time and np.array_equal(found["jar_centre"][0], vector(keys["jar_centre"]))
        assert list(found["connectivity"][:, 0]) == list(range(len(rows)))
        assert list(found["offsets"][:, 0]) == list(range(1, len(rows) + 1))


def volume_of(corners):
    """[m3] Enclosed by triangles that are anticlockwise seen from outside."""
    return np.sum(corners[:, 0] * np.cross(corners[:, 1], corners[:, 2])) / 6


def triangles_of(found, piece, part):
    assert piece["NumberOfPoints"] == len(found["Points"]) and piece["NumberOfPolys"] == len(found["part"])
    assert list(found["offsets"][:, 0]) == list(range(3, 3 * len(found["part"]) + 1, 3))
    corners = found["Points"][found["connectivity"][:, 0]].reshape(-1, 3, 3)
    return corners[found["part"][:, 0] == part]


def test_files_for_paraview_have_the_numbers_of_the_frames(flight):
    has_the_balls_of(frames_of(flight[1]), flight[1], forces=False)
    jars = {file for _, part, file in listed(flight[1]) if part == 1}
    assert len(jars) == 1, "a cylinder that turns about its axis looks the same at all times"
    corners = triangles_of(*vtk_of(jars.pop()), part=0)
    polygon = 96 / 2 * 20e-3**2 * math.sin(2 * math.pi / 96)  # 96 facets
    assert volume_of(corners) == pytest.approx(40e-3 * polygon, rel=1e-12)


def test_frames_of_a_stirred_mill_turn_its_rotor(tmp_path):
    case = {**CASES["stirred"], "title": "stirred", "seed": 1,
            "observe": {"frames": "10 ms", "frames_format": "both"},
            "run": {"engine": "soft", "time": "20 ms", "settle": "0 s", "replicates": 1}}
    mahlwerk.Case(case).run(tmp_path / "result")
    frames = frames_of(tmp_path / "result")
    assert [len(rows) for _, rows in frames] == 3 * [40]
    has_the_balls_of(frames, tmp_path / "result", forces=True)
    shown = [(time, vtk_of(file)) for time, part, file in listed(tmp_path / "result") if part == 1]
    start = shown[0][1]
    assert volume_of(triangles_of(*start, part=0)) == pytest.approx(
        48 / 2 * 50e-3**2 * math.sin(2 * math.pi / 48) * 120e-3, rel=1e-12)
    assert len(shown) == 3 and volume_of(triangles_of(*start, part=1)) > 0
    for time, found in shown:
        angle = 300 * math.pi / 30 * time
        expected = np.moveaxis(turned(np.moveaxis(triangles_of(*start, part=1), -1, 0), angle), 0, -1)
        assert triangles_of(*found, part=1) == pytest.approx(expected, abs=1e-9)
        assert triangles_of(*found, part=0) == pytest.approx(triangles_of(*start, part=0), abs=1e-12)


def test_forces_of_frames_have_the_impulse_of_an_impact(tmp_path):
    case = {**CASES["impact"], "title": "impact", "seed": 1, "observe": {"frames": "5 us", "frames_format": "xyz"},
            "balls": [{key: value for key, value in CASES["impact"]["balls"][0].items() if value is not None}],
            "run": {"engine": "soft", "time": "4 ms", "settle": "0 s", "replicates": 1}}
    mahlwerk.Case(case).run(tmp_path / "result")
    frames = frames_of(tmp_path / "result")
    force = np.array([rows[0, 12:15] for _, rows in frames])
    assert np.abs(force[:, :2]).max() < 1e-9 * np.abs(force).max()
    assert np.count_nonzero(force[:, 2]) > 10
    # The impulse of an elastic impact at 0.5 m/s; a smooth pulse of some tens of frames.
    assert np.trapz(force[:, 2], [float(keys["Time"]) for keys, _ in frames]) == pytest.approx(MASS, rel=0.01)


def test_the_final_state_is_in_the_axes_of_the_carrier(flight):
    row = flight[0].table("final-1")[0]
    assert (row["ball"], row["kind"], row["radius_m"]) == (1, 1, RADIUS)
    for head, unit, value in (("", "m", position(TIME)), ("velocity_", "m_per_s", velocity(TIME)),
                              ("spin_", "rad_per_s", SPIN)):
        assert [row[f"{head}{axis}_{unit}"] for axis in "xyz"] == pytest.approx(
            turned(value, -DISC * TIME), rel=1e-9, abs=1e-12)


def test_a_run_from_a_state_keeps_a_copy_of_it(flight, tmp_path):
    mahlwerk.Case({"title": "second", "mill": {"kind": "still"}, "jar": JAR, "balls": [{**BALLS, "count": 1}],
                   "contact": {"restitution": 0.6, "friction": 0.3},
                   "run": {"engine": "event", "time": "1 ms", "settle": "0 s", "replicates": 2,
                           "start_from": str(flight[1])}}).run(tmp_path / "second")
    for i in (1, 2):
        state = (flight[1] / f"final-{i}.csv").read_text()
        assert (tmp_path / "second" / "start" / f"final-{i}.csv").read_text() == state


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


def test_a_measured_motion_is_in_the_result(tmp_path):
    rows = [(i / 100, i % 10 / 1000, i % 10 / 500, i % 10 / 250) for i in range(101)]
    (tmp_path / "motion.csv").write_text("time_s,x_m,y_m,z_m\n" + "".join(f"{a},{b},{c},{d}\n" for a, b, c, d in rows))
    case = mahlwerk.Case({"title": "measured", "mill": {"kind": "tabulated", "file": str(tmp_path / "motion.csv")},
                          "jar": JAR, "balls": [{**BALLS, "count": 1}], "contact": {"restitution": 0.6, "friction": 0.3},
                          "run": {"engine": "event", "time": "10 ms", "settle": "0 s", "replicates": 1}})
    found = case.run().table("motion")
    for i, name in enumerate(("time_s", "x_m", "y_m", "z_m")):
        assert found[name] == pytest.approx([row[i] for row in rows], abs=1e-15)
    assert np.all(found["angle_rad"] == 0)


def test_the_balls_of_a_stopped_run_are_where_they_came_to_rest():
    """A ball that falls on the bottom, without treatment of ever smaller bounces: they collapse."""
    case = {"title": "collapse", "mill": {"kind": "still"}, "jar": JAR,
            "balls": [{**{k: v for k, v in BALLS.items() if k != "count"}, "positions": [["3 mm", "-2 mm", "-10 mm"]],
                       "velocities": [["0 m/s", "0 m/s", "0 m/s"]], "spins": [["1 rad/s", "2 rad/s", "3 rad/s"]]}],
            "contact": {"restitution": 0.5, "friction": 0, "lasting": "none"},
            "accelerometer": {"mass": "1 kg", "bandwidth": "1 kHz", "sample_rate": "10 kHz", "duration": "0.9 s"},
            "run": {"engine": "event", "time": "1 s", "settle": "0 s", "replicates": 1}}
    with pytest.raises(mahlwerk.RunError) as stopped:
        mahlwerk.Case(case).run()
    shown = stopped.value.result.table("accelerometer")["time_s"]
    assert shown[-1] == pytest.approx(stopped.value.result["simulated_time"].value, abs=1e-4), "a sample"
    row = stopped.value.result.table("stopped-1")[0]
    found = [row[name] for name in row.dtype.names]
    assert found == pytest.approx([1, 1, RADIUS, 3e-3, -2e-3, -16e-3, 0, 0, 0, 1, 2, 3], abs=1e-6)
