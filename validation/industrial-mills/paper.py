# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="Power of industrial tumbling mills",
              source="A. G. Doll, IMPC 2016 (123), Table 1; A. G. Doll, Procemin 2013, Table 1; T. Golpayegani and "
                     "B. Rezai, Physicochem. Probl. Miner. Process. 58(4) (2022), Table 1; read in the data of "
                     "CAOS_ChargeCascade (MIT), not in the papers",
              about="Ten AG and SAG mills and one ball mill, 4.7 to 12.2 m wide. A slice without ends, with twenty "
                    "lifters, is filled with equal balls, D/32 wide, as dense as the whole charge: balls, ore and "
                    "slurry with half solids in all voids. Its power is scaled to the length of the mill. Lifters, "
                    "friction 0.5 and restitution 0.5 are assumed, the same for all mills; nothing is fitted.",
              licence="measured powers, cited as facts", quick=False)

mills = paper.campaign("mills")

# Motor power times the factor to the shell, by the length of the mill.
measured = paper.measured(
    "shell-power", source="motor power times the factor to the shell, or net power, of power.csv (Doll 2016 and others)",
    status="quoted", error_is="15 % of the measured power: the goal of the comparison, no error of the measurement",
    values=[("6.1 m", "18547 kW", "2782 kW"),
            ("4.42 m", "8752 kW", "1313 kW"),
            ("9.76 m", "12286 kW", "1843 kW"),
            ("5.88 m", "3647 kW", "547 kW"),
            ("9.25 m", "6889 kW", "1033 kW"),
            ("9.49 m", "2825 kW", "424 kW"),
            ("6.9 m", "18812 kW", "2822 kW"),
            ("3.96 m", "6132 kW", "920 kW"),
            ("6.4 m", "15970 kW", "2395 kW"),
            ("3.35 m", "3040 kW", "456 kW"),
            ("12.34 m", "13400 kW", "2010 kW")])

paper.figure("1", "power at the shell against the length of the mill",
             mills.curve("power_of_whole_mill", against="jar.mill_length", measured=measured))
paper.figure("2", "power over that by Bond's formula",
             mills.curve("power_over_bond", against="jar.mill_length"))
paper.figure("3", "power over that by Morrell's C model",
             mills.curve("power_over_morrell", against="jar.mill_length"))

paper.check("1", "power at the shell of eleven industrial mills, to 15 %",
            mills.agrees_with(measured, "power_of_whole_mill", against="jar.mill_length"),
            why="nine of eleven are within 10 %; Clarabelle is 17 % low, where every formula is 15 to 31 % low; the ball "
                "mill overflows: a pool of slurry at its toe takes power away, and the charge may hold less slurry")
