# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="The vertical vibration mill (Chen et al. 2016)",
              source="Chen, Nguyen, Wu and Liu, J. Tsinghua Univ. (Sci. Technol.) 56(3) (2016) "
                     "328-333, doi 10.16511/j.cnki.qhdxxb.2016.21.030: one 8 mm ball in a 5 ml "
                     "capsule, event-driven",
              about="A hit is a collision with a normal speed of at least 0.1 m/s. Energies are "
                    "those at the contact point (our reading of the paper's eq. 10) unless a text "
                    "names the normal energy. Forty runs of 60 s per setting (the paper: five), 200 "
                    "for the amplitude; normal and tangential restitution 0.9; TC rule with 0.1 ms.")

diameter = paper.campaign("diameter")
amplitude = paper.campaign("amplitude")
frequency = paper.campaign("frequency")
size = paper.campaign("size")
free_numbers = paper.campaign("free-numbers")
spex = paper.campaign("spex")
sticking = paper.campaign("sticking")

paper.figure("4", "collision frequency against the vial's diameter",
             diameter.curve("collision_rate_above_threshold", against="jar.diameter"))
paper.figure("4", "energy of a collision against the vial's diameter",
             diameter.curve("energy_contact_point_mean_above_threshold", against="jar.diameter"))
paper.figure("4", "normal energy of a collision against the vial's diameter",
             diameter.curve("energy_normal_mean_above_threshold", against="jar.diameter"))
paper.figure("5", "collision frequency against amplitude",
             amplitude.curve("collision_rate_above_threshold", against="mill.amplitude", law="linear"))
paper.figure("5", "energy of a collision against amplitude",
             amplitude.curve("energy_contact_point_mean_above_threshold", against="mill.amplitude",
                             law="linear"))
paper.figure("6a", "collision frequency against vibration frequency",
             frequency.curve("collision_rate_above_threshold", against="mill.frequency", law="linear"))
paper.figure("6b", "energy of a collision against vibration frequency",
             frequency.curve("energy_contact_point_mean_above_threshold", against="mill.frequency",
                             law="power"))
paper.figure("7a", "D90 of millet against vibration frequency, one set of free parameters",
             size.curve("d90", against="mill.frequency"),
             about="Six parameters of the breakage of millet are free choices; no value of D90 here "
                   "is a prediction. Panel b has the band over 24 sets of them.")
paper.figure("7b", "the same, 24 sets of free parameters",
             free_numbers.curve("d90", against="mill.frequency",
                                band_over=["breakage.f_mat", "breakage.x_w_min",
                                           "capture.fracture_energy", "fragments.share"]))

paper.check("4", "the collision frequency falls as the vial gets wider, at constant volume",
            diameter.falls("collision_rate_above_threshold", against="jar.diameter"))
paper.check("4", "the energy of a collision falls as the vial gets wider",
            diameter.falls("energy_contact_point_mean_above_threshold", against="jar.diameter"))
paper.check("4", "the energy of a collision falls as the vial gets wider (read as the normal energy)",
            diameter.falls("energy_normal_mean_above_threshold", against="jar.diameter"),
            why="in the vial of 10 mm the ball has a clearance of 1 mm on either side, so hits on "
                "the side wall have little normal energy; a statement on the energy must name the "
                "energy")
paper.check("5", "the collision frequency is linear in the amplitude",
            amplitude.is_linear("collision_rate_above_threshold", against="mill.amplitude",
                                direction="rises"),
            why="the curve bends: above 25 mm each step adds less; the deviation stays below a "
                "tenth of the rise")
paper.check("5", "the energy of a collision is linear in the amplitude",
            amplitude.is_linear("energy_contact_point_mean_above_threshold", against="mill.amplitude",
                                direction="rises"),
            why="the curve bends more than that of the frequency: above 25 mm the energy of a hit "
                "hardly grows")
paper.check("6a", "the collision frequency is linear in the vibration frequency",
            frequency.is_linear("collision_rate_above_threshold", against="mill.frequency",
                                direction="rises"))
paper.check("6b", "the energy of a collision grows with the square of the vibration frequency",
            frequency.follows_power("energy_contact_point_mean_above_threshold",
                                    against="mill.frequency", exponent=2, within=0.05))
paper.check("5, 6", "the frequency matters more than the amplitude: the energy grows with a lower "
                    "power of the amplitude",
            amplitude.exponent_below("energy_contact_point_mean_above_threshold",
                                     against="mill.amplitude", exponent=2),
            why="the exponent is even lower than the paper's value of 1; the amplitude matters less "
                "than the paper states, and the paper's conclusion holds")
paper.check("intro", "more than half of the collisions have angles of 80 to 90 degrees (quoted from "
                     "works on SPEX mills; hits at 0.1 m/s and more)",
            spex.above("0.5", "grazing_share_above_threshold"),
            why="the statement is about SPEX mills, so it is judged there, with one and five balls. "
                "It depends on restitution and friction, which are assumed: the share exceeds a "
                "half only with a friction of 0.1. Strokes of the mill are unverified and its "
                "rocking is left out")
paper.check("intro", "more than half of the collisions have angles of 80 to 90 degrees (quoted from "
                     "works on SPEX mills; all collisions)",
            spex.above("0.5", "grazing_share"),
            why="most of these collisions are the small bounces of balls that slide along the wall; "
                "their number depends on how a simulation counts them")
paper.check("intro", "in the mill of this paper hardly any hit is that grazing (below a tenth)",
            frequency.below("0.1", "grazing_share_above_threshold", at={"mill.frequency": "10 Hz"}),
            why="round ends turn the ball back at all angles",
            own=True)
paper.check("7", "D90 of the millet falls with the vibration frequency",
            size.falls("d90", against="mill.frequency"),
            why="the claim holds for every tried set of the free parameters (below); the slope is "
                "not predicted")
paper.check("7", "D90 of the millet falls with the vibration frequency (our addition: for 24 sets "
                 "of the free parameters)",
            free_numbers.falls("d90", against="mill.frequency"),
            own=True)

paper.table("d90", "D90 of millet against frequency, for one set of the free parameters",
            size.table("d90", against="mill.frequency"))
paper.table("captured", "Millet that hits capture, against frequency",
            size.table("captured_mass_rate", against="mill.frequency"))
paper.table("free-numbers", "D90 of millet against frequency, for 24 sets of the free parameters",
            free_numbers.table("d90", against="mill.frequency", ratio=True))
paper.table("sticking", "D90 of millet against frequency, by the share of grains that stick",
            sticking.table("d90", against="mill.frequency", ratio=True))
