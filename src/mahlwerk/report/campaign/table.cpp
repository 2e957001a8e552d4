// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/report/campaign/campaign.hpp"
#include "mahlwerk/report/campaign/sheet.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/quantities/key_quantities.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::report {
namespace {

constexpr std::size_t max_points = 40;  // lines that fit a screen

struct ListedResult {
  std::string quantity, head;
  std::size_t column = 0;
};

/// The usual columns that the campaign has.
std::vector<ListedResult> listed_results(const Campaign& campaign) {
  std::vector<ListedResult> list;
  for (const std::string& name : results::usual_columns()) {
    const auto at = std::ranges::find(campaign.columns, name, &Column::name);
    if (at == campaign.columns.end()) continue;
    const std::string_view head = results::record_of(name)->traits.column_head;
    list.push_back({name, head.empty() ? label(name) : std::string(head),
                    static_cast<std::size_t>(at - campaign.columns.begin())});
  }
  return list;
}

std::vector<std::string> line_of(const Campaign& c, const Point& p,
                                 const std::vector<ListedResult>& shown, bool regimes,
                                 bool warnings) {
  constexpr std::size_t enough = 60;
  std::vector<std::string> line = p.values;
  line.resize(c.keys.size());
  if (!p.failure.empty() || p.waiting()) {
    line.push_back(missing_reason(p, enough));
    return line;
  }
  for (const ListedResult& one : shown) {
    const bool has = one.column < p.value.size();
    const double value = value_at(p, one.column), ci95 = half_width_at(p, one.column);
    line.push_back(has ? readable_within(value, ci95, c.columns[one.column].unit,
                                         results::range_of(one.quantity))
                             .text()
                       : "");
  }
  if (regimes) line.push_back(p.regime);
  if (warnings) line.push_back(p.warnings);
  return line;
}

std::string in_columns(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const auto& line : lines)  // the last cell of a short line may exceed its column
    for (std::size_t i = 0; i < line.size(); ++i)
      if (i + 1 < line.size() || line.size() == widths.size())
        widths[i] = std::max(widths[i], width(line[i]));
  std::string text;
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i)
      text +=
          line[i] + (i + 1 < line.size() ? std::string(widths[i] + 2 - width(line[i]), ' ') : "\n");
  return text;
}

}  // namespace

std::string campaign_table(const Campaign& campaign, std::string_view where) {
  const std::vector<ListedResult> shown = listed_results(campaign);
  const bool regimes = regimes_differ(campaign), warnings = any_warnings(campaign);
  std::vector<std::vector<std::string>> lines(1);
  for (const CampaignKey& key : campaign.keys) lines[0].push_back(key.key);
  for (const ListedResult& one : shown) lines[0].emplace_back(one.head);
  if (regimes) lines[0].emplace_back("regime");
  if (warnings) lines[0].emplace_back("warnings");
  const std::size_t points = campaign.points.size();
  // Prints the last point instead of a line "... and 1 more".
  const std::size_t lines_of_points = points <= max_points + 1 ? points : max_points;
  for (std::size_t i = 0; i < lines_of_points; ++i)
    lines.push_back(line_of(campaign, campaign.points[i], shown, regimes, warnings));
  std::string text = in_columns(lines);
  if (lines_of_points < points)
    text += fmt::format("... and {} more points: {}\n", points - lines_of_points, where);
  return text;
}

}  // namespace mahlwerk::report
