// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/outcome_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mahlwerk::campaign {

SettingSample sample_of(DesignPoint point, const std::vector<double>& replicates) {
  SettingSample made{.point = std::move(point)};
  for (const double value : replicates) {
    if (!std::isfinite(value)) continue;
    const double off = value - made.mean;
    made.mean += off / ++made.count;
    made.squares += off * (value - made.mean);
  }
  return made;
}

Posterior OutcomeModel::at(const DesignPoint& point) const {
  const Posterior guess = process.at(point);
  return {centre + scale * guess.mean, scale * guess.deviation};
}

/// A few replicates estimate their scatter poorly: the pooled scatter of all settings has the
/// weight of three more replicates (opt.9).
OutcomeModel outcome_model(const std::vector<SettingSample>& samples) {
  constexpr double pooled_weight = 3, least = 1e-10;
  double freedom = 0, squares = 0, centre = 0, spread = 0;
  for (const SettingSample& s : samples) {
    freedom += s.count - 1;
    squares += s.squares;
    centre += s.mean / static_cast<double>(samples.size());
  }
  for (const SettingSample& s : samples) spread += (s.mean - centre) * (s.mean - centre);
  spread = std::sqrt(spread / static_cast<double>(std::max<std::size_t>(1, samples.size() - 1)));
  const double unit = spread > 0 ? spread : std::max(std::abs(centre), 1e-300);
  const double pooled = freedom > 0 ? squares / freedom : 0;
  std::vector<Observation> observations;
  for (const SettingSample& s : samples) {
    const double own = (pooled_weight * pooled + s.squares) / (pooled_weight + s.count - 1);
    observations.push_back({.point = s.point,
                            .value = (s.mean - centre) / unit,
                            .variance = std::max(least, own / s.count / unit / unit)});
  }
  Kernel kernel = most_probable_kernel(observations);
  return {GaussianProcess(std::move(kernel), std::move(observations)), centre, unit,
          std::max(least, pooled / 2 / unit / unit)};
}

}  // namespace mahlwerk::campaign
