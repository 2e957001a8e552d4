# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="Flow of glass beads in a drum, by radioactive particle tracking",
              source="E. Alizadeh, O. Dubé, F. Bertrand and J. Chaouki, Characterization of mixing "
                     "and size segregation in a rotating drum by a particle tracking method, AIChE "
                     "J. 59 (2013) 1894-1905, doi 10.1002/aic.13982; points as digitised in the "
                     "repository of Lethe (chaos-polymtl/lethe, examples/dem/3d-rotating-drum)",
              about="A drum of 240 mm by 360 mm with 226080 beads of 3 mm turns at 11.6 rpm. One "
                    "tracer was followed; its mean velocity along the surface is known at 36 points "
                    "of the line through the axis, normal to the surface. We compute a slice of 15 "
                    "mm without ends. Friction and restitution were measured on other glass beads "
                    "of that size (LaMarche et al. 2022), so nothing is fitted. The repository's "
                    "own document gives the speed as 11.6 rad/s; its points and its script show "
                    "11.6 rpm.",
              licence="Apache-2.0 with LLVM exception or LGPL-2.1-or-later (repository of Lethe)",
              quick=False)

slice = paper.campaign("slice")

measured_surface_speed = paper.measured(
    "surface speed",
    source="mean of the four points nearest to the surface of depth_velocity",
    status="quoted",
    error_is="scatter of these points",
    values=[("0.323 m/s", "0.03 m/s")])
measured_bottom_of_the_layer = paper.measured(
    "bottom of the layer",
    source="zero of the velocity between the points at -58.66 and -60.12 mm",
    status="quoted",
    error_is="resolution of the averages, 6 mm wide: a third of it",
    values=[("59.4 mm", "2 mm")])
measured_shear_rate = paper.measured(
    "shear rate",
    source="slope of the points between -56 and -30 mm",
    status="quoted",
    error_is="scatter of the points",
    values=[("11.6 1/s", "1.5 1/s")])
measured_slope = paper.measured(
    "slope",
    source="27 degrees, which the script of the repository cites from the article",
    status="quoted",
    error_is="last stated digit",
    values=[("27 deg", "1 deg")])

paper.check("depth", "speed of the beads at the surface",
            slice.agrees_with(measured_surface_speed, "surface_speed"),
            why="two short replicates leave a wide interval")
paper.check("depth", "distance from the axis at which the velocity vanishes",
            slice.agrees_with(measured_bottom_of_the_layer, "surface_layer_bottom"))
paper.check("depth", "shear rate of the layer that flows down",
            slice.agrees_with(measured_shear_rate, "surface_shear_rate"))
paper.check("depth", "slope of the surface",
            slice.agrees_with(measured_slope, "bed_angle"),
            why="two degrees too flat: the ends of the real drum lift the bed, and real beads are "
                "less round than spheres")
