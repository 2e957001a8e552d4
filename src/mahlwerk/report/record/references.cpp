// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/record/references.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace mahlwerk::report {
namespace {

constexpr auto article = Reference::Kind::article, book = Reference::Kind::book,
               chapter = Reference::Kind::chapter;

/// Of entries whose title could not be compared with a catalogue of publications.
constexpr const char* unconfirmed =
    "Title not confirmed by a second source; check it before you print it";

// The columns are those of Reference. A DOI stands only where another source gave the same one.
// clang-format off
const std::vector<Reference> bibliography{
{"ai2011", article, "Ai, J. and Chen, J.-F. and Rotter, J. M. and Ooi, J. Y.",
 "Assessment of rolling resistance models in discrete element simulations",
 "Powder Technology", 2011, "206", "269-282", "10.1016/j.powtec.2010.09.030"},
{"andersen2017", article, "Andersen, J. M. and Mack, J.",
 "Decoupling the Arrhenius equation via mechanochemistry",
 "Chemical Science", 2017, "8", "5447", "10.1039/C7SC00538E"},
{"archard1953", article, "Archard, J. F.",
 "Contact and rubbing of flat surfaces",
 "Journal of Applied Physics", 1953, "24", "981-988", "10.1063/1.1721448"},
{"austin1971", article, "Austin, L. G.",
 "Introduction to the mathematical description of grinding as a rate process",
 "Powder Technology", 1971, "5", "1-17", "10.1016/0032-5910(71)80064-5"},
{"bannerman2014", article, "Bannerman, M. N. and Strobl, S. and Formella, A. and Pöschel, T.",
 "Stable algorithm for event detection in event-driven particle dynamics",
 "Computational Particle Mechanics", 2014, "1", "191-198", "10.1007/s40571-014-0021-8"},
{"barnocky1988", article, "Barnocky, G. and Davis, R. H.",
 "Elastohydrodynamic collision and rebound of spheres: Experimental verification",
 "Physics of Fluids", 1988, "31", "1324", "", unconfirmed},
{"barrios2011", article, "Barrios, G. K. P. and de Carvalho, R. M. and Tavares, L. M.",
 "Modeling breakage of monodispersed particles in unconfined beds",
 "Minerals Engineering", 2011, "24", "308", "", unconfirmed},
{"bond1961", article, "Bond, F. C.",
 "Crushing and grinding calculations",
 "British Chemical Engineering", 1961, "6", "378-385, 543-548", "", unconfirmed},
{"burgio1991", article, "Burgio, N. and Iasonna, A. and Magini, M. and Martelli, S. and Padella, F.",
 "Mechanical alloying of the Fe-Zr system. Correlation between input energy and end products",
 "Il Nuovo Cimento D", 1991, "13", "459-476", "10.1007/BF02452130"},
{"carslaw1959", book, "Carslaw, H. S. and Jaeger, J. C.",
 "Conduction of Heat in Solids", "Oxford University Press", 1959},
{"chen2016", article, "Chen, K. and Nguyen, H. B. and Wu, D. and Liu, F.",
 "Quantitative study of the milling parameters in vibratory milling",
 "Journal of Tsinghua University (Science and Technology)", 2016, "56", "328-333",
 "10.16511/j.cnki.qhdxxb.2016.21.030", "In Chinese; the title is a translation"},
{"colacino2018", article,
 "Colacino, E. and Carta, M. and Pia, G. and Porcheddu, A. and Ricci, P. C. and Delogu, F.",
 "Processing and investigation methods in mechanochemical kinetics",
 "ACS Omega", 2018, "3", "9196-9209"},
{"cundall1979", article, "Cundall, P. A. and Strack, O. D. L.",
 "A discrete numerical model for granular assemblies",
 "Géotechnique", 1979, "29", "47-65", "10.1680/geot.1979.29.1.47"},
{"davis1986", article, "Davis, R. H. and Serayssol, J.-M. and Hinch, E. J.",
 "The elastohydrodynamic collision of two spheres",
 "Journal of Fluid Mechanics", 1986, "163", "479", "", unconfirmed},
{"dormand1980", article, "Dormand, J. R. and Prince, P. J.",
 "A family of embedded Runge-Kutta formulae",
 "Journal of Computational and Applied Mathematics", 1980, "6", "19-26",
 "10.1016/0771-050X(80)90013-3"},
{"finnie1960", article, "Finnie, I.",
 "Erosion of surfaces by solid particles", "Wear", 1960, "3", "87"},
{"foerster1994", article, "Foerster, S. F. and Louge, M. Y. and Chang, H. and Allia, K.",
 "Measurements of the collision properties of small spheres",
 "Physics of Fluids", 1994, "6", "1108-1115"},
{"hogg1972", article, "Hogg, R. and Fuerstenau, D. W.",
 "Power relationships for tumbling mills",
 "Transactions of the Society of Mining Engineers of AIME", 1972, "252", "418-423", "", unconfirmed},
{"johnson1971", article, "Johnson, K. L. and Kendall, K. and Roberts, A. D.",
 "Surface energy and the contact of elastic solids",
 "Proceedings of the Royal Society of London A", 1971, "324", "301-313",
 "10.1098/rspa.1971.0141"},
{"king2001", book, "King, R. P.",
 "Modeling and Simulation of Mineral Processing Systems", "Butterworth-Heinemann", 2001},
{"kloss2012", article,
 "Kloss, C. and Goniva, C. and Hager, A. and Amberger, S. and Pirker, S.",
 "Models, algorithms and validation for opensource DEM and CFD-DEM",
 "Progress in Computational Fluid Dynamics", 2012, "12", "140-152",
 "10.1504/PCFD.2012.047457"},
{"lacey1954", article, "Lacey, P. M. C.",
 "Developments in the theory of particle mixing",
 "Journal of Applied Chemistry", 1954, "4", "257-268", "", unconfirmed},
{"lian1993", article, "Lian, G. and Thornton, C. and Adams, M. J.",
 "A theoretical study of the liquid bridge forces between two rigid spherical bodies",
 "Journal of Colloid and Interface Science", 1993, "161", "138-147"},
{"lubachevsky1991", article, "Lubachevsky, B. D.",
 "How to simulate billiards and similar systems",
 "Journal of Computational Physics", 1991, "94", "255-283", "10.1016/0021-9991(91)90222-7"},
{"luding1998", article, "Luding, S. and McNamara, S.",
 "How to handle the inelastic collapse of a dissipative hard-sphere gas with the TC model",
 "Granular Matter", 1998, "1", "113-128", "10.1007/s100350050017"},
{"luding2008", article, "Luding, S.",
 "Cohesive, frictional powders: contact models for tension",
 "Granular Matter", 2008, "10", "235-246", "10.1007/s10035-008-0099-x"},
{"magini1996", article, "Magini, M. and Iasonna, A. and Padella, F.",
 "Ball milling: an experimental support to the energy transfer evaluated by the collision model",
 "Scripta Materialia", 1996, "34", "13", "", unconfirmed},
{"marshall2009", article, "Marshall, J. S.",
 "Discrete-element modeling of particulate aerosol flows",
 "Journal of Computational Physics", 2009, "228", "1541-1561"},
{"maurice1990", article, "Maurice, D. R. and Courtney, T. H.",
 "The physics of mechanical alloying: A first report",
 "Metallurgical Transactions A", 1990, "21", "289", "", unconfirmed},
{"mellmann2001", article, "Mellmann, J.",
 "The transverse motion of solids in rotating cylinders: forms of motion and transition behavior",
 "Powder Technology", 2001, "118", "251-270", "10.1016/S0032-5910(00)00402-2"},
{"mhadhbi2021", article, "Mhadhbi, M.",
 "Modelling of the High-Energy Ball Milling Process",
 "Advances in Materials Physics and Chemistry", 2021, "11", "31-44", "10.4236/ampc.2021.111004"},
{"mindlin1949", article, "Mindlin, R. D.",
 "Compliance of elastic bodies in contact",
 "Journal of Applied Mechanics", 1949, "16", "259-268", "10.1115/1.4009973"},
{"mindlin1953", article, "Mindlin, R. D. and Deresiewicz, H.",
 "Elastic spheres in contact under varying oblique forces",
 "Journal of Applied Mechanics", 1953, "20", "327-344", "10.1115/1.4010702"},
{"napiermunn1996", book, "Napier-Munn, T. J. and Morrell, S. and Morrison, R. D. and Kojovic, T.",
 "Mineral Comminution Circuits: Their Operation and Optimisation",
 "Julius Kruttschnitt Mineral Research Centre", 1996, "", "", "", unconfirmed},
{"ramirez1999", article, "Ramírez, R. and Pöschel, T. and Brilliantov, N. V. and Schwager, T.",
 "Coefficient of restitution of colliding viscoelastic spheres",
 "Physical Review E", 1999, "60", "4465", "10.1103/PhysRevE.60.4465"},
{"reid1965", article, "Reid, K. J.",
 "A solution to the batch grinding equation",
 "Chemical Engineering Science", 1965, "20", "953-963", "10.1016/0009-2509(65)80093-8"},
{"rosenkranz2011", article, "Rosenkranz, S. and Breitung-Faes, S. and Kwade, A.",
 "Experimental investigations and modelling of the ball motion in planetary ball mills",
 "Powder Technology", 2011, "212", "224-230"},
{"schaffer1991", article, "Schaffer, G. B. and McCormick, P. G.",
 "Anomalous combustion effects during mechanical alloying",
 "Metallurgical Transactions A", 1991, "22"},
{"schiller1933", article, "Schiller, L. and Naumann, A.",
 "Über die grundlegenden Berechnungen bei der Schwerkraftaufbereitung",
 "Zeitschrift des Vereines Deutscher Ingenieure", 1933, "77", "", "", unconfirmed},
{"shi2007", article, "Shi, F. and Kojovic, T.",
 "Validation of a model for impact breakage incorporating particle size effect",
 "International Journal of Mineral Processing", 2007, "82", "156", "", unconfirmed},
{"takacs2002", article, "Takacs, L.",
 "Self-sustaining reactions induced by ball milling",
 "Progress in Materials Science", 2002, "47", "355-414", "10.1016/S0079-6425(01)00002-0"},
{"tavares2009", article, "Tavares, L. M.",
 "Analysis of particle fracture by repeated stressing as damage accumulation",
 "Powder Technology", 2009, "190", "327-339", "10.1016/j.powtec.2008.08.011"},
{"thompson2022", article, "Thompson, A. P. and others",
 "LAMMPS - a flexible simulation tool for particle-based materials modeling at the atomic, meso, "
 "and continuum scales",
 "Computer Physics Communications", 2022, "271", "108171", "10.1016/j.cpc.2021.108171"},
{"thornton1991", article, "Thornton, C. and Yin, K. K.",
 "Impact of elastic spheres with and without adhesion",
 "Powder Technology", 1991, "65", "153", "", unconfirmed},
{"thornton1997", article, "Thornton, C.",
 "Coefficient of restitution for collinear collisions of elastic-perfectly plastic spheres",
 "Journal of Applied Mechanics", 1997, "64", "383"},
{"thornton1998", article, "Thornton, C. and Ning, Z.",
 "A theoretical model for the stick/bounce behaviour of adhesive, elastic-plastic spheres",
 "Powder Technology", 1998, "99", "154", "10.1016/S0032-5910(98)00099-0"},
{"tsuji1992", article, "Tsuji, Y. and Tanaka, T. and Ishida, T.",
 "Lagrangian numerical simulation of plug flow of cohesionless particles in a horizontal pipe",
 "Powder Technology", 1992, "71", "239-250", "10.1016/0032-5910(92)88030-L"},
{"vogel2003", article, "Vogel, L. and Peukert, W.",
 "Breakage behaviour of different materials - construction of a mastercurve for the breakage "
 "probability",
 "Powder Technology", 2003, "129", "101-110"},
{"walton1986", article, "Walton, O. R. and Braun, R. L.",
 "Viscosity, granular-temperature, and stress calculations for shearing assemblies of inelastic, "
 "frictional disks",
 "Journal of Rheology", 1986, "30", "949", "10.1122/1.549893"},
{"walton1993", chapter, "Walton, O. R.",
 "Numerical simulation of inelastic, frictional particle-particle interactions",
 "Particulate Two-Phase Flow", 1993, "", "", "", unconfirmed},
{"white1997", article, "White, K. P.",
 "An effective truncation heuristic for bias reduction in simulation output",
 "Simulation", 1997, "69", "323-334", "10.1177/003754979706900601"},
{"willett2000", article,
 "Willett, C. D. and Adams, M. J. and Johnson, S. A. and Seville, J. P. K.",
 "Capillary bridges between two spherical bodies",
 "Langmuir", 2000, "16", "9396", "10.1021/la000657y"},
{"ziff1985", article, "Ziff, R. M. and McGrady, E. D.",
 "The kinetics of cluster fragmentation and depolymerisation",
 "Journal of Physics A", 1985, "18", "3027", "10.1088/0305-4470/18/15/026"},
};
// clang-format on

}  // namespace

const std::vector<Reference>& references() {
  return bibliography;
}

const Reference& reference(std::string_view key) {
  const auto found = std::ranges::lower_bound(bibliography, key, {}, &Reference::key);
  if (found == bibliography.end() || found->key != key)
    throw std::out_of_range(fmt::format("the bibliography has no {}", key));
  return *found;
}

Reference program_reference(std::string_view version) {
  return {.key = "mahlwerk",
          .kind = Reference::Kind::other,
          .authors = "{The Mahlwerk authors}",
          .title = "Mahlwerk: an open simulator of ball mills",
          .published = fmt::format("Computer program, version {}", version)};
}

}  // namespace mahlwerk::report
