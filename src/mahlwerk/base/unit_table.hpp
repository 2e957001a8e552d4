// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "mahlwerk/base/units.hpp"

namespace mahlwerk {

/// SI value of a unit: numerator / denominator * (2 pi)^turns. Stored separately so that "600 rpm"
/// is exactly 10 Hz and "12 mm" is the double nearest to 0.012 m, without rounded intermediate
/// factors.
struct Scale {
  double numerator = 1, denominator = 1;  ///< integers without a common divisor
  int turns = 0;
};

/// One unit of the table.
struct Unit {
  std::string_view symbol;
  Scale scale;
  Dimension dimension;
};

/// Result of parsing a unit expression.
struct ParsedUnit {
  Scale scale;
  Dimension dimension;
};

/// All simple (not compound) units.
std::span<const Unit> all_units();

/// The multiples in which a value stored in `unit` is displayed, preferred one first; empty if
/// none.
std::span<const std::string_view> display_units(std::string_view unit);

/// Parses a unit expression: "mm", "kg/m3", "1/min", "J m/kg", "J/(kg K)". Throws UnitError.
ParsedUnit parse_unit(std::string_view text);

}  // namespace mahlwerk
