// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mahlwerk::results {

/// Description of one column of a table.
struct Column {
  std::string name, unit, about;  ///< unit "1" for numbers without one; about: a description
  /// Column of words only: the words that the numbers 0, 1, ... stand for.
  std::vector<std::string> words = {};

  /// The number of a word. A new word is added.
  double number_of(std::string_view word);
};

/// Rows of numbers under columns with units. A missing number is NaN.
struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<double>> rows;
};

}  // namespace mahlwerk::results
