// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mahlwerk::results {

/// Numbers under headings that name their units.
struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
};

/// Comma-separated text with one heading line: pandas.read_csv(path) reads it as it is. What is not
/// a number is an empty cell.
std::string csv(const Table& table);

/// One cell: the shortest text that reads back as the same double, or nothing.
std::string csv_cell(double value);
/// A cell of text, quoted where it must be.
std::string csv_cell(std::string_view text);

/// Cells with commas between them and the end of the line.
std::string csv_line(const std::vector<std::string>& cells);

/// "energy_normal_mean" in "J" is "energy_normal_mean_J"; a rate in "1/s" ends in "_per_s".
std::string column_name(std::string_view name, std::string_view unit);

}  // namespace mahlwerk::results
