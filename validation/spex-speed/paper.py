# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="Impact speeds in a SPEX mill",
              source="D. Basset, P. Matteazzi and F. Miani, Measuring the impact velocities of "
                     "balls in high energy mills, Mater. Sci. Eng. A 174 (1994) 71-74",
              about="Speeds of single impacts on the wall were measured from the size of the "
                    "indents. The abstract gives a range over ball sizes; the table is not "
                    "available to us. The strokes of the mill are unverified (catalogue), its "
                    "rocking is left out, and restitution and friction are assumed. The mean is "
                    "over impacts on the wall at 0.5 m/s and more.",
              licence="one range, cited as a fact")

speed = paper.campaign("speed")

measured_range = paper.measured(
    "range",
    source="abstract: 1.8 to 3.3 m/s relative to the wall, strongly dependent on ball size",
    status="verified",
    error_is="the range over ball sizes",
    values=[("2.55 m/s", "0.75 m/s")])

paper.figure("1", "mean normal speed of impacts against the ball's diameter",
             speed.curve("impact_speed_normal_mean_above_threshold", against="balls.diameter",
                         band_over=["contact.restitution", "contact.friction"]))

paper.check("1", "the balls hit the wall at 1.8 to 3.3 m/s",
            speed.agrees_with(measured_range, "impact_speed_normal_mean_above_threshold"),
            why="the range of the prediction covers that of the measurement, but it is wide: a ball "
                "that sticks to the end keeps the phase of the vial and hits once a cycle at 3.6 "
                "m/s, a bouncing ball hits more often and slower")
