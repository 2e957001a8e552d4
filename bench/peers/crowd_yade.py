# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Many balls in a jar on a mill, for YADE: laboratory frame, a jar of facets.

The benchmark writes the case to case.in, state.data and jar.stl. STEPS comes from the environment.
Energy and speed go to log.txt in the format of the other two programs.
"""
import math
import os
import time

from yade import *
from yade import ymport

steps = int(os.environ["STEPS"])
words = [line.split() for line in open("case.in")]
case = {word[1]: float(word[3]) for word in words if word[2] == "equal"}
disc, spin, orbit = case["disc"], case["spin"], case["orbit"]


def rows_of(section):
    """The lines of numbers below the heading `section`."""
    with open("state.data") as file:
        for line in file:
            if line.strip() == section:
                break
        next(file)
        for line in file:
            if not line.strip():
                break
            yield [float(word) for word in line.split()]


def material(density):
    return FrictMat(young=case["youngs_modulus"], poisson=0.3, frictionAngle=math.atan(0.5),
                    density=density)


materials = {}
jar = O.bodies.append(ymport.stl("jar.stl", material=O.materials.append(material(7700))))
balls = []
for place, motion in zip(rows_of("Atoms"), rows_of("Velocities")):
    density = place[3]
    if density not in materials:
        materials[density] = O.materials.append(material(density))
    ball = sphere(place[4:7], place[2] / 2, material=materials[density])
    ball.state.vel, ball.state.angVel = Vector3(*motion[1:4]), Vector3(*motion[4:7])
    balls.append(O.bodies.append(ball))

if disc == 0:
    moved = RotationEngine(rotateAroundZero=True, zeroPoint=(0, 0, 0), rotationAxis=(1, 0, 0),
                           angularVelocity=spin, ids=jar)
else:
    # The vial's velocity is the sum of a rotation about the fixed origin and an oscillation:
    #   v(r) = spin z x r + (disc - spin) z x c(t),  c the vial's centre
    swing = (disc - spin) / disc * orbit
    frequency = disc / (2 * math.pi)
    moved = (HarmonicMotionEngine(A=(swing, swing, 0), f=(frequency, frequency, 0),
                                  fi=(0, -math.pi / 2, 0), ids=jar)
             + RotationEngine(rotateAroundZero=True, zeroPoint=(0, 0, 0), rotationAxis=(0, 0, 1),
                              angularVelocity=spin, ids=jar))

O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Facet_Aabb()], verletDist=-case["margin"]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom()],
        # eta refers to the mean of both radii, not to the effective radius: half for equal balls.
        # krot is one absolute stiffness [N m/rad] for every pair; small balls are stable only with
        # a small one.
        [Ip2_FrictMat_FrictMat_MindlinPhys(en=0.5, es=0.5, eta=0.025,
                                           krot=case["bending_stiffness"])],
        [Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=True)]),
    moved,
    NewtonIntegrator(damping=0, gravity=(0, 0, -9.81)),
]
O.dt = case["step_time"]

O.run(1, True)  # the others, too, search near pairs once before their clocks begin
begin = time.time()
O.run(steps - 1, True)
taken = time.time() - begin

moving = spinning = 0
for i in balls:
    state = O.bodies[i].state
    moving += 0.5 * state.mass * state.vel.squaredNorm()
    spinning += 0.5 * state.inertia[0] * state.angVel.squaredNorm()
with open("log.txt", "w") as log:
    log.write("%d %.9g %.9g\n" % (steps, moving, spinning))
    log.write("Loop time of %.6f on %s procs for %d steps with %d atoms\n"
              % (taken, os.environ["OMP_NUM_THREADS"], steps - 1, len(balls)))
