// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace mahlwerk::observe {

/// Values that fall into two groups.
struct TwoGroups {
  double between = 0;  ///< value between the lower and the upper group
  double p_value = 1;  ///< of the test that the values are from one normal distribution (sta.7)
};

/// Least number of values that can show two groups.
constexpr std::size_t fewest_for_groups = 4;

/// The two groups of `values`, if samples of one normal distribution split as sharply with a
/// probability of at most `level`; nothing otherwise, and for fewer than four values. Independent
/// of the order of values.
std::optional<TwoGroups> two_groups(std::vector<double> values, double level = 0.01);

}  // namespace mahlwerk::observe
