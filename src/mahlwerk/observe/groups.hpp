// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace mahlwerk::observe {

/// Values that fall into two groups.
struct TwoGroups {
  double between = 0;  ///< values of the lower group are below, those of the upper one above
  double p_value = 1;  ///< that a sample of one normal distribution is split as sharply (sta.7)
};

/// Fewer values never show two groups.
constexpr std::size_t fewest_for_groups = 4;

/// Two groups, if one normal distribution splits as sharply with a chance of `level` at most;
/// nothing for fewer than four values. The same for the same values in any order.
std::optional<TwoGroups> two_groups(std::vector<double> values, double level = 0.01);

}  // namespace mahlwerk::observe
