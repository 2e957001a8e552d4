// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

// Plain laws put through the points of a curve (docs/theory/campaigns.md, "Fitted laws").
namespace mahlwerk::report {

enum class LawForm {
  line,     ///< y = a + b x
  power,    ///< y = c (x/x0)^p
  parabola  ///< y = a + b x + c x^2
};

/// The same in words: "straight line".
std::string_view name_of(LawForm form);

/// One law and how well it describes the points it was fitted to.
struct FittedLaw {
  LawForm form = LawForm::line;
  std::vector<double> coefficients = {};  ///< a, b; c, p; a, b, c
  std::vector<double> ci95 = {};  ///< their half-widths (cam.23); NaN with no point to spare
  double reference = 1;           ///< x0, about the middle of x; of a power law
  double r_squared = 0;           ///< (cam.24)
  double adjusted = 0;            ///< R^2 with the number of coefficients paid for (cam.25)
  double aicc = 0;                ///< (cam.26); NaN where there are too few points for it
  double at(double x) const;
};

/// The laws that the points allow, each by (weighted) least squares (cam.20 to cam.23). Half-widths
/// of y weigh the points if every one of them has one above 0, else all weigh the same. Points with
/// an x or y that is no number are left out. A power law takes positive x and y alone; each law
/// takes a point more than it has coefficients, and no law is fitted to fewer than four different x
/// or to a y that is the same everywhere.
std::vector<FittedLaw> fitted_laws(const std::vector<double>& x, const std::vector<double>& y,
                                   const std::vector<double>& ci95);

/// Which of the laws describes the points best.
struct LawSelection {
  std::size_t best = 0;                 ///< among `laws`
  std::vector<std::size_t> equivalent;  ///< others that cannot be told from it (cam.27)
  bool by_aicc = true;                  ///< else by adjusted R^2, for too few points
};
LawSelection select_law(const std::vector<FittedLaw>& laws);

/// The interval of a line's intercept holds 0.
bool through_origin(const FittedLaw& law);

}  // namespace mahlwerk::report
