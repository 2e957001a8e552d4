// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace mahlwerk {

/// Exponents of the base dimensions. An angle is a dimension of its own, so that 400 rpm is never
/// 41.9 Hz: a turn is 2 pi rad, 1 Hz is one turn (cycle) per second (con.4).
struct Dimension {
  std::int8_t length = 0, mass = 0, time = 0, temperature = 0, angle = 0;
  bool operator==(const Dimension&) const = default;
};

/// A value in SI units (rad for angles) with its dimension.
struct Quantity {
  double value = 0;
  Dimension dimension;
};

/// What is wrong with a text that should be a quantity; its message is complete without a place.
class UnitError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads "400 rpm", "15 mm", "7850 kg/m3", "0.35", "30 %". Throws UnitError naming the text, what
/// is wrong, and the nearest known unit.
Quantity parse_quantity(std::string_view text);

/// Reads `text` and returns its value measured in `unit` ("m", "Hz", "rad/s", "kg/m3", "degC", ""
/// for a pure number). "600 rpm" in "Hz" is 10, in "rad/s" 62.83. Throws UnitError when the unit is
/// missing or of another dimension, with an example of what is expected.
double parse_in(std::string_view text, std::string_view unit);

/// Writes `value`, measured in `unit`, so that parse_in(show(value, unit), unit) == value to the
/// last bit, in the most readable multiple that allows it ("12 mm" rather than "0.012 m").
std::string show(double value, std::string_view unit);

/// Writes `value`, measured in `unit`, to `digits` significant digits in a readable multiple; for
/// people, not for reading back.
std::string show_rounded(double value, std::string_view unit, int digits = 4);
/// A plain number to two digits, without a power of ten up to 15 places: "0.062", "3.5", "950000".
std::string two_digits(double value);

/// A quantity as one would write it where `unit` is expected: "12 mm" for "m", "400 rpm" for
/// "rad/s".
std::string example_of(std::string_view unit);

/// The shortest decimal text that reads back as the same double, whatever the locale.
std::string shortest(double value);

}  // namespace mahlwerk
