# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="Slope of the bed in a small rotary kiln",
              source="Solid-liquid rotary kilns: an experimental and CFD-DEM study, Powder Technol. "
                     "(2023), pii S003259102300791X, as used in the repository of Lethe "
                     "(chaos-polymtl/lethe, examples/dem/3d-rotating-drum-calibration)",
              about="A drum of 138 mm by 185 mm with 6000 spheres of 5.95 mm turns at 2.198 rad/s. "
                    "The slope was measured. Lethe's authors then fitted friction and rolling "
                    "friction to it, so our run with their numbers compares two codes; the band "
                    "over wide ranges is the prediction.",
              licence="Apache-2.0 with LLVM exception or LGPL-2.1-or-later (repository of Lethe)",
              quick=False)

slope = paper.campaign("slope")
fitted = paper.campaign("fitted")

measured_slope = paper.measured(
    "slope",
    source="README of the example: measured angle of repose of 26 degrees",
    status="quoted",
    error_is="last stated digit",
    values=[("26 deg", "1 deg")])

paper.check("1", "slope of the bed",
            slope.agrees_with(measured_slope, "bed_angle"),
            why="we are wrong: even with the lowest friction the bed is steeper than measured. Both "
                "ends of this short drum turn with it and lift the bed; the source does not say how "
                "smooth they are, nor how the angle was read")
paper.check("1", "slope of the bed, with the friction of 0.3 and rolling friction of 0.02 that were "
                 "fitted to it with another code",
            fitted.agrees_with(measured_slope, "bed_angle"),
            why="the other code has other wall contacts and reads the angle from the surface near "
                "the middle of the bed; our number is the slope of the line from the axis to the "
                "centre of mass")
