// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/csv.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"

namespace mahlwerk::results {

double Column::number_of(std::string_view word) {
  const auto place = std::find(words.begin(), words.end(), word);
  const auto number = static_cast<double>(place - words.begin());
  if (place == words.end()) words.emplace_back(word);
  return number;
}

std::string csv_cell(double value) {
  return std::isfinite(value) ? shortest(value) : "";
}

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c;
    if (c == '"') quoted += c;
  }
  return quoted + '"';
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    line += cell;
    line += ',';
  }
  if (line.empty()) return "\n";
  line.back() = '\n';
  return line;
}

std::string csv(const Table& table) {
  std::vector<std::string> cells;
  for (const Column& c : table.columns) cells.push_back(column_name(c.name, c.unit));
  std::string text = csv_line(cells);
  for (const std::vector<double>& row : table.rows) {
    cells.clear();
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::vector<std::string>& words = table.columns[i].words;
      cells.push_back(words.empty()
                          ? csv_cell(row[i])
                          : csv_cell(std::string_view(words[static_cast<std::size_t>(row[i])])));
    }
    text += csv_line(cells);
  }
  return text;
}

std::string column_name(std::string_view name, std::string_view unit) {
  std::string column(name);
  if (unit.empty() || unit == "1") return column;
  column += '_';
  if (unit.starts_with("1/")) unit.remove_prefix(1);  // "/s" -> "per_s"
  bool first = true;
  for (const char c : unit) {
    if (c == '/')
      column += first ? "per_" : "_per_";
    else if (c == ' ' || c == '.')
      column += '_';
    else
      column += c;
    first = false;
  }
  return column;
}

}  // namespace mahlwerk::results
