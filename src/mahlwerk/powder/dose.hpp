// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"

// Conversion by a dose of energy: a reaction or a property.
namespace mahlwerk::powder {

/// Conversion by dose (dos.1): first-order with the exponent 1, Avrami-like with others.
struct Conversion {
  double dose_constant = 0;  ///< [J/kg] > 0 dose beyond the onset that converts 63.2 %
  double exponent = 1;       ///< [1] > 0
  double onset = 0;          ///< [J/kg] >= 0 dose below which the conversion is 0

  /// [1] Conversion by a `dose` [J/kg] >= 0 (dos.1).
  double at(double dose) const {
    const double beyond = std::max(dose - onset, 0.0);
    return -math::expm1(-math::pow(beyond / dose_constant, exponent));
  }
  bool operator==(const Conversion&) const = default;
};

}  // namespace mahlwerk::powder
