// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mahlwerk::results {
namespace {

struct Kind {
  std::string_view name;
  double (*of)(const Window&);
};

constexpr std::array series_kinds{
    Kind{"dissipated_power", [](const Window& w) { return w.lost / w.length; }},
    Kind{"drawn_power", [](const Window& w) { return w.wall_work / w.length; }},
    Kind{"collision_rate", [](const Window& w) { return w.collisions / w.length; }},
    Kind{"collision_rate_above_threshold", [](const Window& w) { return w.above / w.length; }},
    Kind{"energy_normal_mean", [](const Window& w) { return w.energy_normal / w.collisions; }},
    Kind{"energy_contact_point_mean",
         [](const Window& w) { return w.energy_contact_point / w.collisions; }},
};

}  // namespace

const std::vector<std::string>& series_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Kind& kind : series_kinds) list.emplace_back(kind.name);
    return list;
  }();
  return names;
}

std::vector<double> series(const std::vector<Window>& windows, std::string_view name) {
  std::vector<double> values;
  const auto kind = std::ranges::find(series_kinds, name, &Kind::name);
  if (kind == series_kinds.end()) return values;
  for (const Window& w : windows)
    if (const double v = kind->of(w); std::isfinite(v)) values.push_back(v);
  return values;
}

double ci95_over_time(const std::vector<const Replicate*>& replicates, std::string_view name) {
  if (replicates.empty()) return std::numeric_limits<double>::quiet_NaN();
  double squares = 0;
  for (const Replicate* r : replicates) {
    const double one = observe::time_series_estimate(series(r->windows, name)).ci95;
    squares += one * one;
  }
  return std::sqrt(squares) / static_cast<double>(replicates.size());
}

double settling_time(const std::vector<const Replicate*>& replicates) {
  std::vector<double> together;
  double length = std::numeric_limits<double>::quiet_NaN();
  for (const Replicate* r : replicates) {
    const std::vector<double> one = series(r->windows, "dissipated_power");
    if (together.empty() || one.size() < together.size()) together.resize(one.size());
    for (std::size_t i = 0; i < together.size(); ++i) together[i] += one[i];
    if (!r->windows.empty()) length = r->windows.front().length;
  }
  return static_cast<double>(observe::transient_length(together)) * length;
}

}  // namespace mahlwerk::results
