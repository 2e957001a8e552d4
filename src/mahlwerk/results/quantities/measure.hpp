// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/quantities/traits.hpp"

// The register of quantities. Each is one record: what it is, how it is shown, and its function of
// a case and one of its replicates.
namespace mahlwerk::results {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// The record of a quantity: all that files, tables, pages and axes need to know of it.
struct Measure {
  std::string name, unit, about;
  double (*compute)(const cases::Case&, const Replicate&);  ///< in one replicate
  QuantityTraits traits = {};
  bool (*group_applies)(const cases::Case&) = nullptr;  ///< as traits.applies, of its group
  std::string_view group_only = {};                     ///< as traits.only, of its group
};

using Measures = std::vector<Measure>;

/// The records, which only some cases have: those for which `applies` is true, in words `only`.
Measures where(bool (*applies)(const cases::Case&), std::string_view only, Measures list);

/// Whether an engine of ours computed the run, which knows what each collision loses. LAMMPS tells
/// what a charge loses as the rest of its energy balance, and gives a collision the loss of an
/// undisturbed one.
inline bool knows_losses(const cases::Case& c) {
  return c.run.engine != cases::EngineName::lammps;
}
constexpr std::string_view not_in_lammps = "not with `engine = \"lammps\"`";

/// The records of all quantities that each replicate may have, in the order of summary.json.
const Measures& all_measures();

/// The records of quantities of all replicates together, which summarise() computes.
const Measures& measures_of_whole();

/// The record of that name, or null.
const Measure* record_of(std::string_view quantity);

/// The records of `list` that the case has, with its descriptions.
Measures applying(const Measures& list, const cases::Case& mill_case);
/// All quantities that each replicate of a case has, in the order of summary.json.
inline Measures measures(const cases::Case& mill_case) {
  return applying(all_measures(), mill_case);
}

inline double share(double part, double whole) {
  return whole > 0 ? part / whole : undefined;
}

/// Change of a member of the energy balance per second of counted time.
inline double per_time(const Replicate& r, double scene::EnergyBalance::*what) {
  return share(r.energy_balance.*what - r.at_settled.*what, r.time());
}

/// An energy [J] of the balance; 0 where it is no more than the rounding of the sums: collisions
/// without dissipation lose 1e-16 of their energy or gain it.
inline double above_rounding(const Replicate& r, double energy) {
  constexpr double rounding = 1e-12;
  const scene::EnergyBalance& now = r.energy_balance;
  const double turned_over = now.kinetic + std::abs(now.initial_energy) + std::abs(now.wall_work);
  return std::abs(energy) < rounding * turned_over ? 0 : energy;
}

inline double dissipated_power(const Replicate& r) {
  return share(above_rounding(r, r.energy_balance.lost() - r.at_settled.lost()), r.time());
}

inline double count_of_balls(const cases::Case& c) {
  double all = 0;
  for (const cases::BallSet& set : c.balls) all += static_cast<double>(set.count);
  return all;
}

}  // namespace mahlwerk::results
