// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/series.hpp"

#include <cmath>
#include <limits>

#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::results {
const std::vector<std::string>& series_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Measure& m : all_measures())
      if (m.traits.over_time != nullptr) list.push_back(m.name);
    return list;
  }();
  return names;
}

std::vector<double> series(const std::vector<Window>& windows, std::string_view name) {
  std::vector<double> values;
  const Measure* record = record_of(name);
  if (record == nullptr || record->traits.over_time == nullptr) return values;
  for (const Window& w : windows)
    if (const double v = record->traits.over_time(w); std::isfinite(v)) values.push_back(v);
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
