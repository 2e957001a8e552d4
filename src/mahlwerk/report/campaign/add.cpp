// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/report/campaign/campaign.hpp"
#include "mahlwerk/report/campaign/sheet.hpp"

namespace mahlwerk::report {
namespace {

/// Index of a quantity's column, which is added if missing. `likely` is tried first.
std::size_t column_of(Campaign& c, std::size_t likely, const results::Quantity& q) {
  if (likely < c.columns.size() && c.columns[likely].name == q.name) return likely;
  const auto found = std::ranges::find(c.columns, q.name, &Column::name);
  if (found != c.columns.end()) return static_cast<std::size_t>(found - c.columns.begin());
  c.columns.push_back({q.name, q.unit, q.about});
  return c.columns.size() - 1;
}

}  // namespace

void add(Campaign& campaign, Point point, const std::vector<results::Quantity>& quantities) {
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const std::size_t column = column_of(campaign, i, quantities[i]);
    if (point.value.size() <= column) {
      point.value.resize(column + 1, NAN);
      point.ci95.resize(column + 1, NAN);
    }
    point.value[column] = quantities[i].value;
    point.ci95[column] = quantities[i].ci95;
  }
  campaign.points.push_back(std::move(point));
}

std::vector<CampaignKey> campaign_keys(const std::vector<std::string>& keys,
                                       const std::vector<Point>& points) {
  std::vector<CampaignKey> list;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::string_view unit = points.empty() ? "" : number_text(points.front().values[i]).rest;
    const bool shared = std::ranges::all_of(points, [&](const Point& p) {
      const NumberText s = number_text(p.values[i]);
      return std::isfinite(s.number) && s.rest == unit;
    });
    list.push_back({keys[i], shared ? std::string(unit) : ""});
  }
  return list;
}

}  // namespace mahlwerk::report
