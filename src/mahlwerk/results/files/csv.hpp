// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/results/table.hpp"

namespace mahlwerk::results {

/// Comma-separated text with one heading line of names with units, as pandas.read_csv(path) reads
/// it. NaN is an empty cell.
std::string csv(const Table& table);

/// A cell of a number: the shortest text that reads back as the same double; empty if not finite.
std::string csv_cell(double value);
/// A cell of text, quoted if necessary. Control characters are escaped as in TOML. A text that a
/// spreadsheet would read as a formula gets a leading '.
std::string csv_cell(std::string_view text);

/// Joins cells with commas and ends the line.
std::string csv_line(const std::vector<std::string>& cells);

/// "energy_normal_mean" in "J" is "energy_normal_mean_J"; a rate in "1/s" ends in "_per_s".
std::string column_name(std::string_view name, std::string_view unit);

}  // namespace mahlwerk::results
