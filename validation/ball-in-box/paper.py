# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="One ball in a vibrated box",
              source="Y. Garrabos, P. Evesque, F. Palencia, C. Lecoutre-Chabot and D. Beysens, "
                     "Coherent behavior of balls in a vibrated box, arXiv:cond-mat/0611613 (2006)",
              about="One and two balls in a box were vibrated on the ground and in low gravity. The "
                    "abstract reports that the ball comes to move along the direction of vibration "
                    "only: its rotation vanishes and its transverse velocity freezes. It gives no "
                    "numbers; box, ball and vibration are our choice, and restitution and friction "
                    "are assumed over a wide range.",
              licence="two observations, cited as facts")

coherence = paper.campaign("coherence")
twisting = paper.campaign("twisting")
twisting_soft = paper.campaign("twisting-soft")

paper.check("abstract", "the motion becomes parallel to the vibration (mean angle of impact below 5 "
                        "degrees after 400 periods)",
            coherence.below("5 deg", "impact_angle_mean_above_threshold"),
            why="each oblique hit loses tangential energy to friction, and the vibration gives none "
                "back")
paper.check("abstract", "the rotation of the ball is eliminated (angular velocity below 3 rad/s of "
                        "up to 50 rad/s at the start)",
            coherence.below("3 rad/s", "ball_spin"),
            why="here the default is wrong: rotation about the direction of vibration twists the "
                "contact, and by default nothing resists twisting, so this part of the starting "
                "spin stays for ever")
paper.check("abstract", "with twisting friction: the rotation of the ball is eliminated (angular "
                        "velocity below 3 rad/s of up to 50 rad/s at the start)",
            twisting.below("3 rad/s", "ball_spin"),
            why="friction over the contact area takes about a hundredth of the spin in each impact, "
                "and there are 40 impacts per second")
paper.check("abstract", "with partial slip and twisting friction in the soft engine: the motion "
                        "becomes parallel to the vibration (mean angle of impact below 5 degrees "
                        "after 400 periods)",
            twisting_soft.below("5 deg", "impact_angle_mean_above_threshold"),
            why="as with hard spheres")
paper.check("abstract", "with partial slip and twisting friction in the soft engine: the rotation "
                        "of the ball is eliminated (angular velocity below 3 rad/s of up to 50 "
                        "rad/s at the start)",
            twisting_soft.below("3 rad/s", "ball_spin"),
            why="the same torque, resolved in time")
