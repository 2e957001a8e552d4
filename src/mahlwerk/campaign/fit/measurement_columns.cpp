// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/fit/measurement_columns.hpp"

#include <algorithm>
#include <utility>

#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/base/text.hpp"

namespace mahlwerk::campaign {
namespace {

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
    return of;
  }
  Column column{.role = Role::measured, .name = std::string(name), .unit = {}, .error_in = {}};
  if (const auto percent = percent_of(name)) {
    column.percent = *percent;
    return column;
  }
  for (const auto& [word, role] :
       {std::pair{"time", Role::time}, {"size", Role::size}, {"fall_height", Role::fall}})
    if (name == word) {
      column.role = role;
      return column;
    }
  for (const MeasuredQuantity what :
       {MeasuredQuantity::passing, MeasuredQuantity::specific_surface, MeasuredQuantity::conversion,
        MeasuredQuantity::yield, MeasuredQuantity::second_yield, MeasuredQuantity::ignition_time,
        MeasuredQuantity::rebound_height})
    if (name == name_of(what, 0)) {
      column.what = what;
      return column;
    }
  if (const auto of = std::ranges::find(known, name, &RunQuantity::name); of != known.end()) {
    column.what = MeasuredQuantity::of_run;
    column.quantity = *of;
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

std::string_view Column::stored_unit() const {
  if (role == Role::time) return "s";
  if (role == Role::size || role == Role::fall) return "m";
  return what == MeasuredQuantity::of_run ? std::string_view(quantity.unit) : unit_of(what);
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
  std::vector<std::string> names{
      "time",         "D10",           "D50",  "D90",     "specific_surface", "conversion", "yield",
      "second_yield", "ignition_time", "size", "passing", "rebound_height",   "fall_height"};
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
