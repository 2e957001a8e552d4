# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="The planetary mill (Mhadhbi 2021)",
              source="M. Mhadhbi, \"Modelling of the High-Energy Ball Milling Process\", Advances "
                     "in Materials Physics and Chemistry 11, 2021, 31-44, doi "
                     "10.4236/ampc.2021.111004: a Fritsch Pulverisette 7, simulated by the discrete "
                     "element method",
              about="The paper gives neither the radius nor the speed of the disc; we use the 70 mm "
                    "and 400 rpm of the machine. The paper gives no number for any of these "
                    "figures. The powder consists of a few hundred soft grains, and the runs are "
                    "short; the case files state the softening and the times. Speeds are root mean "
                    "squares in the frame of the disc. The occupied share is the share of the "
                    "cross-section in which the density exceeds a tenth of that of a uniformly "
                    "spread charge. The rolling resistance cdt acts against the relative spin with "
                    "the effective radius; own-spin is eq. 11 of the paper, against the spin of "
                    "each ball with its own radius.")

friction = paper.campaign("friction")
friction_powder = paper.campaign("friction-powder")
regimes = paper.campaign("regimes")
speed_ratio_smooth = paper.campaign("speed-ratio-smooth")
speed_ratio = paper.campaign("speed-ratio")
speed_ratio_own_spin = paper.campaign("speed-ratio-own-spin")
number = paper.campaign("number")
diameter = paper.campaign("diameter")
speed = paper.campaign("speed")
time = paper.campaign("time")
height = paper.campaign("height")
volume = paper.campaign("volume")
mixer = paper.campaign("mixer")
law = paper.campaign("law")
size_speed = paper.campaign("size-speed")
size_powder = paper.campaign("size-powder")
powder = paper.campaign("powder")
material = paper.campaign("material")
material_own = paper.campaign("material-own")
friction_05 = paper.campaign("friction-05")
friction_02 = paper.campaign("friction-02")

paper.figure("6", "trajectories of the balls at friction 0.2 with rolling friction 0.05, and at 0.5 "
                  "with 0.5",
             friction.trajectories(at={"contact.rolling": "cdt"}),
             about="Three turns of the disc, in the frame of the disc; the outward direction points "
                   "to the right.")
paper.figure("6", "the same with the rolling resistance of eq. 11",
             friction.trajectories(at={"contact.rolling": "own-spin"}),
             about="Three turns of the disc, in the frame of the disc; the outward direction points "
                   "to the right.")
paper.figure("6", "balls and powder at the same two frictions, ball-to-powder ratio 70:1",
             friction_powder.snapshots(at={"contact.rolling": "cdt"}),
             about="Balls are red. Grains are green; grains faster than their root mean square "
                   "speed are yellow.")
paper.figure("6", "balls and powder with the rolling resistance of eq. 11",
             friction_powder.snapshots(at={"contact.rolling": "own-spin"}),
             about="Balls are red. Grains are green; grains faster than their root mean square "
                   "speed are yellow.")
paper.figure("7a", "trajectories of the balls, friction 0.2, ratio -2.5",
             regimes.trajectories(at={"contact.friction": 0.2, "mill.ratio": -2.5}),
             about="Three turns of the disc, in the frame of the disc; the outward direction points "
                   "to the right.")
paper.figure("7b, c", "trajectories of the balls, friction 0.5, ratios -2.5 and -6",
             regimes.trajectories(at={"contact.friction": 0.5, "mill.ratio": [-2.5, -6]}),
             about="Three turns of the disc, in the frame of the disc; the outward direction points "
                   "to the right.")
paper.figure("7", "share of the time in flight against the speed ratio",
             regimes.curve("flight_share", against="mill.ratio"))
paper.figure("8", "charge without friction, filling 20 % powder and 15 % balls",
             speed_ratio_smooth.snapshots(at={"powder.filling": "20 %"}),
             about="Balls are red. Grains are green; grains faster than their root mean square "
                   "speed are yellow. In the frame of the disc; the outward direction points to the "
                   "right. k is relative to the disc; in the laboratory it is larger by 1.")
paper.figure("8", "charge with friction 0.5, k relative to the disc, filling 20 % powder and 15 % balls",
             speed_ratio.snapshots(at={"mill.ratio_convention": "relative", "powder.filling": "20 %"}))
paper.figure("8", "the same with the rolling resistance of eq. 11",
             speed_ratio_own_spin.snapshots())
paper.figure("8", "charge with friction 0.5, k in the laboratory frame, filling 20 % powder and 15 "
                  "% balls",
             speed_ratio.snapshots(at={"mill.ratio_convention": "absolute", "powder.filling": "20 %"}))
paper.figure("8", "charge with friction 0.5, k relative to the disc, filling 15 % powder and 20 % balls",
             speed_ratio.snapshots(at={"mill.ratio_convention": "relative", "powder.filling": "15 %"}))
paper.figure("8", "speed of the charge against k, friction 0.5",
             speed_ratio.curve("ball_speed_seen_from_carrier", against="mill.ratio"))
paper.figure("8", "speed of the charge against k, friction 0.5, rolling resistance of eq. 11",
             speed_ratio_own_spin.curve("ball_speed_seen_from_carrier", against="mill.ratio"))
paper.figure("8", "speed of the charge against k relative to the disc, without friction",
             speed_ratio_smooth.curve("ball_speed_seen_from_carrier", against="mill.ratio"))
paper.figure("2.2", "power against the number of balls",
             number.curve("dissipated_power", against="balls.count"))
paper.figure("2.2", "power against the diameter of the balls",
             diameter.curve("dissipated_power", against="balls.diameter"))
paper.figure("2.2", "power against the speed of the disc",
             speed.curve("dissipated_power", against="mill.speed", law="power"))
paper.figure("2.2", "power against the milling time",
             time.curve("dissipated_power", against="run.time"))
paper.figure("2.2", "power against the height of the vial",
             height.curve("dissipated_power", against="jar.height"))
paper.figure("2.2", "power against the volume of the vial at the same shape",
             volume.curve("dissipated_power", against="jar.volume"))
paper.figure("2.2", "a mixer mill with the same vial and balls: power against its frequency",
             mixer.curve("dissipated_power", against="mill.frequency"))
paper.figure("2.2", "shock frequency against the speed of the disc",
             speed.curve("collision_rate_above_threshold", against="mill.speed", law="power"),
             about="Collisions per second with a normal speed of at least 0.1 m/s.")
paper.figure("2.2", "kinetic energy of a shock against the speed of the disc",
             speed.curve("energy_normal_mean_above_threshold", against="mill.speed", law="power"))
paper.figure("eq. 17", "power against the speed of the disc with two contact laws",
             law.curve("dissipated_power", against="mill.speed"),
             about="Hertz-Mindlin: eqs. 3 to 10. Adams impact: eqs. 17 to 23, corrected, with the "
                   "damping that gives the restitution.")
paper.figure("eq. 17", "kinetic energy of a shock with two contact laws",
             law.curve("energy_normal_mean_above_threshold", against="mill.speed"))
paper.figure("eq. 17", "trajectories of the balls with two contact laws, 400 rpm",
             law.trajectories(at={"mill.speed": "400 rpm"}),
             about="Three turns of the disc, in the frame of the disc; the outward direction points "
                   "to the right.")
paper.figure("abstract", "median size of the powder after two hours against the speed of the disc",
             size_speed.curve("d50", against="mill.speed", at={"grinding.time": "2 h"},
                              band_over=["breakage.f_mat", "breakage.x_w_min"]),
             about="The strength of the grains is a free choice: the band covers four sets of free "
                   "numbers. No value of the size is a prediction.")
paper.figure("abstract", "median size of the powder over the milling time, 400 rpm, ball-to-powder "
                         "ratio 70:1",
             size_speed.curve("d50", against="grinding.time", at={"mill.speed": "400 rpm"},
                              band_over=["breakage.f_mat", "breakage.x_w_min"]))
paper.figure("abstract", "median size of the powder after two hours against the ball-to-powder ratio",
             size_powder.curve("d50", against="powder.ball_to_powder", at={"grinding.time": "2 h"},
                               band_over=["breakage.f_mat", "breakage.x_w_min"]))
paper.figure("abstract", "impact efficiency against the speed of the disc",
             speed.curve("impact_efficiency", against="mill.speed"),
             about="Energy that hits at 0.1 m/s or more dissipate along the normal, over all "
                   "dissipated energy.")

paper.check("6", "the motion of the balls is very low at friction 0.2 and rolling friction 0.05; it "
                 "grows with both coefficients",
            friction.larger("ball_speed_seen_from_carrier", against="contact.friction", first=0.2,
                            second=0.5),
            why="balls with little friction slip and lag behind the wall; balls with more friction "
                "are lifted and thrown. With little friction there are two modes (README): balls "
                "that slide side by side in one place, and balls that fly")
paper.check("6", "with more friction the balls spread over a larger part of the vial",
            friction.larger("occupied_share", against="contact.friction", first=0.2, second=0.5),
            why="in some replicates with little friction the balls slide along the wall side by "
                "side and never leave it; this widens the interval")
paper.check("6", "with more friction balls and powder spread over a larger part of the vial",
            friction_powder.larger("occupied_share", against="contact.friction", first=0.2, second=0.5))
paper.check("6", "the tangential transfer of kinetic energy grows with friction (read as the "
                 "tangential energy of a hit)",
            friction.larger("energy_tangential_mean_above_threshold", against="contact.friction",
                            first=0.2, second=0.5),
            why="smooth balls slip on a wall that moves past them; rough balls move with the wall, "
                "so their tangential speed relative to it is lower")
paper.check("6", "the tangential transfer of kinetic energy grows with friction (read as the "
                 "tangential energy of all hits in a second)",
            friction.larger("tangential_impact_power", against="contact.friction", first=0.2,
                            second=0.5, at={"contact.rolling": "cdt"}),
            why="in the replicates whose balls fly, smooth balls slip at each hit; the hits of "
                "rough balls are slower")
paper.check("6", "the tangential transfer of kinetic energy grows with friction (read as the "
                 "tangential energy of all hits in a second, with the rolling resistance of eq. 11)",
            friction.larger("tangential_impact_power", against="contact.friction", first=0.2,
                            second=0.5, at={"contact.rolling": "own-spin"}))
paper.check("6", "the tangential transfer of kinetic energy grows with friction (read as the power "
                 "dissipated in the tangential direction)",
            friction.larger("dissipated_power_tangential", against="contact.friction", first=0.2,
                            second=0.5, at={"contact.rolling": "cdt"}),
            why="with little friction slip dissipates most of the power; balls that move with the "
                "wall slip less")
paper.check("6", "the tangential transfer of kinetic energy grows with friction (read as the power "
                 "dissipated in the tangential direction, with the rolling resistance of eq. 11)",
            friction.larger("dissipated_power_tangential", against="contact.friction", first=0.2,
                            second=0.5, at={"contact.rolling": "own-spin"}),
            why="eq. 11 brakes the spin of balls that turn with the vial; friction must keep them "
                "turning, and they slip. The verdict depends on the rolling resistance")
paper.check("6", "the tangential transfer of kinetic energy grows with friction (read as the power "
                 "that the vial transfers to the balls)",
            friction.larger("drawn_power", against="contact.friction", first=0.2, second=0.5),
            why="the claim holds in this reading; the wall also transfers power by normal forces")
paper.check("7a", "the motion is cascading: there are regions of higher occupancy, and the motion "
                  "is not random",
            regimes.regime("cascading", against="mill.ratio",
                           at={"contact.friction": 0.2, "mill.ratio": [-2, -2.5, -3]}),
            why="the regime is that of the mean over the replicates; in some of them the balls "
                "slide side by side in one place (figure 7a). At k = -1 most of them do, and the "
                "word is a matter of chance")
paper.check("7b", "the motion is cataracting: it crosses the whole vial",
            regimes.regime("cataracting", against="mill.ratio",
                           at={"contact.friction": 0.5, "mill.ratio": [-2, -2.5, -3]}),
            why="this also holds at the machine's own ratio of -2")
paper.check("7c", "the motion is rolling: at high vial speed the balls stick to the surface of the vial",
            regimes.regime("rolling", against="mill.ratio",
                           at={"contact.friction": 0.5, "mill.ratio": [-5, -6]}),
            why="above the critical ratio of 3.28 (kin.13) the rotation of the vial presses the "
                "balls on the wall more strongly than the disc pulls them off; the friction must "
                "also carry them along, which at friction 0.5 is certain from 4.40 on (kin.18)")
paper.check("8", "without friction, as in the paper, the ratio makes no visible difference to the "
                 "motion (read as the part of the vial that the charge occupies; a fifth counts as "
                 "visible)",
            speed_ratio_smooth.is_alike("occupied_share", against="mill.ratio", within=0.2),
            why="a smooth round wall does not transfer its rotation to the balls, so the motion "
                "does not depend on k in either convention")
paper.check("8", "without friction, as in the paper, the motion is cascading at k = -3 and at k = -1",
            speed_ratio_smooth.regime("cascading", against="mill.ratio",
                                      at={"mill.ratio": [-4, -3, -1]}),
            why="the charge lies on the side to which the disc throws it and hardly moves (figure "
                "8, speed of the charge). Our rule compares this speed with the speed of the wall, "
                "which grows with k: where the wall is fast the motion is called sliding. The "
                "motion itself is the same")
paper.check("8", "with friction 0.5 the ratio makes no visible difference to the motion",
            speed_ratio.is_alike("ball_speed_seen_from_carrier", against="mill.ratio", within=0.2),
            why="with friction k matters; the paper's conclusion about k depends on the omission of "
                "friction")
paper.check("8", "with friction 0.5 and the rolling resistance of eq. 11 the ratio makes no visible "
                 "difference to the motion",
            speed_ratio_own_spin.is_alike("ball_speed_seen_from_carrier", against="mill.ratio",
                                          within=0.2))
paper.check("8", "with friction 0.5 the motion is cascading at k = -3 and at k = -1",
            speed_ratio.regime("cascading", against="mill.ratio", at={"mill.ratio": [-3, -1]}),
            why="the wall lifts the charge and throws it; at k = -3 in the laboratory frame, -4 "
                "relative to the disc, the wall carries the charge round")
paper.check("8", "with friction 0.5 and the rolling resistance of eq. 11 the motion is cascading at "
                 "k = -3 and at k = -1",
            speed_ratio_own_spin.regime("cascading", against="mill.ratio", at={"mill.ratio": [-3, -1]}))
paper.check("end", "low speed ratios are the efficient ones (conclusions): the power is higher at k "
                   "= -1 than at k = -3",
            speed_ratio.larger("dissipated_power", against="mill.ratio", first=-3, second=-1,
                               at={"mill.ratio_convention": "relative"}),
            why="the power grows with |k| until the charge is pinned to the wall")
paper.check("end", "low speed ratios are the efficient ones (conclusions; read as the share of the "
                   "energy that hits dissipate along the normal)",
            regimes.larger("impact_efficiency", against="mill.ratio", first=-3, second=-1,
                           at={"contact.friction": 0.5}))
paper.check("abstract", "high speeds grind faster: the energy of a hit grows with the speed of the disc",
            speed.rises("energy_normal_mean_above_threshold", against="mill.speed"))
paper.check("abstract", "high speeds contribute to faster size reduction: the median size falls "
                        "with the speed of the disc (for each of four sets of free numbers after 10 "
                        "min, 2 h and 20 h)",
            size_speed.falls("d50", against="mill.speed"),
            why="more and stronger hits capture and break more powder, whatever the free numbers "
                "are; the sizes themselves are not predicted")
paper.check("abstract", "less powder remarkably improves milling: the energy per mass of powder "
                        "falls with the mass of powder",
            powder.falls("specific_energy_dose_rate", against="powder.filling"))
paper.check("abstract", "less powder remarkably improves milling: the median size is smaller at a "
                        "higher ball-to-powder ratio (for each of four sets of free numbers after "
                        "10 min, 2 h and 20 h)",
            size_powder.falls("d50", against="powder.ball_to_powder"),
            why="in this campaign the powder does not act on the balls: the same hits act on less "
                "powder")
paper.check("5", "after 20 h the average particle size is below 1 um",
            size_speed.below("1 um", "d50", at={"mill.speed": "400 rpm", "grinding.time": "20 h"}),
            why="the sets of free numbers were not fitted to this size; welding, which the paper "
                "sees in its micrograph, is left out")
paper.check("abstract", "balls of stainless steel are better: they dissipate more power than balls "
                        "of alumina (all with the paper's restitution and friction)",
            material.larger("dissipated_power", against="balls.material", first="alumina-99.5",
                            second="steel-mhadhbi-2021"),
            why="steel balls are twice as heavy; tungsten carbide would be better still")
paper.check("abstract", "balls of stainless steel are better: they dissipate more power than balls "
                        "of alumina (each with its own assumed restitution and friction)",
            material_own.larger("dissipated_power", against="balls.material", first="alumina-99.5",
                                second="steel-mhadhbi-2021"))
paper.check("abstract", "balls of stainless steel have a positive effect on the milling efficiency "
                        "(read as the share of the energy that hits dissipate along the normal, all "
                        "with the paper's restitution and friction)",
            material.larger("impact_efficiency", against="balls.material", first="alumina-99.5",
                            second="steel-mhadhbi-2021"),
            why="at the same restitution and friction the motion hardly depends on the density of "
                "the balls, and all powers grow with it alike")
paper.check("2.2", "the shock frequency grows with the speed of the disc",
            speed.rises("collision_rate_above_threshold", against="mill.speed"),
            own=True)
paper.check("2.2", "the power grows as the cube of the speed of the disc",
            speed.follows_power("dissipated_power", against="mill.speed", exponent=3, within=0.2),
            why="without gravity all speeds would scale with the speed of the disc, and the power "
                "with its cube; at 200 rpm the centrifugal acceleration of the disc is only three "
                "times gravity",
            own=True)
paper.check("2.2", "more balls dissipate more power",
            number.rises("dissipated_power", against="balls.count"),
            why="many balls of 15 mm obstruct each other and lie along the wall",
            own=True)
paper.check("2.2", "five larger balls dissipate more power",
            diameter.rises("dissipated_power", against="balls.diameter"),
            why="five balls of 15 mm are 6.6 times as heavy as five of 8 mm",
            own=True)
paper.check("2.2", "the power does not depend on the milling time",
            time.is_alike("dissipated_power", against="run.time", within=0.1),
            why="the charge no longer depends on its start after the half second that is not counted",
            own=True)
paper.check("2.2", "the height of the vial matters: five balls dissipate less power at 20 mm than "
                   "at 32.5 mm",
            height.smaller("dissipated_power", against="jar.height", first="32.5 mm", second="20 mm"),
            why="in a vial of 20 mm the balls of 15 mm lie in one layer and go round one behind the "
                "other; at 26 mm some replicates are pinned to the wall",
            own=True)
paper.check("2.2", "the power of five balls is largest in a vial between 45 and 125 ml of the same "
                   "shape",
            volume.largest_between("45 ml", "125 ml", "dissipated_power", against="jar.volume"),
            why="in a small vial the balls hold each other on the wall; in a wide one they lie on "
                "the outward side and slip, and hits are few",
            own=True)
paper.check("2.2", "the same balls and vial dissipate more power in the mixer mill at 30 Hz than in "
                   "the planetary mill at 400 rpm (4.2 W)",
            mixer.above("4.2 W", "dissipated_power", at={"mill.frequency": "30 Hz"}),
            why="the mixer mill reverses the vial 60 times a second, and its balls mostly fly and "
                "hit head-on. Its stroke of 9 mm is assumed, not measured",
            own=True)
paper.check("eq. 17", "the two contact laws of the paper give the same power",
            law.is_alike("dissipated_power", against="contact.law", within=0.1),
            why="both have the same restitution and friction; the shape of the force hardly matters "
                "for the motion",
            own=True)
paper.check("2.3", "after 20 h at 400 rpm the balls have dissipated at least fifty times the "
                   "formation enthalpy of TiC (3.08 kJ/g) per mass of powder",
            size_speed.above("154 kJ/g", "specific_energy_dose",
                             at={"mill.speed": "400 rpm", "grinding.time": "20 h",
                                 "breakage.f_mat": "0.1 kg/J/m", "breakage.x_w_min": "0 J m/kg"}),
            why="almost all of this energy becomes heat (README)",
            own=True)
paper.check("2.1.2", "the number of grains that a collision captures follows eqs. 12 to 16 (our "
                     "addition: it lies between the bounds that need no strength of the grains)",
            friction_05.captures_within_bounds(),
            own=True)

paper.table("captured-at-the-side", "Grains of 40 um that a ball captures at the side of the vial, "
                                    "friction 0.5",
            friction_05.captured("jar.side", against="capture.fracture_energy",
                                 energies=["1 uJ", "10 uJ", "100 uJ", "1 mJ", "10 mJ"],
                                 at={"powder.size": "40 um"}))
paper.table("captured-between-balls", "Grains of 40 um that two balls capture, friction 0.5",
            friction_05.captured("balls.1", against="capture.fracture_energy",
                                 energies=["1 uJ", "10 uJ", "100 uJ", "1 mJ", "10 mJ"],
                                 at={"powder.size": "40 um"}))
paper.table("captured-per-second", "Powder captured per second, friction 0.5",
            friction_05.table("captured_mass_rate", against="capture.fracture_energy"))
paper.table("captured-energy", "Energy per capture and mass of powder, friction 0.5",
            friction_05.table("captured_energy_mean", against="capture.fracture_energy"))
paper.table("captured-with-little-friction", "Powder captured per second, friction 0.2 and rolling "
                                             "friction 0.05",
            friction_02.table("captured_mass_rate", against="powder.size"))
