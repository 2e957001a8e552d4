// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/fit.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/report/parameters.hpp"
#include "mahlwerk/results/files/csv.hpp"

namespace mahlwerk::report {
std::string how_to_read(const Fit& fit) {
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

std::string fit_table(const Fit& fit) {
  std::string text = parameter_table(fit.result, "parameter") + '\n' + remark_lines(fit.result);
  text += fmt::format("{} values under {} condition{}, {} degree{} of freedom", fit.points.size(),
                      fit.conditions.size(), fit.conditions.size() == 1 ? "" : "s",
                      fit.result.degrees_of_freedom, fit.result.degrees_of_freedom == 1 ? "" : "s");
  if (std::isfinite(fit.result.scatter))
    text += fit.errors_known ? fmt::format(", scatter {:.3g} errors", fit.result.scatter)
                             : fmt::format(", scatter {:.3g} %", 100 * fit.result.scatter);
  const std::string warned = notice_lines(fit.notices, fit.conditions.size(), "condition");
  return text + ".\n\n" + warned + (warned.empty() ? "" : "\n") + how_to_read(fit) + "\n";
}

std::string fit_csv(const Fit& fit) {
  std::string text = results::csv_line({"line", "condition", "what", "unit", "time_s", "size_m",
                                        "measured", "error", "fitted", "residual"});
  for (const PredictedMeasurement& p : fit.points) {
    std::vector<std::string> cells{std::to_string(p.line),
                                   results::csv_cell(std::string_view(fit.conditions[p.condition])),
                                   results::csv_cell(p.name()),
                                   results::csv_cell(p.unit()),
                                   results::csv_cell(p.time),
                                   p.size > 0 ? results::csv_cell(p.size) : ""};
    for (const double number : {p.value, p.error, p.predicted.value, p.residual})
      cells.push_back(results::csv_cell(number));
    text += results::csv_line(cells);
  }
  return text;
}

}  // namespace mahlwerk::report
