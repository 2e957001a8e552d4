# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="Heat of the balls of planetary mills",
              source="Y. S. Kwon, K. B. Gerasimov and S. K. Yoon, Ball temperatures during mechanical "
                     "alloying in planetary mills, J. Alloys Compd. (2002), as quoted",
              about="About 80 % of the power of the mill heats the balls, by the first slope of their "
                    "temperature, and balls of larger diameter become hotter at the same total mass. "
                    "Mill, speed, jar and charge are not in the quotation: a PM 100 with 150 g of "
                    "steel balls is our choice. Restitution, friction and both coefficients of heat "
                    "transfer are assumed.",
              licence="one number and one order, cited as facts")

heat = paper.campaign("heat")
assumed = ["contact.restitution", "contact.friction"]

measured_share = paper.measured(
    "share", source="about 80 % of the power heats the balls, from the initial slopes; quoted second hand",
    status="unverified", error_is="'about': our guess",
    values=[("0.8", "0.05")])

paper.figure("1", "share of the dissipated power that heats the balls first, against their diameter",
             heat.curve("heat_share_in_balls", against="balls.diameter", band_over=assumed))
paper.figure("2", "temperature of the balls after 30 min, against their diameter, 150 g of balls",
             heat.curve("temperature_balls", against="balls.diameter", band_over=assumed))

paper.check("1", "about 80 % of the power heats the balls",
            heat.agrees_with(measured_share, "heat_share_in_balls"))
paper.check("2", "at the same mass, larger balls become hotter",
            heat.larger("temperature_balls", against="balls.diameter", first="10 mm", second="20 mm"))
