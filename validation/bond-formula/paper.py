# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="Bond's formula for the power of ball mills",
              source="F. C. Bond, Br. Chem. Eng. 6 (1961) 378, 543: kW per ton of balls = 4.879 D^0.3 (3.2 - 3 J) phi "
                     "(1 - 0.1/2^(9 - 10 phi)), D in m inside the liners; an empirical formula, no measurement",
              about="A slice of 2.4 m without ends, with twenty lifters, and the same drum with a smooth shell, over "
                    "filling and speed. Friction 0.5, restitution 0.5; balls of D/32.",
              licence="a formula", quick=False)

lifters = paper.campaign("lifters")
smooth = paper.campaign("smooth")

paper.figure("1", "simulated power over Bond's, with lifters",
             lifters.curve("power_over_bond", against="mill.speed"))
paper.figure("2", "simulated power over Bond's, smooth shell",
             smooth.curve("power_over_bond", against="mill.speed"))

paper.check("1", "with lifters the power is above 0.8 of Bond's at all fillings and speeds",
            lifters.above("0.8", "power_over_bond", against="mill.speed"), own=True)
paper.check("1", "with lifters the power is below 1.1 times Bond's",
            lifters.below("1.1", "power_over_bond", against="mill.speed"), own=True)
paper.check("2", "a smooth shell slips: the power is below 0.85 of Bond's",
            smooth.below("0.85", "power_over_bond", against="mill.speed"), own=True)
