// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/means.hpp"

#include <cmath>

#include "mahlwerk/observe/statistics.hpp"

namespace mahlwerk::results {

Interval interval_of(const cases::Case& mill_case) {
  return mill_case.uncertainty ? Interval::of_draw : Interval::of_mean;
}

double above_rounding_of(double value, double half_width) {
  constexpr double rounding = 1e-13;  // of sums of many numbers
  return half_width <= rounding * std::abs(value) ? 0 : half_width;
}

void combine(Quantity& q, const std::vector<double>& values, Interval interval) {
  std::vector<double> there;
  for (const double v : values) {
    if (std::isfinite(v)) there.push_back(v);
  }
  q.value = q.ci95 = undefined;
  if (there.empty()) return;
  const observe::Estimate e = observe::estimate(there);
  q.value = e.mean;
  q.ci95 = e.ci95;
  if (interval == Interval::of_draw)
    q.ci95 *= std::sqrt(static_cast<double>(there.size()) + 1);  // (cal.9)
  q.ci95 = above_rounding_of(q.value, q.ci95);
}

std::vector<Quantity> means(const std::vector<Measure>& measures,
                            const std::vector<std::vector<double>>& each,
                            const std::vector<std::size_t>& numbers, Interval interval) {
  std::vector<Quantity> list;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    std::vector<double> values;
    for (const std::size_t n : numbers) values.push_back(each[n - 1][i]);
    const Measure& m = measures[i];
    combine(list.emplace_back(Quantity{m.name, undefined, undefined, m.unit, m.about}), values,
            interval);
  }
  return list;
}

}  // namespace mahlwerk::results
