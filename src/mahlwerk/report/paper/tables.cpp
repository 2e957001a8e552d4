// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/paper/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/report/campaign/sheet.hpp"
#include "mahlwerk/report/paper/claim_lines.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/csv.hpp"

namespace mahlwerk::report {
namespace {

/// Last value over first; NaN unless both are numbers and the first is positive.
double last_over_first(const ClaimLine& line) {
  if (line.points.empty() || !(line.points.front().value > 0)) return NAN;
  return line.points.back().value / line.points.front().value;
}

/// The values of `against` over all lines, in order of first mention.
std::vector<std::string> column_values(const std::vector<ClaimLine>& lines) {
  std::vector<std::string> values;
  for (const ClaimLine& line : lines)
    for (const LinePoint& s : line.points)
      if (std::ranges::find(values, s.text) == values.end()) values.push_back(s.text);
  return values;
}

MadeTable quantity_table(const PaperTable& table, const RunCampaign& run) {
  MadeTable made{.table = &table, .heads = {}, .rows = {}, .csv = {}, .note = {}};
  const std::string unit = unit_of(run.numbers, table.quantity);
  const std::vector<ClaimLine> lines =
      lines_along(run.numbers, table.at, table.against, table.quantity);
  if (lines.empty()) return made;
  made.heads = lines.front().keys;
  std::vector<std::string> head = lines.front().keys;
  head.insert(head.end(), {table.against, results::column_name(table.quantity, unit),
                           results::column_name(table.quantity + "_ci95", unit)});
  const std::vector<std::string> columns = column_values(lines);
  made.heads.insert(made.heads.end(), columns.begin(), columns.end());
  if (table.ratio) made.heads.emplace_back("last over first");
  made.csv = results::csv_line(head);
  for (const ClaimLine& line : lines) {
    std::vector<std::string> row = line.values;
    for (const std::string& value : columns) {
      const auto s = std::ranges::find(line.points, value, &LinePoint::text);
      const bool run_there = s != line.points.end();
      row.push_back(run_there ? readable(s->value, s->ci95, unit).text() : "-");
      if (!run_there) continue;
      std::vector<std::string> cells;
      for (const std::string& other : line.values)
        cells.push_back(results::csv_cell(std::string_view(other)));
      cells.insert(cells.end(), {results::csv_cell(std::string_view(value)),
                                 results::csv_cell(s->value), results::csv_cell(s->ci95)});
      made.csv += results::csv_line(cells);
    }
    const double ratio = last_over_first(line);
    if (table.ratio) row.push_back(std::isfinite(ratio) ? fmt::format("{:.2f}", ratio) : "-");
    made.rows.push_back(std::move(row));
  }
  made.note = fmt::format("{} against {}; ± is the 95 % confidence half-width.",
                          label(table.quantity), key_words(table.against));
  return made;
}

}  // namespace

MadeTable made_table(const PaperTable& table, const RunCampaign& run) {
  return table.kind == PaperTable::Kind::captured ? captured_table(table, run)
                                                  : quantity_table(table, run);
}

}  // namespace mahlwerk::report
