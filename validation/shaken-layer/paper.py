# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="Velocities of a partial layer of beads on a vibrating plate",
              source="W. Losert, D. G. W. Cooper, J. Delour, A. Kudrolli and J. P. Gollub, Velocity "
                     "statistics in excited granular media, Chaos 9 (1999), doi 10.1063/1.166442, "
                     "arXiv:cond-mat/9901203",
              about="Beads that cover a part of a plate are shaken at 3 to 8 g. The horizontal "
                    "velocities were measured by video; their characteristic value is proportional "
                    "to the peak velocity of the plate. Beads, plate and frequency are our choice "
                    "(4 mm steel, 40 % covered, 100 Hz), and restitution and friction are assumed "
                    "over a wide range. Our number is the root mean square of all components.",
              licence="one proportionality, cited as a fact")

velocity = paper.campaign("velocity")

paper.figure("1", "speed of the beads against the amplitude",
             velocity.curve("ball_speed_seen_from_jar", against="mill.amplitude", law="power"))

paper.check("1", "the characteristic velocity is proportional to the peak velocity of the plate "
                 "(exponent 1.0 ± 0.1)",
            velocity.follows_power("ball_speed_seen_from_jar", against="mill.amplitude", exponent=1.0,
                                   within=0.1),
            why="with a restitution of 0.6 the exponent is 1; with 0.9 beads fly so high between "
                "hits on the plate that they collide with each other more often per hit, and the "
                "exponent is 0.8")
