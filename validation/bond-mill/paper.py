# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="Power of Bond's standard ball mill",
              source="H. J. Steiner, Characterization of laboratory-scale tumbling mills, Int. J. "
                     "Miner. Process. 44-45 (1996) 373-382; M. Daniel, Bond's toolbox (2006), with "
                     "Bond's number of 1949",
              about="The charge of steel balls is that of the standard test: 285 balls, about 20 "
                    "kg, 70 rpm. The ore (700 ml, a few per cent of the mass) is left out. Friction "
                    "and restitution are not published and are assumed over a wide range. Moduli "
                    "are a hundredth of those of steel, which does not change the power (README).",
              licence="single numbers, cited as facts")

power = paper.campaign("power")

measured_steiner = paper.measured(
    "steiner",
    source="Steiner 1996, introduction: net power of the Bond mill of approximately 70 W; read in "
           "the paper's first page",
    status="verified",
    error_is="half of the last stated digit",
    values=[("70 W", "5 W")])
measured_daniel = paper.measured(
    "daniel",
    source="Daniel 2006, abstract: 91.4 J per revolution by a digital energy meter, times 70/60 per "
           "second; how the losses of the drive were subtracted is not in the abstract",
    status="verified",
    error_is="none given; 2 % assumed",
    values=[("106.6 W", "2.1 W")])
measured_levin = paper.measured(
    "levin",
    source="Levin 1989: 198e-7 kWh per revolution, as it is often quoted, not seen in print; Doll "
           "and Nikolic state that it is computed from the work index, not measured at the mill",
    status="unverified",
    error_is="none",
    values=[("83 W", "1 W")])

paper.figure("1", "power of the mill against the assumed friction",
             power.curve("drawn_power", against="contact.friction"))

paper.check("1", "the net power is approximately 70 W (Steiner 1996)",
            power.agrees_with(measured_steiner, "drawn_power"),
            why="the assumed friction decides: balls slide at 0.2 and are lifted at 0.8; the "
                "restitution changes nothing")
paper.check("1", "the mill takes 91.4 J per revolution, 106.6 W (Daniel 2006)",
            power.agrees_with(measured_daniel, "drawn_power"),
            why="this number is half as high again as Steiner's; it includes the ore, and possibly "
                "losses of the drive; the two published values cannot both be the net power of the "
                "balls")
paper.check("1", "the mill takes 198e-7 kWh per revolution, 83 W (Levin 1989)",
            power.agrees_with(measured_levin, "drawn_power"))
