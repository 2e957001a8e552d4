// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

/// A unit for programs that convert values themselves: value in `si` = factor * number + offset.
struct ListedUnit {
  std::string_view symbol, si;    ///< "mm" and "m"; both are empty for a pure number
  double factor = 1, offset = 0;  ///< the offset is not 0 for degC alone
  bool offered = false;           ///< whether a menu offers it for a value in `si`
};
/// All simple units, degC, and the compound units that menus offer.
std::vector<ListedUnit> listed_units();

/// [m] Opening of the test sieve "No. `mesh`" of ASTM E11 ("200 mesh"), without a value for
/// numbers that the standard does not have.
std::optional<double> mesh_opening(double mesh);
/// The numbers of ASTM E11 on either side of one that it does not have: "170 mesh, 200 mesh".
std::string nearest_meshes(double mesh);

/// Parses a unit expression: "mm", "kg/m3", "1/min", "J m/kg", "J/(kg K)". Throws UnitError.
ParsedUnit parse_unit(std::string_view text);

}  // namespace mahlwerk
