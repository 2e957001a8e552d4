// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/campaign/sweep/sensitivity.hpp"

// Outcomes by formula, with noise.
namespace mahlwerk::campaign {

using Values = std::vector<double>;
using Function = std::function<double(const Values&)>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

inline double normal(Random& random) {
  const double size = std::sqrt(-2 * std::log(random.uniform()));
  return size * std::cos(random.uniform(0, 2 * std::numbers::pi));
}

inline Values outcomes(const DesignMatrix& rows, const Function& f) {
  Values y;
  for (const Values& row : rows) y.push_back(f(row));
  return y;
}

inline double half_width(const observe::IntervalEstimate& s) {
  return std::max(s.high - s.value, s.value - s.low);
}

}  // namespace mahlwerk::campaign
