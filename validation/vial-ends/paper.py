# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="Flat and round ends of a shaker mill's vial",
              source="L. Takacs and J. S. McHenry, Temperature of the milling balls in shaker and "
                     "planetary mills, J. Mater. Sci. 41 (2006) 5246-5249",
              about="The temperature of the balls of a SPEX 8000 was measured by calorimetry. In a "
                    "vial with flat ends the balls stay cooler than in one with round ends although "
                    "milling is more intense; the authors conclude that flat ends give a larger "
                    "proportion of frontal impacts. The abstract names neither the balls nor the "
                    "vials: five balls of 9.5 mm are our choice. Strokes and frequency of the mill "
                    "are unverified, its rocking is left out, and restitution and friction are "
                    "assumed over a wide range. Round ends are a cylinder whose edges are rounded "
                    "with its own radius.",
              licence="two orderings, cited as facts")

ends = paper.campaign("ends")

paper.figure("1a", "mean angle of impact for flat and round ends",
             ends.curve("impact_angle_mean_above_threshold", against="jar.fillet"))
paper.figure("1b", "power drawn by the balls for flat and round ends",
             ends.curve("drawn_power", against="jar.fillet"))

paper.check("1a", "impacts are more frontal in a vial with flat ends (smaller mean angle from head-on)",
            ends.larger("impact_angle_mean_above_threshold", against="jar.fillet", first="1 mm",
                        second="18.9 mm"))
paper.check("1b", "milling is more intense in a vial with flat ends (power drawn by the balls)",
            ends.smaller("drawn_power", against="jar.fillet", first="1 mm", second="18.9 mm"))
paper.figure("1c", "share of the dissipated energy that goes into normal deformation, for flat and round ends",
             ends.curve("impact_efficiency", against="jar.fillet"))
paper.check("1c", "with flat ends less goes into friction: the share that hits lose along the normal is larger",
            ends.smaller("impact_efficiency", against="jar.fillet", first="1 mm", second="18.9 mm"),
            why="the authors' explanation of the cooler balls, not a measurement")
