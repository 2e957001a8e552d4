// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "mahlwerk/results/outcome.hpp"

// Definitions of summary quantities, each computed from a case and one of its replicates.
namespace mahlwerk::results {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

struct Measure {
  std::string name, unit, about;
  double (*compute)(const cases::Case&, const Replicate&);
  bool worst = false;  ///< the summary has the largest value over replicates instead of the mean
};

/// All quantities that each replicate of a case has, in the order of summary.json.
std::vector<Measure> measures(const cases::Case& mill_case);

inline double share(double part, double whole) {
  return whole > 0 ? part / whole : undefined;
}

/// Change of a member of the energy balance per second of counted time.
inline double per_time(const Replicate& r, double scene::EnergyBalance::*what) {
  return share(r.energy_balance.*what - r.at_settled.*what, r.time());
}

inline double dissipated_power(const Replicate& r) {
  return share(r.energy_balance.lost() - r.at_settled.lost(), r.time());
}

inline double count_of_balls(const cases::Case& c) {
  double all = 0;
  for (const cases::BallSet& set : c.balls) all += static_cast<double>(set.count);
  return all;
}

}  // namespace mahlwerk::results
