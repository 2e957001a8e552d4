// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

// Simple laws fitted to the points of a curve (docs/theory/campaigns.md, "Fitted laws").
namespace mahlwerk::report {

enum class LawForm {
  line,     ///< y = a + b x
  power,    ///< y = c (x/x0)^p
  parabola  ///< y = a + b x + c x^2
};

/// Name of the law: "straight line".
std::string_view name_of(LawForm form);

/// A fitted law and its goodness of fit.
struct FittedLaw {
  LawForm form = LawForm::line;
  std::vector<double> coefficients = {};  ///< a, b; c, p; a, b, c
  std::vector<double> ci95 = {};  ///< their half-widths (cam.23); NaN without degrees of freedom
  double reference = 1;           ///< of a power law: x0, near the middle of x
  double r_squared = 0;           ///< (cam.24)
  double adjusted = 0;            ///< R^2 adjusted for the number of coefficients (cam.25)
  double aicc = 0;                ///< (cam.26); NaN with too few points
  double at(double x) const;
};

/// Fits the laws by weighted least squares (cam.20 to cam.23). Half-widths of y give the weights if
/// all are positive, else all weights are equal. Points with a non-finite x or y are ignored. A
/// power law requires positive x and y. A law needs one point more than it has coefficients; no law
/// is fitted to fewer than four different x or to constant y.
std::vector<FittedLaw> fitted_laws(const std::vector<double>& x, const std::vector<double>& y,
                                   const std::vector<double>& ci95);

/// Model selection among fitted laws.
struct LawSelection {
  std::size_t best = 0;                 ///< among `laws`
  std::vector<std::size_t> equivalent;  ///< others that cannot be distinguished from it (cam.27)
  bool by_aicc = true;                  ///< else by adjusted R^2 (too few points)
};
LawSelection select_law(const std::vector<FittedLaw>& laws);

/// Whether the interval of a straight line's intercept contains 0.
bool through_origin(const FittedLaw& law);

}  // namespace mahlwerk::report
