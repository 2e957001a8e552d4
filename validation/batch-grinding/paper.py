# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="Dry batch grinding of one size class over time",
              source="github.com/Mateus-M-Reis/Mill_Back-calculation_Notebook, dados/input.xlsx, rows 2-11",
              about="Mass left in the top class, 1.18 to 0.6 mm, after 0.333 to 15 min. Mill, balls and "
                    "material are not stated. So the set tests the law over the dose, not the mill: "
                    "one ball on a vibrating mill supplies a constant power, and the constants are "
                    "fitted to the first four times. The last two are predicted.",
              licence="measured shares, cited as facts")

stretched = paper.campaign("stretched")
first_order = paper.campaign("first-order")

later = [("10 min", "0.8364", "0.01"), ("15 min", "0.8996", "0.015")]
measured = paper.measured(
    "ground", source="one minus the share in the top class; the later times, which were not fitted",
    status="verified", error_is="not stated: about a tenth of what is left is our guess", values=later)

paper.figure("1", "share ground out of the top class against time, exponent 0.44",
             stretched.curve("conversion", against="kinetics.time", measured=measured))
paper.figure("2", "the same, first order",
             first_order.curve("conversion", against="kinetics.time", measured=measured))

paper.check("1", "share ground out after 10 and 15 min, from 0.333 to 5 min, with an exponent of the dose",
            stretched.agrees_with(measured, "conversion", against="kinetics.time"),
            why="distributed strengths within the class: the weak grains go first")
paper.check("2", "the same of first order in the dose",
            first_order.agrees_with(measured, "conversion", against="kinetics.time"),
            why="a rate that stays the same leaves 1 and 0.1 %, not 16 and 10 %")
