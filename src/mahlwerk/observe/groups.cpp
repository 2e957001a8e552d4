// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/groups.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/random.hpp"

namespace mahlwerk::observe {
namespace {

/// The sharpest split of sorted values.
struct Split {
  std::size_t low = 0;  ///< values in the lower group
  double rest = 1;      ///< [1] squares within the groups over all squares (sta.6)
};

/// Finds the sharpest split. Uses deviations from the overall mean to avoid cancellation.
Split sharpest(const std::vector<double>& sorted) {
  const auto n = static_cast<double>(sorted.size());
  double mean = 0;
  for (const double v : sorted) mean += (v - sorted.front()) / n;
  mean += sorted.front();
  double squares = 0;
  for (const double v : sorted) squares += (v - mean) * (v - mean);
  Split best;
  double below = 0;  // sum of deviations of the lower group from the overall mean
  for (std::size_t k = 1; k < sorted.size(); ++k) {
    below += sorted[k - 1] - mean;
    const auto low = static_cast<double>(k);
    const double between = below * below * n / (low * (n - low));
    if (const double rest = std::max(0.0, 1 - between / squares); rest < best.rest)
      best = {k, rest};
  }
  return best;
}

/// Draws sorted standard normal numbers, two at a time (Box and Muller 1958).
void draw(Random& random, std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); i += 2) {
    const double r = std::sqrt(-2 * math::log(random.uniform()));
    const double angle = 2 * std::numbers::pi * random.uniform();
    values[i] = r * math::cos(angle);
    if (i + 1 < values.size()) values[i + 1] = r * math::sin(angle);
  }
  std::ranges::sort(values);
}

}  // namespace

std::optional<TwoGroups> two_groups(std::vector<double> values, double level) {
  constexpr int samples = 1999;      // from a normal distribution
  constexpr double rounding = 1e-9;  // relative to the largest value
  if (values.size() < fewest_for_groups) return std::nullopt;
  std::ranges::sort(values);
  const double size = std::max(std::abs(values.front()), std::abs(values.back()));
  if (!(values.back() - values.front() > rounding * size)) return std::nullopt;
  const Split found = sharpest(values);
  Random random(1958, static_cast<std::uint32_t>(values.size()));
  std::vector<double> drawn(values.size());
  int as_extreme = 1;
  for (int i = 0; i < samples; ++i) {
    draw(random, drawn);
    if (sharpest(drawn).rest > found.rest) continue;
    if (++as_extreme > level * (samples + 1)) return std::nullopt;  // already too probable
  }
  return TwoGroups{.between = std::midpoint(values[found.low - 1], values[found.low]),
                   .p_value = as_extreme / (samples + 1.0)};  // (sta.7)
}

}  // namespace mahlwerk::observe
