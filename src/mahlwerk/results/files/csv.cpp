// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/csv.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/printable.hpp"
#include "mahlwerk/base/units.hpp"

namespace mahlwerk::results {
namespace {

/// Whether the text has only characters of units: letters, digits, " ./%^_", and "-" after "^".
bool is_unit(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool sign = text[i] == '-' && i > 0 && text[i - 1] == '^';
    if (!sign && byte < 0x80 && std::isalnum(byte) == 0 &&
        std::string_view(" ./%^_").find(text[i]) == std::string_view::npos)
      return false;
  }
  return true;
}

/// Whether a spreadsheet would read the text as a formula: it begins as one, and is neither a sign
/// alone nor a number with or without a unit.
bool is_formula(std::string_view text) {
  if (text.empty() || std::string_view("=+-@\t").find(text.front()) == std::string_view::npos)
    return false;
  if (text == "-" || text == "+") return false;
  const NumberText read = number_text(text.substr(text.front() == '+' ? 1 : 0));
  return std::isnan(read.number) || !is_unit(read.rest);
}

}  // namespace

std::string csv_cell(double value) {
  return std::isfinite(value) ? shortest(value) : "";
}

std::string csv_cell(std::string_view text) {
  const bool formula = is_formula(text);
  const std::string shown = printable(text);
  if (!formula && shown.find_first_of(",\"\t\n") == std::string::npos) return shown;
  std::string quoted = formula ? "\"'" : "\"";
  for (const char c : shown) {
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
  for (const Column& c : table.columns)
    cells.push_back(csv_cell(std::string_view(column_name(c.name, c.unit))));
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
