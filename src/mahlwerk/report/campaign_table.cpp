// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "mahlwerk/report/campaign.hpp"
#include "mahlwerk/report/readable.hpp"

namespace mahlwerk::report {
namespace {

struct Column {
  std::string_view quantity, head;
};
constexpr std::array columns{
    Column{"collision_rate_above_threshold", "hits above threshold"},
    Column{"energy_contact_point_mean_above_threshold", "E contact point"},
    Column{"energy_normal_mean_above_threshold", "E normal"},
    Column{"dissipated_power", "dissipated"},
    Column{"contact_time_share", "time in contact"},
    Column{"captured_mass_rate", "caught"},
    Column{"d50", "D50"},
    Column{"d90", "D90"},
};

std::string value_of(const Point& point, std::string_view name) {
  const auto at = std::find_if(point.quantities.begin(), point.quantities.end(),
                               [&](const results::Quantity& q) { return q.name == name; });
  return at == point.quantities.end() ? "" : readable(*at).text();
}

/// Those that the points have.
std::vector<Column> columns_of(const Campaign& campaign) {
  std::vector<Column> list;
  for (const Column& column : columns)
    if (std::ranges::any_of(campaign.points, [&](const Point& point) {
          return std::ranges::find(point.quantities, column.quantity, &results::Quantity::name) !=
                 point.quantities.end();
        }))
      list.push_back(column);
  return list;
}

}  // namespace

std::string campaign_table(const Campaign& campaign) {
  const std::vector<Column> shown = columns_of(campaign);
  std::vector<std::vector<std::string>> lines(1);
  for (const Swept& key : campaign.swept) lines[0].push_back(key.key);
  for (const Column& column : shown) lines[0].emplace_back(column.head);
  for (const Point& point : campaign.points) {
    lines.push_back(point.values);
    for (const Column& column : shown) lines.back().push_back(value_of(point, column.quantity));
  }
  std::vector<std::size_t> widths(lines[0].size(), 0);
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], width(line[i]));
  std::string text;
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i)
      text +=
          line[i] + (i + 1 < line.size() ? std::string(widths[i] + 2 - width(line[i]), ' ') : "\n");
  }
  return text;
}

}  // namespace mahlwerk::report
