// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/report/plot/laws.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {

/// Symbols and units of the axes of a law. Without a symbol it is x or y.
struct LawAxes {
  std::string x, x_unit, y;
  Multiple multiple;  ///< of the unit of y
};

/// The equation of a law and its R2, with marks as in plot.hpp: "$E_{c}$ = 1.03 mJ ($f$/17
/// Hz)^{1.99}, $R$² = 0.9999". The coefficients of lines and parabolas are in the units of the
/// axes.
std::string law_words(const FittedLaw& law, const LawAxes& axes);

}  // namespace mahlwerk::report
