// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "mahlwerk/base/units.hpp"

// Formulas for values of a case that follow from others: "5 ml / (pi/4 * jar.diameter^2)".
namespace mahlwerk::cases {

/// An error in a formula; the message does not name the place.
class FormulaError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns the value of a dotted key, or of "gravity"; throws FormulaError if there is none.
using ValueOf = std::function<Quantity(std::string_view key)>;

/// Evaluates a formula of numbers with units and keys of the case, with + - * / ^, brackets, pi,
/// sqrt, cbrt, abs, min and max. Throws FormulaError for a syntax error or units that do not match.
Quantity evaluate(std::string_view formula, const ValueOf& value_of);

/// The quantity in SI units, as written in a case: "0.0442 m". Throws FormulaError if it is not
/// finite.
std::string text_of(const Quantity& quantity);

}  // namespace mahlwerk::cases
