// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/law_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mahlwerk::report {
namespace {

std::string signed_text(double value, int digits = 3) {
  return fmt::format("{}{:.{}g}", value < 0 ? "−" : "", std::abs(value), digits);
}

/// " + 3.4 f" or " − 3.4 f".
std::string term(double value, const std::string& factor) {
  return fmt::format(" {} {:.3g} {}", value < 0 ? "−" : "+", std::abs(value), factor);
}

/// R2 with the digits that distinguish it from 1.
std::string r_squared_text(double r_squared) {
  constexpr int usual = 4, most = 8;
  for (int digits = usual; digits <= most; ++digits) {
    const std::string text = fmt::format("{:.{}f}", r_squared, digits);
    if (!text.starts_with('1'))
      return "$R$² = " + (text.starts_with('-') ? "−" + text.substr(1) : text);
  }
  return "$R$² > 0.99999999";
}

}  // namespace

std::string law_words(const FittedLaw& law, const LawAxes& axes) {
  const std::string x = axes.x.empty() ? "$x$" : axes.x, y = axes.y.empty() ? "$y$" : axes.y;
  const std::vector<double>& c = law.coefficients;
  const double factor = axes.multiple.factor;
  std::string text;
  if (law.form == LawForm::power) {
    const std::string unit = axes.multiple.unit == "1"     ? ""
                             : axes.multiple.unit == "1/s" ? "/s"
                                                           : " " + axes.multiple.unit;
    text =
        fmt::format("{} = {}{} ({}/{:.6g}{}{})^{{{}}}", y, signed_text(c[0] / factor), unit, x,
                    law.reference, axes.x_unit.empty() ? "" : " ", axes.x_unit, signed_text(c[1]));
  } else {
    text = fmt::format("{} = {}{}", y, signed_text(c[0] / factor), term(c[1] / factor, x));
    if (law.form == LawForm::parabola) text += term(c[2] / factor, x + "²");
  }
  return text + ", " + r_squared_text(law.r_squared);
}

}  // namespace mahlwerk::report
