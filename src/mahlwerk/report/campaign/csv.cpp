// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/csv.hpp"

#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/report/campaign/campaign.hpp"
#include "mahlwerk/report/campaign/sheet.hpp"

namespace mahlwerk::report {
namespace {

/// Column name of a key, with "percent" for "%".
std::string column_of(const CampaignKey& s) {
  return results::column_name(s.key, s.unit == "%" ? "percent" : s.unit);
}

}  // namespace

std::string campaign_csv(const Campaign& c) {
  const Sheet sheet(c);
  std::vector<std::string> heads{"point"};
  for (const CampaignKey& s : c.keys) heads.push_back(results::csv_cell(column_of(s)));
  for (const Column& q : c.columns) {
    heads.push_back(results::column_name(q.name, q.unit));
    heads.push_back(results::column_name(q.name + "_ci95", q.unit));
  }
  heads.emplace_back("warnings");
  std::string text = results::csv_line(heads);
  for (const Point& p : c.points) {
    std::vector<std::string> cells{std::to_string(p.number)};
    for (std::size_t k = 0; k < c.keys.size(); ++k)
      cells.push_back(sheet.keys[k].numeric() ? results::csv_cell(number_text(p.values[k]).number)
                                              : results::csv_cell(p.values[k]));
    for (std::size_t i = 0; i < c.columns.size(); ++i) {
      cells.push_back(results::csv_cell(value_at(p, i)));
      cells.push_back(results::csv_cell(half_width_at(p, i)));
    }
    cells.push_back(results::csv_cell(std::string_view(p.warnings)));
    text += results::csv_line(cells);
  }
  return text;
}

}  // namespace mahlwerk::report
