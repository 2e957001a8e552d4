// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/report/aligned.hpp"
#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/csv.hpp"

namespace mahlwerk::report {
namespace {

/// Number of digits with which two different numbers are shown as different.
int digits_for(double low, double high) {
  const double apart = std::abs(high - low), size = std::fmax(std::abs(low), std::abs(high));
  if (!(apart > 0) || !(size > 0)) return 4;
  return std::clamp(2 + static_cast<int>(std::ceil(std::log10(size / apart))), 3, 8);
}

}  // namespace

std::string FitParameter::value_text() const {
  return show_rounded(value, unit, digits_for(low, high));
}

std::string FitParameter::interval_text() const {
  const int digits = digits_for(low, high);
  if (!determined) return "not determined";
  if (open_low) return "up to " + show_rounded(high, unit, digits);
  if (open_high) return show_rounded(low, unit, digits) + " or more";
  return show_rounded(low, unit, digits) + " to " + show_rounded(high, unit, digits);
}

bool FitReport::all_determined() const {
  return std::ranges::all_of(parameters, &FitParameter::determined);
}

std::string how_to_read(const FitReport& fit) {
  const char* residuals =
      fit.errors_known
          ? "Residuals are in units of the measurement errors; a good fit has a scatter of about 1."
          : "No measurement errors are given: the scatter is estimated from the data. "
            "Residuals of sizes and surfaces are relative, those of shares are differences.";
  return fmt::format(
      "How to read it: the 95 % interval of a parameter contains all values that are compatible "
      "with the data if the other parameters are refitted. If the model is right, it contains the "
      "true value in 95 of 100 such data sets. {} A parameter that is not determined is not a "
      "result, whatever its value.",
      residuals);
}

std::string fit_table(const FitReport& fit) {
  std::vector<std::array<std::string, 4>> lines{{"parameter", "value", "95 % interval", ""}};
  for (const FitParameter& n : fit.parameters)
    lines.push_back(
        {n.key, n.value_text(), n.interval_text(), n.determined ? "" : "NOT DETERMINED"});
  std::string text = aligned(lines) + '\n';
  for (const FitParameter& n : fit.parameters)
    for (const std::string& remark : n.remarks) text += fmt::format("{}: {}.\n", n.key, remark);
  for (const std::string& remark : fit.remarks) text += remark + ".\n";
  text += fmt::format("{} values under {} condition{}, {} degree{} of freedom", fit.points.size(),
                      fit.conditions.size(), fit.conditions.size() == 1 ? "" : "s",
                      fit.degrees_of_freedom, fit.degrees_of_freedom == 1 ? "" : "s");
  if (std::isfinite(fit.scatter))
    text += fit.errors_known ? fmt::format(", scatter {:.3g} errors", fit.scatter)
                             : fmt::format(", scatter {:.3g} %", 100 * fit.scatter);
  const std::string warned = notice_lines(fit.notices, fit.conditions.size(), "condition");
  return text + ".\n\n" + warned + (warned.empty() ? "" : "\n") + how_to_read(fit) + "\n";
}

std::string fit_csv(const FitReport& fit) {
  std::string text = results::csv_line({"line", "condition", "what", "unit", "time_s", "size_m",
                                        "measured", "error", "fitted", "residual"});
  for (const FitPoint& p : fit.points) {
    std::vector<std::string> cells{std::to_string(p.line),
                                   results::csv_cell(std::string_view(fit.conditions[p.condition])),
                                   results::csv_cell(std::string_view(p.what)),
                                   results::csv_cell(std::string_view(p.unit)),
                                   results::csv_cell(p.time),
                                   p.size > 0 ? results::csv_cell(p.size) : ""};
    for (const double number : {p.measured, p.error, p.fitted, p.residual})
      cells.push_back(results::csv_cell(number));
    text += results::csv_line(cells);
  }
  return text;
}

}  // namespace mahlwerk::report
