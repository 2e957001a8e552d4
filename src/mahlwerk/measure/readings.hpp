// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// Tables of numbers as instruments and video programs write them, with any separator and unit.
namespace mahlwerk::measure {

struct ReadingColumn {
  std::string name;            ///< "x1"; of a table without headings "1", "2", ...
  std::string unit;            ///< as written: "mm", "px"; empty: the heading has none
  std::vector<double> values;  ///< as written, NaN where a cell is empty
};

struct Readings {
  std::string file;                    ///< cited by faults
  std::vector<ReadingColumn> columns;  ///< at least one, with as many values each
  std::vector<int> lines;              ///< of the file, by row

  std::size_t rows() const { return lines.size(); }
  /// The column of one of these names, compared without case; null: none.
  const ReadingColumn* find(std::initializer_list<std::string_view> names) const;
};

/// Reads a table: columns separated by semicolons, tabs, commas or blanks, with decimal points or
/// (not between commas) decimal commas. The last line without numbers before the first row is that
/// of the headings, "x (mm)", "x [mm]" or "x/mm"; lines before it and after # are left out. A cell
/// may be empty or a time of day, "12:31:05.2", also with a date, which counts in s. `headings`, if
/// not empty, replaces the headings: "time (s), x (mm), y (mm)".
/// Throws InputError: no table, cells that are no numbers, rows of another length.
Readings read_readings(std::string_view text, const std::string& file,
                       std::string_view headings = {});

/// Contents of a file. Throws InputError if it is missing, empty, no file, or above `most` [byte].
std::string file_contents(const std::string& file, std::size_t most = std::size_t{1} << 28U);

/// The column in SI units. Throws InputError if its unit is missing or has another dimension than
/// `unit`, or if fewer than `least` cells hold a number.
std::vector<double> in_unit(const Readings& readings, const ReadingColumn& column,
                            std::string_view unit, std::size_t least = 1);

/// The fault of a file that lacks a column.
[[noreturn]] void missing_column(const Readings& readings, std::string_view name,
                                 std::string_view example);

}  // namespace mahlwerk::measure
