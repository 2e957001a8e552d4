// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "mahlwerk/base/units.hpp"

namespace mahlwerk {

/// The size of a unit in SI: numerator / denominator * (2 pi)^turns. Kept apart so that "600 rpm"
/// is 10 Hz and "12 mm" is the double nearest to 0.012 m, without detours through rounded factors.
struct Scale {
  double numerator = 1, denominator = 1;  ///< whole numbers without a common divisor
  int turns = 0;
};

/// One unit of the table.
struct Unit {
  std::string_view symbol;
  Scale scale;
  Dimension dimension;
};

/// A unit as an expression gives it.
struct ParsedUnit {
  Scale scale;
  Dimension dimension;
};

/// Every simple unit there is.
std::span<const Unit> all_units();

/// The multiples a value kept in `unit` is shown in, the one people like best first.
std::span<const std::string_view> display_units(std::string_view unit);

/// Reads "mm", "kg/m3", "1/min", "J m/kg", "J/(kg K)". Throws UnitError.
ParsedUnit parse_unit(std::string_view text);

}  // namespace mahlwerk
