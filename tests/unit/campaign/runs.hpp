// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/campaign/run/run.hpp"

namespace mahlwerk::campaign {

inline RunOptions on(int threads) {
  RunOptions options;
  options.threads = threads;
  return options;
}

/// [W] Dissipated power of each replicate.
inline std::vector<double> powers(const results::Outcome& outcome) {
  std::vector<double> made;
  for (const results::Replicate& r : outcome.replicates)
    made.push_back(results::value_of(outcome, r, "dissipated_power"));
  return made;
}

}  // namespace mahlwerk::campaign
