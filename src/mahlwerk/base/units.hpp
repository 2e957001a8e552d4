// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "mahlwerk/base/field.hpp"

namespace mahlwerk {

/// Exponents of the base dimensions. Angle is a base dimension, so that 400 rpm is never read as
/// 41.9 Hz: a turn is 2 pi rad, 1 Hz is one turn (cycle) per second (con.4).
struct Dimension {
  std::int8_t length = 0, mass = 0, time = 0, temperature = 0, angle = 0, amount = 0;
  bool operator==(const Dimension&) const = default;
};

/// A value in SI units (rad for angles) with its dimension.
struct Quantity {
  double value = 0;
  Dimension dimension;
};

/// A text is not a valid quantity. The message is complete without the location in the input.
class UnitError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Parses "400 rpm", "15 mm", "7850 kg/m3", "0.35", "30 %". Throws UnitError that names the text,
/// the fault and the nearest known unit.
Quantity parse_quantity(std::string_view text);

/// Parses `text` and returns its value in `unit` ("m", "Hz", "rad/s", "kg/m3", "degC", "" for a
/// pure number). "600 rpm" in "Hz" is 10, in "rad/s" 62.83. Throws UnitError, with an example, if
/// the unit is missing or has another dimension.
double parse_in(std::string_view text, std::string_view unit);

/// Formats `value`, given in `unit`, in the most readable multiple ("12 mm" rather than "0.012 m")
/// for which parse_in(show(value, unit), unit) == value to the last bit.
std::string show(double value, std::string_view unit);

/// Formats `value`, given in `unit`, to `digits` significant digits in a readable multiple; for
/// display only.
std::string show_rounded(double value, std::string_view unit, int digits = 4);
/// Formats a number to two significant digits, without an exponent up to 15 places: "0.062", "3.5",
/// "950000".
std::string two_digits(double value);

/// An example of a quantity in input that expects `unit`: "12 mm" for "m", "400 rpm" for "rad/s".
std::string example_of(std::string_view unit);

/// The shortest decimal text that reads back as the same double, independent of the locale.
std::string shortest(double value);

}  // namespace mahlwerk
