# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="States of one ball in a mixer mill, by a film",
              source="github.com/LukasBeckers/ball-mill-3D, a notebook's outputs: one 10 mm ball, 434 "
                     "frames, 14 cycles",
              about="The film shows the ball circling round the jar's axis without hits on the ends for "
                    "79 % of the time, in two stretches, and bouncing from end to end between them. "
                    "Mill, materials, frequency and powder are not stated; lengths are over the half "
                    "stroke. Fourteen cycles hold one change to bouncing and one back, so the shares "
                    "are one draw. Restitution, friction and rolling friction are assumed.",
              licence="ratios, cited as facts")

states = paper.campaign("states")
start = paper.campaign("start")

over = ["contact.restitution", "contact.friction", "contact.rolling_friction"]
measured_share = paper.measured(
    "share", source="frames 0-220 and 310-434 circle, the others bounce, partly by eye",
    status="unverified", error_is="one stretch of bouncing in 14 cycles: our guess",
    values=[("0.79", "0.2")])
measured_turns = paper.measured(
    "turns", source="1.4 falling to 0.8 in the first stretch, 1.68 in the second: unwrapped angle",
    status="verified", error_is="the range",
    values=[("1.24", "0.44")])

paper.figure("1", "share of the time in which the ball circles, against the restitution",
             states.curve("circling_share", against="contact.restitution",
                          band_over=["contact.friction", "contact.rolling_friction"]))
paper.figure("2", "turns round the jar's axis in a period, against the restitution",
             states.curve("turns_per_cycle", against="contact.restitution",
                          band_over=["contact.friction", "contact.rolling_friction"]))
paper.figure("3", "share of the time in which a ball that started from rest stays where it is",
             start.curve("stationary_share", against="mill.tilt",
                         band_over=["contact.restitution"]))

paper.check("1", "the ball circles for most of the time, and bounces between",
            states.agrees_with(measured_share, "circling_share"),
            why="the assumed values decide between never and most of the time. Both states occur in one "
                "run with a friction of 0.3 or more and a restitution of 0.8 or more, as by the defaults, "
                "or with little rolling friction")
paper.check("2", "it turns 0.8 to 1.7 times round the jar's axis in a period",
            states.agrees_with(measured_turns, "turns_per_cycle"))
paper.check("3", "a level mill that speeds up from rest leaves the ball where it lies (ours)",
            start.smaller("stationary_share", against="mill.tilt", first="0 deg", second="4 deg"),
            own=True)
