# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="Planetary mill against the speed ratio",
              source="H. Mio, J. Kano, F. Saito and co-workers (Mater. Sci. Eng. A 332 (2002) 75; "
                     "Chem. Eng. Sci. 59 (2004) 5909), as quoted by M. S. El-Eskandarany, "
                     "Mechanical Alloying, p. 65",
              about="The book quotes that the motion of the balls changes from cascading at a ratio "
                    "of rotation to revolution of 2.4 through cataracting at 2.6 to rolling at 2.8, "
                    "and that rolling is ineffective for grinding. It counts ratios in the "
                    "laboratory: 1.00 for a Pulverisette 7, which is 1:-2 relative to the disc. "
                    "Mill, jar and balls of these figures were not visible to us: we take a "
                    "Pulverisette 7 with 100 balls of 5 mm. Friction decides and is assumed over a "
                    "wide range.",
              licence="three ratios, cited as facts", quick=False)

ratio = paper.campaign("ratio")

paper.figure("1", "power against the ratio of rotation to revolution, three frictions",
             ratio.curve("drawn_power", against="mill.ratio"))

paper.check("1", "rolling at 2.8 is ineffective: the power at 2.8 is smaller than at 2.4",
            ratio.smaller("drawn_power", against="mill.ratio", first=-2.4, second=-2.8),
            why="with a friction of 0.8 the charge begins to move with the wall at 2.8, as quoted; "
                "with 0.5 and 0.2 the wall cannot hold it at these ratios")
paper.check("1", "with a friction of 0.8 the power is largest between the critical ratios without "
                 "and with friction, 1.95 (kin.13) and 2.46 (kin.18)",
            ratio.largest_between(-2, -2.4, "drawn_power", against="mill.ratio",
                                  at={"contact.friction": 0.8}),
            own=True)
paper.check("1", "with a friction of 0.8 the charge moves with the wall at 3.2",
            ratio.regime("rolling", against="mill.ratio",
                         at={"contact.friction": 0.8, "mill.ratio": -3.2}),
            own=True)
