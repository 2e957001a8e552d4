# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
from mahlwerk.papers import Paper

paper = Paper(title="Random packings of cylinders, cubes and spherocylinders",
              source="J. Baker and A. Kudrolli, Maximum and minimum stable random packings of Platonic "
                     "solids, Phys. Rev. E 82 (2010) 061304, arXiv:1008.1728; S. Li, J. Zhao, P. Lu and Y. Xie, "
                     "Maximum packing densities of basic 3D objects, Chin. Sci. Bull. 55 (2010) 114, doi "
                     "10.1007/s11434-009-0650-0; disordered jammed packings of hard spherocylinders, "
                     "PMC10405222 (2023)",
              about="Baker and Kudrolli fluidised plastic dice and let them settle (loose), or vibrated them "
                    "(dense). The other two are packings by computer of frictionless bodies, as dense as their "
                    "methods make them without order. We let bodies settle from random places in a trough "
                    "without ends, with friction and without, and measure far from the wall.",
              licence="packing fractions, cited as facts",
              quick=False)

sphere = paper.campaign("sphere")
spherocylinder = paper.campaign("spherocylinder")
cylinder = paper.campaign("cylinder")
cube = paper.campaign("cube")

SMOOTH = {"contact.friction": 0}

densest_sphere = paper.measured(
    "random close packing of spheres", source="abstract of Li et al.: 0.64", status="verified",
    error_is="last stated digit", values=[("0.64", "0.01")])
densest_spherocylinder = paper.measured(
    "disordered jammed packing of spherocylinders of L/D = 0.45",
    source="abstract of PMC10405222: 0.721 +- 0.001, the largest of all L/D", status="verified",
    error_is="stated", values=[("0.721", "0.001")])
densest_cylinder = paper.measured(
    "random packing of cylinders", source="abstract of Li et al.: 0.72, at a height of 0.9 diameters",
    status="verified", error_is="last stated digit", values=[("0.72", "0.01")])

paper.check("1", "frictionless spheres: 0.64 (Li et al. 2010)",
            sphere.agrees_with(densest_sphere, "packing_fraction", at=SMOOTH))
paper.check("2", "frictionless spherocylinders of L/D = 0.45: 0.721 (2023)",
            spherocylinder.agrees_with(densest_spherocylinder, "packing_fraction"))
paper.check("3", "frictionless equilateral cylinders: 0.72 (Li et al. 2010)",
            cylinder.agrees_with(densest_cylinder, "packing_fraction", at=SMOOTH))
paper.check("4", "cubes with friction are denser than dice that were fluidised, 0.54 +- 0.01 (Baker and Kudrolli 2010)",
            cube.above("0.53", "packing_fraction"))
paper.check("4", "and looser than dice that were vibrated, 0.67 +- 0.01",
            cube.below("0.68", "packing_fraction"))
paper.check("5", "friction makes cylinders looser",
            cylinder.falls("packing_fraction", against="contact.friction"), own=True)
