# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Made-up replays in the form of viewer/README.md: balls moved by formulas, not by a simulation."""

import array
import base64
import math


def packed(kind, numbers):
    """Base64 of little-endian numbers; kind as of the array module: f, h, H, B, I."""
    return base64.b64encode(array.array(kind, numbers).tobytes()).decode()


def turn_about(axis, angle):
    """Quaternion x, y, z, w."""
    s = math.sin(angle / 2)
    return [axis[0] * s, axis[1] * s, axis[2] * s, math.cos(angle / 2)]


def turned(quaternion, v):
    x, y, z, w = quaternion
    tx, ty, tz = (2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0]))
    return [v[0] + w * tx + y * tz - z * ty, v[1] + w * ty + z * tx - x * tz,
            v[2] + w * tz + x * ty - y * tx]


def product(a, b):
    return [*turned(a, b[:3]), 0] if b[3] == 0 else [
        a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
        a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
        a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
        a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]]


def lathe(profile, steps=72):
    """Surface of (radius, z) pairs turned about z, fronts outwards."""
    vertices, triangles = [], []
    for radius, z in profile:
        for k in range(steps):
            a = 2 * math.pi * k / steps
            vertices += [radius * math.cos(a), radius * math.sin(a), z]
    for ring in range(len(profile) - 1):
        for k in range(steps):
            a, b = ring * steps + k, ring * steps + (k + 1) % steps
            triangles += [a, b, a + steps, b, b + steps, a + steps]
    return vertices, triangles


def mesh(name, shape, turn=None):
    vertices, triangles = shape
    return {"name": name, "vertices": packed("f", vertices), "triangles": packed("I", triangles),
            "turn": None if turn is None else packed("f", turn)}


def cylinder(radius, height):
    return lathe([(0, -height / 2), (radius, -height / 2), (radius, height / 2), (0, height / 2)])


def capsule(radius, height):
    arc = [math.pi / 2 * i / 16 for i in range(17)]
    below = [(radius * math.sin(a), -height / 2 - radius * math.cos(a)) for a in arc]
    return lathe(below + [(r, -z) for r, z in reversed(below)])


def replay(title, times, radius, species, places, centre, jar, carried, meshes, jump=1, **more):
    """places: [frame][ball] -> x, y, z [m] in the jar frame; speeds come from their differences,
    those of balls put back to where they began, further than `jump` [m], left out."""
    frames, count = len(times), len(radius)
    speeds = []
    for f in range(frames):
        a, b = max(f - 1, 0), min(f + 1, frames - 1)
        dt = max(times[b] - times[a], 1e-12)
        moved = [math.dist(p, q) for p, q in zip(places[a], places[b])]
        speeds += [0 if way > jump else way / dt for way in moved]
    flat = [x for frame in places for place in frame for x in place]
    length = max(map(abs, flat)) / 32767
    speed = max(max(speeds), 1e-9) / 65535
    return {
        "version": 1, "title": title, "times": times, "count": count, "of": count,
        "radius": packed("f", radius), "species": packed("B", species), "species_names": ["steel"],
        "position_scale": length, "positions": packed("h", [round(x / length) for x in flat]),
        "speed_scale": speed, "speeds": packed("H", [round(v / speed) for v in speeds]),
        "jar_centre": packed("f", [x for c in centre for x in c]),
        "jar_turn": packed("f", [x for q in jar for x in q]),
        "carrier_turn": packed("f", [x for q in carried for x in q]),
        "carrier": None, "meshes": meshes, **more}


still = [0, 0, 0, 1]


def planetary():
    """Five balls swing along the wall of a jar, disc 400 rpm to the left, ratio 1:-2."""
    frames, big, ball, orbit = 400, 0.020, 0.006, 0.070
    omega = 400 / 60 * 2 * math.pi
    times = [0.75e-3 * f for f in range(frames)]
    places = []
    for t in times:
        frame = []
        for k in range(5):
            angle = omega * t + 0.7 * math.sin(3.1 * omega * t) + 0.72 * (k - 2)
            hop = 0.006 * abs(math.sin(2.3 * omega * t + 1.3 * k)) ** 2
            r = big - ball - hop
            z = -0.5 * big + ball + (k % 2) * 0.008 + 0.002 * abs(math.sin(4 * omega * t + k))
            frame.append([r * math.cos(angle), r * math.sin(angle), z])
        places.append(frame)
    z_axis = [0, 0, 1]
    centre = [[orbit * math.cos(omega * t), orbit * math.sin(omega * t), 0] for t in times]
    return replay("Five balls in a planetary mill", times, [ball] * 5, [0, 0, 0, 1, 1], places,
                  centre, [turn_about(z_axis, -omega * t) for t in times],
                  [turn_about(z_axis, omega * t) for t in times],
                  [mesh("jar", cylinder(big, 1.6 * big))],
                  carrier="disc", species_names=["steel, 12 mm", "zirconia, 12 mm"])


def with_hits(data, radius):
    """The same with spins, densities and hits: at each frame one hit at the wall, of ball 0 and 1 by turns, whose
    energies are 1 uJ to 1 mJ; the wall is a cylinder of `radius` [m]."""
    frames, count = len(data["times"]), data["count"]
    angles = [0.1 * f for f in range(frames)]
    unit = data["position_scale"]
    places = [round(x / unit) for a in angles for x in (radius * math.cos(a), radius * math.sin(a), 0)]
    return {**data, "spin_scale": 100 / 65535, "densities": [7850] * len(data["species_names"]),
            "spins": packed("H", [60000 * (k + 1) // count for _ in range(frames) for k in range(count)]),
            "hits": {"count": frames, "frames": packed("f", range(frames)), "places": packed("h", places),
                     "energies": packed("f", [1e-6 * 10 ** (f % 4) for f in range(frames)]),
                     "balls": packed("H", [x for f in range(frames) for x in (f % 2, 65535)]),
                     "of_balls": packed("I", [(frames + 1) // 2, frames // 2] + [0] * (count - 2))}}


def bed(radius, width, ball, count):
    """Places of `count` balls in rows, layer upon layer, in the lower part of a lying drum."""
    found, dz = [], 2.03 * ball * math.sqrt(3) / 2
    z = -radius + ball
    layer = 0
    while len(found) < count:
        half = math.sqrt(max(0, (radius - ball) ** 2 - z * z))
        across = max(1, int(2 * half / (2.03 * ball)))
        along = int((width - 2 * ball) / (2.03 * ball))
        for i in range(across):
            y = (i - (across - 1) / 2) * 2.03 * ball
            found += [[(j - along / 2 + 0.5) * 2.03 * ball, y, z] for j in range(along)]
        z, layer = z + dz, layer + 1
    return found[:count]


def drum(count=5000, frames=30):
    """A bed that rocks in a turning drum, and some balls that fall over it. Lies along x."""
    radius, width, ball = 0.10, 0.06, 0.0026
    omega = 1.2 * 2 * math.pi
    rest = bed(radius, width, ball, count)
    lie = turn_about([0, 1, 0], math.pi / 2)  # the jar's z along x
    times = [0.02 * f for f in range(frames)]
    flying = [k for k in range(count) if k > 0.8 * count and k % 3 == 0]
    places = []
    for t in times:
        rock = turn_about([1, 0, 0], 0.55 + 0.12 * math.sin(2.5 * t * omega))
        frame = [turned(rock, place) for place in rest]
        for k in flying:
            s = (0.37 * k + 2.0 * t) % 1
            frame[k] = [rest[k][0], 0.06 - 0.13 * s, 0.045 + 0.09 * s - 0.13 * s * s]
        places.append(frame)
    return replay("Five thousand balls in a drum", times,
                  [ball * (1 - 0.25 * (k % 3 == 0)) for k in range(count)],
                  [int(k % 3 == 0) for k in range(count)], places, [[0, 0, 0]] * frames,
                  [product(turn_about([1, 0, 0], omega * t), lie) for t in times], [still] * frames,
                  [mesh("jar", cylinder(radius, width))], of=100000, jump=0.08,
                  species_names=["steel, 5.2 mm", "steel, 3.9 mm"])


def vial():
    """One ball bounces in a capsule that is shaken upright at 10 Hz."""
    frames, amplitude, omega = 200, 0.025, 20 * math.pi
    times = [1e-3 * f for f in range(frames)]
    centre = [[0, 0, amplitude * math.sin(omega * t)] for t in times]
    places = [[[0.0012 * math.sin(9 * t), 0.001 * math.cos(7 * t),
                0.018 * (2 * abs((3.3 * t * 5) % 2 - 1) - 1)]] for t in times]
    return replay("One ball in a vibrating vial", times, [0.004], [0], places, centre,
                  [still] * frames, [still] * frames, [mesh("jar", capsule(0.006, 0.040))],
                  species_names=["steel, 8 mm"])


def turning_cube(faces=True):
    """A cube of eight spheres turns about the axis of a capsule; drawn by its faces, or by its spheres."""
    frames, half = 20, 0.002
    times = [1e-3 * f for f in range(frames)]
    corners = [[x, y, z] for x in (-half, half) for y in (-half, half) for z in (-half, half)]
    places = [[[x * math.cos(a) - y * math.sin(a), x * math.sin(a) + y * math.cos(a), z] for x, y, z in corners]
              for a in (0.05 * f for f in range(frames))]
    data = replay("A cube that turns", times, [0.001] * 8, [0] * 8, places, [[0, 0, 0]] * frames,
                  [still] * frames, [still] * frames, [mesh("jar", capsule(0.006, 0.020))],
                  species_names=["cube"])
    if faces:
        flat = [1.5 * c for corner in corners for c in corner]
        size = 1.5 * half * 3 ** 0.5
        data["bodies"] = [{
            "first": 0, "count": 1, "radius": 0.001, "places": packed("f", [c for p in corners for c in p]),
            "vertices": packed("f", flat), "normals": packed("f", [c / size for c in flat]),
            "triangles": packed("I", [0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                                      2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3])}]
    return data


def attritor():
    """A stirrer turns in an upright vessel among 200 balls that follow it."""
    frames, radius, ball = 60, 0.05, 0.004
    omega = 4 * 2 * math.pi
    times = [5e-3 * f for f in range(frames)]
    rest = [[(0.018 + 0.0088 * (k % 4)), 2 * math.pi * (k // 4 % 10) / 10 + 0.31 * (k % 2),
             -0.045 + 0.0085 * (k // 40)] for k in range(200)]
    places = [[[r * math.cos(a + w), r * math.sin(a + w), z] for r, a, z in rest
               for w in [0.5 * omega * t * (1 - r / 0.06)]] for t in times]
    shaft = lathe([(0, -0.03), (0.005, -0.03), (0.005, 0.055), (0, 0.055)], 32)
    v, t = shaft
    for level in (-0.025, 0.0):  # arms: boxes across
        base = len(v) // 3
        v += [c for x in (-0.042, 0.042) for y in (-0.003, 0.003) for z in (level, level + 0.006)
              for c in (x, y, z)]
        t += [base + i for i in (0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                                 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3)]
    spin = [x for s in times for x in turn_about([0, 0, 1], omega * s)]
    return replay("A stirred vessel", times, [ball] * 200, [0] * 200, places, [[0, 0, 0]] * frames,
                  [still] * frames, [still] * frames,
                  [mesh("jar", cylinder(radius, 0.11)), mesh("stirrer", (v, t), spin)])
