// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::results {

/// Meaning of a half-width.
enum class Interval {
  of_mean,  ///< the mean of endless replicates lies within it (sta.1)
  of_draw   ///< the value with the true parameters lies within it, if replicates have draws (cal.9)
};
/// of_draw for a case with [uncertainty].
Interval interval_of(const cases::Case& mill_case);

/// The half-width of an interval, or 0 where it is no more than the rounding of the value.
double above_rounding_of(double value, double half_width);

/// Sets a quantity's mean and its half-width. Values that are not finite, as of a replicate without
/// collisions, are left out.
void combine(Quantity& q, const std::vector<double>& values, Interval interval);

/// Means of all quantities over the replicates with these `numbers`, from 1. `each` holds the
/// values of every replicate.
std::vector<Quantity> means(const std::vector<Measure>& measures,
                            const std::vector<std::vector<double>>& each,
                            const std::vector<std::size_t>& numbers, Interval interval);

}  // namespace mahlwerk::results
