#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Files of a result open in the programs they are meant for: h5py, pandas and VTK's own readers.

    opening_test.py PROGRAM TEST      runs one test; exit code 77 if its modules are not installed
"""
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree

SKIPPED = 77
try:
    import h5py
    import numpy
    import pandas
    from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError as missing:
    print(f"skipped: {missing} (python3-h5py, python3-pandas, python3-vtk9)")
    sys.exit(SKIPPED)

BALLS, WIDTH, DEPTH, HEIGHT = 5, 0.03, 0.042, 0.0325  # [m] of the jar
CASE = f"""
title = "Five balls in a box that turns"
[mill]
kind = "planetary"
orbit_radius = "70 mm"
speed = "400 rpm"
ratio = "1:-2"
[jar]
kind = "box"
width = "{WIDTH} m"
depth = "{DEPTH} m"
height = "{HEIGHT} m"
[[balls]]
count = 3
diameter = "8 mm"
density = "7850 kg/m3"
[[balls]]
count = {BALLS - 3}
diameter = "6 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.6
friction = 0.3
softening = 0.05  # contacts last longer, so some frame shows one
[run]
engine = "soft"
time = "40 ms"
settle = "5 ms"
replicates = 2
[observe]
collisions = true
frames = "1 ms"
"""
FRAMES = 41


def states(what, found, expected, tolerance, source):
    """As tests/statement.hpp: prints one number with its expected value, and checks it."""
    print(f"    {what}: expected {expected}, found {found} (tolerance {tolerance:g}) [{source}]")
    assert abs(found - expected) <= tolerance, what


def run(program, here, case=CASE):
    (here / "case.toml").write_text(case)
    subprocess.run([program, "run", here / "case.toml", "--out", here / "out", "--quiet"], check=True)
    return here / "out"


def text(value):
    return value.decode() if isinstance(value, bytes) else value


def datasets(file):
    found = []
    file.visititems(lambda name, item: found.append(item) if isinstance(item, h5py.Dataset) else None)
    return found


def h5py_finds_a_unit_and_a_description_of_every_number(program, here):
    out = run(program, here)
    for name, least in (("result.h5", 6), ("collisions.h5", 2)):
        with h5py.File(out / name) as file:
            assert text(file.attrs["case"]).startswith("title = "), name
            assert text(file.attrs["mahlwerk"])
            sets = datasets(file)
            assert len(sets) >= least, (name, sets)
            for one in sets:
                assert text(one.attrs["about"]), one
                for field in one.dtype.names or ():
                    for kind in ("unit_", "about_"):
                        assert text(one.attrs[kind + field]), (one, field)
                if one.dtype.names is None:
                    assert text(one.attrs["unit"]), one
            print(f"    {name}: {len(sets)} data sets, each with units and descriptions")
    with h5py.File(out / "result.h5") as file, h5py.File(out / "collisions.h5") as hits:
        summary = {row["name"].decode(): row["value"] for row in file["summary"][:]}
        counted = sum(hits[f"replicate_{n}/collisions"].shape[0] for n in (1, 2)) / 2
        rate = counted / summary["simulated_time"]
        states("collision_rate [1/s]", summary["collision_rate"], rate, 1e-12 * rate, "records over time")


def pandas_reads_every_table_in_one_line(program, here):
    out = run(program, here)
    tables = sorted(out.glob("*.csv"))
    assert len(tables) >= 6, tables
    for path in tables:
        table = pandas.read_csv(path, float_precision="round_trip")
        same = pandas.DataFrame(h5py.File(out / "result.h5")[path.stem][:])
        assert len(table) > 0, path
        assert table.shape == same.shape, (path, table.shape, same.shape)
        for head, name in zip(table, same):
            assert head == name or head.startswith(name.removesuffix("_ci95")), (path, head, name)
            if same[name].dtype == object:
                assert list(table[head]) == list(same[name].str.decode("utf-8")), (path, head)
            else:
                assert table[head].equals(same[name]) or numpy.array_equal(
                    table[head].to_numpy(float), same[name].to_numpy(), equal_nan=True), (path, head)
        print(f"    {path.name}: {table.shape[0]} rows, {table.shape[1]} columns, as in result.h5")
    hits = pandas.DataFrame(h5py.File(out / "collisions.h5")["replicate_1/collisions"][:])
    assert len(hits) > 0 and (hits["approach"] > 0).all()


def listed(path):
    """The entries of a .pvd file: time, part, file."""
    found = xml.etree.ElementTree.parse(path).getroot().iter("DataSet")
    return [(float(d.get("timestep")), d.get("name"), path.parent / d.get("file")) for d in found]


def polydata(path):
    """The file as VTK's own reader reads it; None if the reader reports an error."""
    reader = vtkXMLPolyDataReader()
    faults = []
    reader.AddObserver("ErrorEvent", lambda *_: faults.append(path))
    reader.SetFileName(str(path))
    reader.Update()
    return None if faults else reader.GetOutput()


def column(data, name):
    array = data.GetPointData().GetArray(name)
    return numpy.array([array.GetTuple(i) for i in range(array.GetNumberOfTuples())])


def points(data):
    return numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])


def xyz_frames(path):
    """Extended XYZ: the keys of each frame, and its numbers."""
    lines, frames = path.read_text().splitlines(), []
    while lines:
        count = int(lines[0])
        keys = {key: value.strip('"') for key, value in re.findall(r'(\w+)=("[^"]*"|\S+)', lines[1])}
        frames.append((keys, numpy.array([line.split() for line in lines[2:2 + count]], float)))
        lines = lines[2 + count:]
    return frames


DOUBLE = 8 * numpy.finfo(float).eps  # relative rounding of a corner: three products and their sum


def vtk_reads_every_frame_as_it_is_in_the_xyz_file(program, here):
    out = run(program, here)
    frames, entries = xyz_frames(out / "frames-1.xyz"), listed(out / "frames-1.pvd")
    states("frames", len(frames), FRAMES, 0, "40 ms by 1 ms, the first and the last")
    states("entries of the list", len(entries), 2 * FRAMES, 0, "balls and jar of each frame")
    fields = {"radius": [5], "velocity": [6, 7, 8], "spin": [9, 10, 11], "force": [12, 13, 14],
              "species": [1], "id": [0]}
    pushed, corners = 0, numpy.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    for n, (keys, rows) in enumerate(frames):
        (when, balls_name, balls_file), (_, jar_name, jar_file) = entries[2 * n:2 * n + 2]
        assert (balls_name, jar_name) == ("balls", "jar")
        balls, jar = polydata(balls_file), polydata(jar_file)
        assert balls is not None and jar is not None, (balls_file, jar_file)
        assert balls.GetNumberOfPoints() == balls.GetNumberOfVerts() == BALLS
        assert numpy.array_equal(points(balls), rows[:, 2:5])
        for name, columns in fields.items():
            assert numpy.array_equal(column(balls, name), rows[:, columns]), name
        pushed += numpy.count_nonzero(column(balls, "force"))
        now = balls.GetFieldData().GetArray("TimeValue").GetTuple(0)[0]
        assert now == when == float(keys["Time"])
        centre = numpy.array(balls.GetFieldData().GetArray("jar_centre").GetTuple(0))
        assert abs(numpy.linalg.norm(centre) - 0.07) < 1e-15, centre  # radius of its orbit
        # A box: its corners lie half its sides along its own axes, which the XYZ file contains.
        assert jar.GetNumberOfPolys() == 12 and jar.GetNumberOfPoints() == 8
        axes = numpy.array([[float(x) for x in keys[k].split()] for k in ("jar_x", "jar_y", "jar_z")])
        wanted = corners * (WIDTH / 2, DEPTH / 2, HEIGHT / 2) @ axes
        off = [numpy.linalg.norm(wanted - corner, axis=1).min() for corner in points(jar)]
        assert max(off) < DOUBLE * DEPTH, (n, max(off))
        assert jar.GetCellData().GetArray("part").GetRange() == (0, 0)
    assert pushed > 0, "no frame has a force"
    print(f"    {len(frames)} frames of {BALLS} balls and their jar, the same doubles in both forms")


# Jars with rotating parts, and a charge of 40 balls of 8 mm.
PARTS = """
title = "Balls among parts of a jar"
[mill]
{mill}
[jar]
diameter = "{diameter} m"
{jar}
[[balls]]
count = 40
diameter = "8 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.6
friction = 0.3
[run]
engine = "soft"
time = "{time} ms"
settle = "0 s"
replicates = 1
[observe]
frames = "10 ms"
frames_format = "vtk"
"""
DRUM = PARTS.format(mill='kind = "tumbling"\nspeed = "60 rpm"\njar_axis = "horizontal"', time=400,
                    diameter=0.1, jar="""kind = "lifter-cylinder"
height = "60 mm"
lifters = 3
lifter_height = "10 mm"
lifter_width = "15 mm"
lifter_face_angle = "70 deg\"""")
STIRRED = PARTS.format(mill='kind = "still"', time=400, diameter=0.08, jar="""kind = "attritor"
height = "60 mm"
shaft_diameter = "16 mm"
shaft_clearance = "4 mm"
arms = 2
arm_diameter = "8 mm"
arm_span = "60 mm"
arm_clearance = "10 mm"
arm_spacing = "14 mm"
rotor_speed = "300 rpm\"""")


def vtk_sees_balls_touch_the_parts_of_the_jar_and_go_through_none(program, here):
    for name, case, diameter in (("drum with lifters", DRUM, 0.1), ("stirrer", STIRRED, 0.08)):
        (here / name).mkdir()
        entries = listed(run(program, here / name, case) / "frames-1.pvd")
        nearest, radius = [], 0.004
        for (_, _, balls_file), (_, _, jar_file) in zip(entries[::2], entries[1::2]):
            wall = vtkImplicitPolyDataDistance()
            wall.SetInput(polydata(jar_file))
            nearest.append(min(abs(wall.EvaluateFunction(p)) for p in points(polydata(balls_file))) - radius)
        # The facets (48 around a jar, 12 around an arm) lie inside of the round walls and arms.
        # With the default softness of contacts, overlaps are a few thousandths of a radius.
        inside = diameter / 2 * (1 - numpy.cos(numpy.pi / 48)) + 0.01 * radius
        outside = 0.004 * (1 - numpy.cos(numpy.pi / 12)) * 2 + 0.01 * radius
        print(f"    {name}: nearest ball of each of {len(nearest)} frames is {min(nearest):.2g} to "
              f"{max(nearest):.2g} m from the wall drawn, expected {-inside:.2g} to {outside:.2g}")
        assert len(nearest) == 41 and min(nearest) >= -inside and nearest[-1] <= outside


def vtk_and_python_open_what_a_killed_run_leaves(program, here):
    (here / "case.toml").write_text(CASE.replace('"40 ms"', '"1000 s"').replace('"1 ms"', '"2 ms"'))
    process = subprocess.Popen([program, "run", here / "case.toml", "--out", here / "out", "--quiet"])
    left = here / f".out.partial-{process.pid}"
    try:
        looks, entries, end = 0, [], time.monotonic() + 60
        while looks < 50 or len(entries) < 200:
            assert time.monotonic() < end
            time.sleep(0.01)
            process.send_signal(signal.SIGSTOP)  # at any moment
            changed = os.waitid(os.P_PID, process.pid, os.WSTOPPED | os.WEXITED)
            assert changed.si_code == os.CLD_STOPPED, "the run ended by itself"
            if (left / "frames-1.pvd").exists() and (left / "frames-1.pvd").stat().st_size > 0:
                entries = listed(left / "frames-1.pvd")
                assert all(file.exists() for _, _, file in entries)
                looks += 1
            process.send_signal(signal.SIGCONT)
    finally:
        process.kill()
        process.wait()
    assert not (here / "out").exists()
    entries = listed(left / "frames-1.pvd")
    for _, name, file in entries:
        data = polydata(file)
        assert data is not None, file
        assert data.GetNumberOfPoints() == (BALLS if name == "balls" else 8), file
    assert len(entries) >= 200 and len(xyz_frames_whole(left / "frames-1.xyz")) >= 100
    print(f"    killed after {len(entries) // 2} frames: all of them open; {looks} looks before found a whole list")


def xyz_frames_whole(path):
    """Frames of a file whose last frame may be cut short."""
    lines = path.read_text().splitlines()
    return lines[:len(lines) // (BALLS + 2) * (BALLS + 2):BALLS + 2]


def main():
    tests = {name: test for name, test in globals().items() if name.startswith(("h5py_", "pandas_", "vtk_"))}
    program, name = sys.argv[1:]
    print(name.replace("_", " "))
    with tempfile.TemporaryDirectory(prefix="mahlwerk-") as here:
        tests[name](program, pathlib.Path(here))


main()
