// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/csv.hpp"

#include <cmath>

#include "mahlwerk/base/units.hpp"

namespace mahlwerk::results {

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

std::string csv(const Table& table) {
  std::string text;
  const auto end_cell = [&](std::size_t i, std::size_t count) {
    text += i + 1 < count ? ',' : '\n';
  };
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    text += csv_cell(table.columns[i]);
    end_cell(i, table.columns.size());
  }
  for (const std::vector<double>& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += csv_cell(row[i]);
      end_cell(i, row.size());
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
