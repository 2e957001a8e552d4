# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="Power and slope of charges of cylpebs, rods and cubes",
              source="N. S. Lameck, K. K. Kiangi and M. H. Moys, Effects of grinding media shapes on load "
                     "behaviour and mill power in a dry ball mill, Miner. Eng. 19 (2006) 1357-1361",
              about="Power of a dry mill with balls, worn balls and cylpebs over its speed. The abstract gives "
                    "statements and no numbers. We compute a slice of a drum of 300 mm with twelve lifters and 98 "
                    "bodies of 20 mm; restitution and friction are assumed. The slope of charges of four shapes "
                    "in a slow drum has no measured value here.",
              licence="statements, cited as facts",
              quick=False)

cylpebs = paper.campaign("cylpebs")
balls = paper.campaign("balls")
slopes = {name: paper.campaign(f"slope-{name}") for name in ("sphere", "cylinder", "rod", "cube")}

paper.figure("1", "power of cylpebs over the speed", cylpebs.curve("drawn_power", against="mill.speed"))
paper.figure("2", "power of balls over the speed", balls.curve("drawn_power", against="mill.speed"))

for name, campaign in (("cylpebs", cylpebs), ("balls", balls)):
    paper.check("1" if campaign is cylpebs else "2",
                f"{name}: the power increases with the speed, from 60 to 80 % of the critical one",
                campaign.larger("drawn_power", against="mill.speed", first="60 %", second="80 %"))
paper.check("3", "a bed of spheres is less steep than 35 degrees",
            slopes["sphere"].below("35 deg", "bed_angle"), own=True)
for name in ("cylinder", "rod", "cube"):
    paper.check("3", f"with the same friction a bed of {name}s is steeper than 35 degrees",
                slopes[name].above("35 deg", "bed_angle"), own=True)
