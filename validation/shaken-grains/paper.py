# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="Rise of a shaken charge",
              source="X. Yang and D. Candela, Potential energy in a three-dimensional vibrated "
                     "granular medium measured by NMR imaging, Phys. Rev. Lett. 85 (2000), "
                     "arXiv:cond-mat/0001115",
              about="Grains in a vertical tube, shaken at 10 to 28 g. Density profiles were "
                    "measured by fast NMR imaging. The abstract gives the exponents and their "
                    "errors, but not the grains, the tube or the numbers of grains; those here are "
                    "our choice (mustard seeds at 50 Hz, one to five layers, as in the same group's "
                    "next paper, Phys. Rev. E 69, 041302). Restitution and friction are assumed "
                    "over a wide range.",
              licence="two exponents, cited as facts")

velocity = paper.campaign("velocity")
number = paper.campaign("number")

paper.figure("1", "rise of the centre of mass against the amplitude",
             velocity.curve("charge_rise", against="mill.amplitude", law="power"))
paper.figure("2", "rise of the centre of mass against the number of grains",
             number.curve("charge_rise", against="balls.count", law="power"))

paper.check("1", "the rise of the centre of mass grows as a power 1.0 ± 0.2 of the velocity of "
                 "vibration",
            velocity.follows_power("charge_rise", against="mill.amplitude", exponent=1.0, within=0.2))
paper.check("2", "the rise of the centre of mass falls as a power -0.5 ± 0.1 of the number of grains",
            number.follows_power("charge_rise", against="balls.count", exponent=-0.5, within=0.1))
