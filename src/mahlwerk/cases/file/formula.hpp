// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "mahlwerk/base/units.hpp"

// Values of a case that follow from others: "5 ml / (pi/4 * jar.diameter^2)".
namespace mahlwerk::cases {

/// What is wrong with a formula; complete without a place.
class FormulaError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The value of a dotted key, or of "gravity"; throws FormulaError where there is none.
using ValueOf = std::function<Quantity(std::string_view key)>;

/// Sums, differences, products, quotients, powers, brackets, pi, sqrt, cbrt, abs, min and max over
/// numbers with units and keys of the case. Units must fit: throws FormulaError, saying where.
Quantity evaluate(std::string_view formula, const ValueOf& value_of);

/// In SI units, so that a case can hold it: "0.0442 m". Throws FormulaError for what is not finite.
std::string text_of(const Quantity& quantity);

}  // namespace mahlwerk::cases
