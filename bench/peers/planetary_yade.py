# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Five balls in a planetary mill's vial, for YADE: laboratory frame, a vial of facets.

The benchmark writes the case to case.in and vial.stl. The number of STEPS, and the number EVERY of
steps between two outputs of the balls, come from the environment. The speed goes to log.txt in the
format of the other two programs.
"""
import math
import os
import time

from yade import *
from yade import ymport

steps, every = int(os.environ["STEPS"]), int(os.environ["EVERY"])
words = [line.split() for line in open("case.in")]
case = {word[1]: float(word[3]) for word in words if word and word[0] == "variable"}
disc, spin, orbit = case["disc"], case["spin"], case["orbit"]

O.materials.append(FrictMat(young=case["youngs_modulus"], poisson=case["poissons_ratio"],
                            frictionAngle=math.atan(case["friction"]), density=case["density"],
                            label="steel"))
vial = O.bodies.append(ymport.stl("vial.stl", material="steel"))
balls = []
for n in range(1, 6):
    place = Vector3(case["x%d" % n], case["y%d" % n], case["z%d" % n])
    ball = sphere(place, case["diameter"] / 2, material="steel")
    # At rest in the vial, which turns as fast as the disc, in the opposite sense.
    ball.state.vel = Vector3(disc * place[1], disc * orbit - disc * (place[0] - orbit), 0)
    balls.append(O.bodies.append(ball))

# The vial's velocity is the sum of a rotation about the fixed origin and an oscillation:
#   v(r) = spin z x r + (disc - spin) z x c(t),  c the vial's centre
swing = (disc - spin) / disc * orbit
frequency = disc / (2 * math.pi)
carried = HarmonicMotionEngine(A=(swing, swing, 0), f=(frequency, frequency, 0),
                               fi=(0, -math.pi / 2, 0), ids=vial)
turned = RotationEngine(rotateAroundZero=True, zeroPoint=(0, 0, 0), rotationAxis=(0, 0, 1),
                        angularVelocity=spin, ids=vial)

e = case["restitution"]
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Facet_Aabb()], verletDist=0.0005),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom()],
        # krot is one absolute stiffness [N m/rad] for every pair; 11 suits balls of 15 mm
        [Ip2_FrictMat_FrictMat_MindlinPhys(en=e, es=e, eta=case["rolling_friction"], krot=11.0)],
        [Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=True)]),
    carried + turned,
    NewtonIntegrator(damping=0, gravity=(0, 0, -case["gravity"])),
]
O.dt = case["step_time"]

out = open("/dev/stdout", "w")


def dump():
    out.write("ITEM: TIMESTEP\n%d\nITEM: ATOMS\n" % O.iter)
    for n, i in enumerate(balls):
        state = O.bodies[i].state
        parts = (state.pos, state.vel, O.forces.f(i), state.angVel, O.forces.t(i))
        out.write("%d %s\n" % (n + 1, " ".join("%.9g" % a for part in parts for a in part)))


if every <= steps:  # between forces and motion; one step more, so that the last one is written too
    writer = PyRunner(command="dump()", iterPeriod=every)
    O.engines = O.engines[:-1] + [writer] + O.engines[-1:]
    steps += 1

begin = time.time()
O.run(steps, True)
taken = time.time() - begin
out.close()
with open("log.txt", "w") as log:
    log.write("Loop time of %.6f for %d steps\n" % (taken, steps))
