// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "mahlwerk/results/quantities/groups.hpp"

namespace mahlwerk::results {
namespace {

using scene::EnergyBalance;

double energy_balance(const cases::Case&, const Replicate& r) {
  const EnergyBalance& a = r.energy_balance;
  const double scale = std::abs(a.wall_work) + std::abs(a.lost()) + std::abs(a.initial_energy);
  const double residual = std::abs(a.residual());
  return residual == 0 ? 0 : residual / scale;
}

double ratio(const cases::Case& c) {
  return *c.powder->grain_size / *c.powder->size;  // (chg.9)
}

}  // namespace

Measures grain_measures() {
  const auto powder_as_grains = [](const cases::Case& c) {
    return c.powder && c.powder->grain_size;
  };
  const auto of_known_size = [](const cases::Case& c) { return c.powder->size.has_value(); };
  return where(
      powder_as_grains, "with powder as grains",
      {
          {"grain_count",
           "1",
           "spheres that represent the powder",
           [](const cases::Case& c, const Replicate&) {
             return static_cast<double>(c.balls.back().count);
           },
           {.heading = "Powder as grains", .worst = true}},
          {"coarse_graining_ratio",
           "1",
           "size of a grain over the powder's size",
           [](const cases::Case& c, const Replicate&) { return ratio(c); },
           {.worst = true, .applies = of_known_size, .only = "of a given size"}},
          {"particles_per_grain",
           "1",
           "particles of the powder that each grain represents",
           [](const cases::Case& c, const Replicate&) { return ratio(c) * ratio(c) * ratio(c); },
           {.worst = true, .applies = of_known_size, .only = "of a given size"}},
      });
}

Measures check_measures() {
  return {
      {"energy_residual",
       "1",
       "largest relative residual of one collision's energy balance, over all replicates",
       [](const cases::Case&, const Replicate& r) { return r.energy_balance.worst_collision; },
       {.label = "worst collision residual",
        .heading = "Numerical accuracy",
        .worst = true,
        .applies = knows_losses,
        .only = not_in_lammps}},
      {"energy_balance",
       "1",
       "residual of a whole run's energy balance over wall work + losses + energy at the start, "
       "in the worst replicate",
       energy_balance,
       {.label = "energy balance residual",
        .worst = true,
        .applies = knows_losses,
        .only = not_in_lammps}},
      {"deepest_overlap",
       "1",
       "deepest overlap of two colliding bodies over the ball's radius, over all replicates",
       [](const cases::Case&, const Replicate& r) { return r.energy_balance.deepest_overlap; },
       {.label = "deepest overlap over radius", .worst = true}},
      {"simulated_time", "s", "counted time of one replicate",
       [](const cases::Case&, const Replicate& r) { return r.time(); }},
  };
}

const Measures& measures_of_whole() {
  static const Measures list{
      {"settling_time", "s",
       "initial transient within the counted time, by the dissipated power (MSER-5)", nullptr},
      {"replicates", "1", "number of independent replicates in the means", nullptr},
  };
  return list;
}

}  // namespace mahlwerk::results
