// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "mahlwerk/base/field.hpp"

// Which numbers are admitted, whatever file they come from.
namespace mahlwerk {

/// A column of a file of numbers, for users and readers.
struct FileColumn {
  std::string_view name;
  std::string_view unit;  ///< in which its numbers are stored
  Range range = any_number;
};

/// "at least 0 mm and at most 1 m"; empty if every number is in the range.
std::string range_text(const Range& range, std::string_view unit);

/// What is wrong with a number in `unit`: "out of range: it must be above 0", or "beyond all that a
/// mill has: 1000 km at most" or, where it must not be 0, "1 pm at least", with which sizes of
/// grids and numbers of steps would overflow. Empty if the number is admitted.
std::string refusal(double value, const Range& range, std::string_view unit);
inline std::string refusal(double value, const FileColumn& column) {
  return refusal(value, column.range, column.unit);
}

/// Whether a share that is out of its range would be in it as a percentage.
bool is_percentage(double value, const Range& range, std::string_view unit);

/// The least and largest plausible magnitude of a value of a case in `unit`: as written, or that of
/// the unit whatever the key; 0 and infinity if there is neither. Beyond them a unit or a digit is
/// probably wrong.
std::array<double, 2> plausible_magnitude(std::string_view unit, const PlausibleMagnitude& written);

}  // namespace mahlwerk
