// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/fit/measurement_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/base/text.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr Range share{.least = 0, .most = 1};

/// Columns with fixed names.
struct FixedColumn {
  FileColumn of;
  Role role = Role::measured;
  MeasuredQuantity what = MeasuredQuantity::quantile;  ///< of measured values
};
constexpr FixedColumn fixed_columns[] = {
    {{"time", "s", not_negative}, Role::time},
    {{"size", "m", positive}, Role::size},
    {{"fall_height", "m", positive}, Role::fall},
    {{"passing", "", share}, Role::measured, MeasuredQuantity::passing},
    {{"specific_surface", "m2/kg", positive}, Role::measured, MeasuredQuantity::specific_surface},
    {{"conversion", "", share}, Role::measured, MeasuredQuantity::conversion},
    {{"yield", "", share}, Role::measured, MeasuredQuantity::yield},
    {{"second_yield", "", share}, Role::measured, MeasuredQuantity::second_yield},
    {{"ignition_time", "s", positive}, Role::measured, MeasuredQuantity::ignition_time},
    {{"rebound_height", "m", positive}, Role::measured, MeasuredQuantity::rebound_height}};
/// "D1" to "D99".
constexpr FileColumn quantiles{"D90", "m", positive};

/// The record of a measured quantity but that of a run, which has its own.
const FileColumn& record_of(MeasuredQuantity what) {
  for (const FixedColumn& one : fixed_columns)
    if (one.role == Role::measured && one.what == what) return one.of;
  return quantiles;
}

/// 90 from "D90"; empty if the word is not such a quantile.
std::optional<int> percent_of(std::string_view word) {
  if (word.size() < 2 || word.size() > 3 || word[0] != 'D' || word[1] == '0') return std::nullopt;
  int percent = 0;
  for (const char c : word.substr(1)) {
    if (c < '0' || c > '9') return std::nullopt;
    percent = 10 * percent + (c - '0');
  }
  return percent;
}

/// The column with this name, without its unit; empty if there is none.
std::optional<Column> column_called(std::string_view name, const RunQuantities& known) {
  constexpr std::string_view ending = "_error";
  if (name.ends_with(ending)) {
    std::optional<Column> of = column_called(name.substr(0, name.size() - ending.size()), known);
    if (!of || of->role != Role::measured) return std::nullopt;
    of->role = Role::error;
    of->range = positive;
    return of;
  }
  Column column{.role = Role::measured,
                .name = std::string(name),
                .unit = {},
                .stored_unit = std::string(quantiles.unit),
                .range = quantiles.range,
                .error_in = {}};
  if (const auto percent = percent_of(name)) {
    column.percent = *percent;
    return column;
  }
  for (const FixedColumn& fixed : fixed_columns)
    if (name == fixed.of.name) {
      column.role = fixed.role;
      column.what = fixed.what;
      column.stored_unit = fixed.of.unit;
      column.range = fixed.of.range;
      return column;
    }
  if (const auto of = std::ranges::find(known, name, &RunQuantity::name); of != known.end()) {
    column.what = MeasuredQuantity::of_run;
    column.quantity = *of;
    column.stored_unit = of->unit;
    column.range = any_number;  // an angle may be negative
    return column;
  }
  column.role = Role::condition;
  if (name.find('.') != std::string_view::npos) return column;
  return std::nullopt;
}

/// "m2/kg" from "m2_per_kg", as in headings of Mahlwerk's own tables.
std::string unit_from(std::string text) {
  for (const auto& [from, to] : {std::pair{"_per_", "/"}, std::pair{"_", " "}})
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from))
      text.replace(at, std::string_view(from).size(), to);
  return text;
}

}  // namespace

std::string name_of(MeasuredQuantity what, int percent) {
  if (what == MeasuredQuantity::quantile) return fmt::format("D{}", percent);
  return what == MeasuredQuantity::of_run ? "" : std::string(record_of(what).name);
}

std::string_view unit_of(MeasuredQuantity what) {
  return what == MeasuredQuantity::of_run ? "" : record_of(what).unit;
}

std::optional<Column> column_of(const std::string& heading, const RunQuantities& known) {
  if (heading.empty()) return std::nullopt;
  const auto open = heading.find_first_of("([");
  if (open != std::string::npos && (heading.back() == ')' || heading.back() == ']')) {
    std::optional<Column> column = column_called(trimmed(heading.substr(0, open)), known);
    if (column) column->unit = trimmed(heading.substr(open + 1, heading.size() - open - 2));
    if (column && column->unit == "1") column->unit.clear();
    return column;
  }
  if (std::optional<Column> column = column_called(heading, known)) return column;
  for (auto at = heading.rfind('_'); at != std::string::npos && at > 0; at = heading.rfind('_', at))
    if (std::optional<Column> column = column_called(heading.substr(0, at--), known);
        column && column->role != Role::condition) {
      column->unit = unit_from(heading.substr(at + 2));
      return column;
    }
  return std::nullopt;
}

std::string heading_near(const std::string& heading, const RunQuantities& known) {
  const auto end = std::min(heading.find_first_of(" (["), heading.size());
  std::vector<std::string> names{"D10", "D50", "D90"};
  for (const FixedColumn& one : fixed_columns) names.emplace_back(one.of.name);
  for (const RunQuantity& one : known) names.push_back(one.name);
  std::vector<std::string> words;
  for (const std::string& word : names)
    for (const char* ending : {"", "_error"})
      words.push_back(word + (ending + heading.substr(end)));
  return nearest_word(heading, words);
}

std::vector<std::string> cells_of(std::string_view line, char separator) {
  std::vector<std::string> cells{""};
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quoted && line.substr(i, 2) == "\"\"")
      cells.back() += line[++i];
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == separator && !quoted)
      cells.emplace_back();
    else
      cells.back() += line[i];
  }
  for (std::string& cell : cells) cell = std::string(trimmed(cell));
  return cells;
}

}  // namespace mahlwerk::campaign
