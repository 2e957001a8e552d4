// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/paper/measurements.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"

namespace mahlwerk::report {

PaperFigure with_measured(const PaperFigure& figure, const Paper& paper, const Campaign& campaign) {
  PaperFigure drawn = figure;
  const auto key = std::ranges::find(campaign.keys, figure.against, &CampaignKey::key);
  const std::string unit = unit_of(campaign, figure.quantity);
  for (const std::string& name : figure.measurements) {
    const Measurement* measured = paper.measurement(name);
    if (measured == nullptr || key == campaign.keys.end()) continue;
    MeasuredSeries series{.name = "measured: " + name, .x = {}, .y = {}};
    for (const Measurement::Value& value : measured->values) {
      series.x.push_back(parse_in(value.at, key->unit));
      series.y.push_back(value.in(unit));
      series.error_low.push_back(value.error_in(unit));
      series.error_high.push_back(value.error_in(unit));
    }
    drawn.measured.push_back(std::move(series));
  }
  return drawn;
}

ClaimLine relative_line(const ClaimLine& line, const std::string& base) {
  const auto zero = std::ranges::find_if(
      line.points, [&](const LinePoint& p) { return same_value(p.text, base); });
  if (zero == line.points.end()) return {.others = line.others, .points = {}};
  const LinePoint reference = *zero;
  ClaimLine relative = line;
  for (LinePoint& p : relative.points) {
    const double ratio = p.value / reference.value;
    p.ci95 = std::hypot(p.ci95, ratio * reference.ci95) / std::abs(reference.value);
    p.value = ratio;
  }
  LinePoint& one = relative.points[static_cast<std::size_t>(zero - line.points.begin())];
  one.ci95 = 0;
  return relative;
}

}  // namespace mahlwerk::report
