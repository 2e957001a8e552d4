// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/calibrate/ensemble_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/random.hpp"

namespace mahlwerk::campaign {
namespace {

using Position = std::vector<double>;
using LogDensity = std::function<double(const Position&)>;
constexpr double nowhere = -std::numeric_limits<double>::infinity();
constexpr std::uint32_t stream = 0x54000000;

struct Walker {
  Position point;
  double log_density = nowhere;
};

double density_at(const LogDensity& log_density, const Position& point) {
  if (std::ranges::any_of(point, [](double x) { return !(x > 0 && x < 1); })) return nowhere;
  const double value = log_density(point);
  return std::isnan(value) ? nowhere : value;
}

/// Walkers at the starts of the highest density, a little apart where there are fewer starts.
std::vector<Walker> begin(const LogDensity& log_density, const std::vector<Position>& starts,
                          int count, Random& random) {
  std::vector<Walker> all;
  for (const Position& point : starts) all.push_back({point, density_at(log_density, point)});
  std::ranges::stable_sort(all, std::greater<>(), &Walker::log_density);
  std::erase_if(all, [](const Walker& w) { return w.log_density == nowhere; });
  if (all.empty()) throw std::invalid_argument("no start of the sampler has a density");
  all.resize(std::min(all.size(), static_cast<std::size_t>(count)));
  const std::size_t known = all.size();
  for (std::size_t i = 0; all.size() < static_cast<std::size_t>(count); ++i) {
    Walker near = all[i % known];
    for (double& x : near.point)
      x = std::clamp(x + 0.02 * (random.uniform() - 0.5), 1e-6, 1 - 1e-6);
    near.log_density = density_at(log_density, near.point);
    all.push_back(near.log_density == nowhere ? all[i % known] : near);
  }
  return all;
}

/// One stretch move of a walker along the line through another one (cal.5).
bool stretch(const LogDensity& log_density, Walker& walker, const Walker& other, Random& random) {
  constexpr double a = 2;
  const double root = 1 + (a - 1) * random.uniform();
  const double z = root * root / a;
  Position point;
  for (std::size_t i = 0; i < walker.point.size(); ++i)
    point.push_back(other.point[i] + z * (walker.point[i] - other.point[i]));
  const double chance = random.uniform();
  const double value = density_at(log_density, point);
  const double dimensions = static_cast<double>(point.size());
  if (value == nowhere ||
      math::log(chance) > (dimensions - 1) * math::log(z) + value - walker.log_density)
    return false;
  walker = {std::move(point), value};
  return true;
}

/// Potential scale reduction of a coordinate: the first against the second half of the points that
/// each walker has kept (Gelman and Rubin 1992).
double shrinkage_of(const std::vector<Position>& points, std::size_t coordinate) {
  const std::size_t half = points.size() / 2;
  if (half < 4) return 1;
  double mean[2] = {0, 0}, variance[2] = {0, 0};
  for (std::size_t h = 0; h < 2; ++h) {
    for (std::size_t i = 0; i < half; ++i)
      mean[h] += points[h * half + i][coordinate] / static_cast<double>(half);
    for (std::size_t i = 0; i < half; ++i) {
      const double off = points[h * half + i][coordinate] - mean[h];
      variance[h] += off * off / static_cast<double>(half - 1);
    }
  }
  const double within = (variance[0] + variance[1]) / 2;
  const double off = (mean[0] - mean[1]) / 2;
  return within > 0 ? std::sqrt(1 + 2 * off * off / within) : 1;
}

}  // namespace

DensitySample sample_density(const LogDensity& log_density, const std::vector<Position>& starts,
                             const SamplerSettings& settings) {
  Random random(settings.seed, stream);
  std::vector<Walker> walkers = begin(log_density, starts, settings.walkers, random);
  const std::size_t half = walkers.size() / 2;
  DensitySample made;
  double moved = 0, proposed = 0;
  for (int move = 0; move < settings.burn_in + settings.moves; ++move) {
    for (std::size_t i = 0; i < walkers.size(); ++i) {  // each half moves along the other
      const std::size_t first = i < half ? half : 0;
      const auto k = static_cast<std::size_t>(random.uniform() * static_cast<double>(half));
      moved += stretch(log_density, walkers[i], walkers[first + std::min(k, half - 1)], random);
      ++proposed;
    }
    if (move >= settings.burn_in && (move - settings.burn_in) % settings.keep_every == 0)
      for (const Walker& w : walkers) made.points.push_back(w.point);
  }
  made.acceptance = moved / proposed;
  for (std::size_t i = 0; i < walkers.front().point.size(); ++i)
    made.shrinkage = std::max(made.shrinkage, shrinkage_of(made.points, i));
  return made;
}

}  // namespace mahlwerk::campaign
