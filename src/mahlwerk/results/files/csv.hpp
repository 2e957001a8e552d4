// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mahlwerk::results {

/// What stands in one column of a table.
struct Column {
  std::string name, unit, about;  ///< unit "1" where there is none; what it is, in a few words
  /// Of a column of words: those its numbers 0, 1, ... stand for.
  std::vector<std::string> words = {};

  /// The number of a word, which is added unless it is there already.
  double number_of(std::string_view word);
};

/// Numbers under headings that know their units. What is not a number is NaN.
struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<double>> rows;
};

/// Comma-separated text with one heading line of names with their units: pandas.read_csv(path)
/// reads it as it is. What is not a number is an empty cell.
std::string csv(const Table& table);

/// One cell: the shortest text that reads back as the same double, or nothing.
std::string csv_cell(double value);
/// A cell of text, quoted where it must be. Control characters are escaped as in TOML; what a
/// spreadsheet would take for a formula gets a ' in front.
std::string csv_cell(std::string_view text);

/// Cells with commas between them and the end of the line.
std::string csv_line(const std::vector<std::string>& cells);

/// "energy_normal_mean" in "J" is "energy_normal_mean_J"; a rate in "1/s" ends in "_per_s".
std::string column_name(std::string_view name, std::string_view unit);

}  // namespace mahlwerk::results
