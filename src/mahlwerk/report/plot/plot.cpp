// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/plot.hpp"

#include <algorithm>
#include <cmath>

namespace mahlwerk::report {

Interval interval_at(const Series& s, std::size_t i, const Axis& y) {
  Interval ends;
  if (i < s.low.size() && i < s.high.size())
    ends = {s.low[i], s.high[i]};
  else if (i < s.y.size() && i < s.error.size() && s.error[i] >= 0)
    ends = {s.y[i] - s.error[i], s.y[i] + s.error[i]};
  if (!std::isfinite(ends.low) || !std::isfinite(ends.high)) return {};
  // A value outside the range stays inside its interval.
  const bool has_value = i < s.y.size() && std::isfinite(s.y[i]);
  const double least = has_value ? std::min(y.range_least, s.y[i]) : y.range_least,
               most = has_value ? std::max(y.range_most, s.y[i]) : y.range_most;
  return {std::clamp(ends.low, least, most), std::clamp(ends.high, least, most)};
}

}  // namespace mahlwerk::report
