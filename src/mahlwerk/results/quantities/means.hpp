// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::results {

/// Sets a quantity's mean and its half-width. Values that are not finite, as of a replicate without
/// collisions, are left out.
void combine(Quantity& q, const std::vector<double>& values);

/// Means of all quantities over the replicates with these `numbers`, from 1. `each` holds the
/// values of every replicate.
std::vector<Quantity> means(const std::vector<Measure>& measures,
                            const std::vector<std::vector<double>>& each,
                            const std::vector<std::size_t>& numbers);

}  // namespace mahlwerk::results
