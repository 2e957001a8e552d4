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

std::vector<Measure> grain_measures(const cases::Case& mill_case) {
  if (!mill_case.powder || !mill_case.powder->grain_size) return {};
  std::vector<Measure> list{
      {"grain_count", "1", "spheres that represent the powder",
       [](const cases::Case& c, const Replicate&) {
         return static_cast<double>(c.balls.back().count);
       },
       true},
      {"coarse_graining_ratio", "1", "size of a grain over the powder's size",
       [](const cases::Case& c, const Replicate&) { return ratio(c); }, true},
      {"particles_per_grain", "1", "particles of the powder that each grain represents",
       [](const cases::Case& c, const Replicate&) { return ratio(c) * ratio(c) * ratio(c); }, true},
  };
  if (!mill_case.powder->size) list.resize(1);
  return list;
}

std::vector<Measure> check_measures() {
  return {
      {"energy_residual", "1",
       "largest relative residual of one collision's energy balance, over all replicates",
       [](const cases::Case&, const Replicate& r) { return r.energy_balance.worst_collision; },
       true},
      {"energy_balance", "1",
       "residual of a whole run's energy balance over wall work + losses + energy at the start, "
       "in the worst replicate",
       energy_balance, true},
      {"deepest_overlap", "1",
       "deepest overlap of two colliding bodies over the ball's radius, over all replicates",
       [](const cases::Case&, const Replicate& r) { return r.energy_balance.deepest_overlap; },
       true},
      {"simulated_time", "s", "counted time of one replicate",
       [](const cases::Case&, const Replicate& r) { return r.time(); }},
  };
}

}  // namespace mahlwerk::results
