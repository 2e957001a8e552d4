// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "mahlwerk/results/outcome.hpp"

// How quantities of a summary are made: each from a case and one replicate of it.
namespace mahlwerk::results {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

struct Measure {
  std::string name, unit, about;
  double (*compute)(const cases::Case&, const Replicate&);
  bool worst = false;  ///< over replicates: the largest instead of the mean
};

/// All that each replicate of a case has, in the order of summary.json.
std::vector<Measure> measures(const cases::Case& what);

inline double share(double part, double whole) {
  return whole > 0 ? part / whole : undefined;
}

/// Of an account's number, how much a second of the counted time.
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
