// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/parts/flow/flow_record.hpp"

namespace mahlwerk::parts::flow {

/// The distribution of residence times, by the product-limit estimate of Kaplan and Meier from
/// balls that have left and balls that are still inside (flo.6).
struct ResidenceTimes {
  struct Step {
    double time = 0;    ///< [s] since the entry
    double inside = 1;  ///< [1] share that is still inside from then on
  };
  std::vector<Step> steps;  ///< where balls left; the first at time 0
  double longest = 0;       ///< [s] that a ball was followed
  /// Mean and standard deviation [s] (flo.7); NaN where more than a twentieth tracers longer than
  /// any ball was followed.
  double mean = 0, spread = 0;
};
ResidenceTimes residence_times(std::vector<Tracer> tracers);

}  // namespace mahlwerk::parts::flow
