// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/calibration.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "mahlwerk/report/aligned.hpp"
#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/report/parameters.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/csv.hpp"

namespace mahlwerk::report {

std::string how_to_read(const Calibration& found) {
  return fmt::format(
      "How to read it: if the model is right, the 95 % interval of a key contains the true value "
      "in 95 of 100 such data sets. {}{} A key that is not determined is not a result, whatever "
      "its "
      "value.",
      found.result.parameters.size() > 1
          ? "The keys are correlated: use them together, as calibrated.toml does. "
          : "",
      found.errors_known
          ? "The band of a prediction is that of the calibrated model, without the measurement "
            "error."
          : "No measurement errors are given: their scatter is estimated with the keys.");
}

namespace {

std::string readable_text(double value, double half_width, const std::string& unit) {
  return readable(value, half_width, unit.empty() ? "1" : unit).text();
}

}  // namespace

std::string calibration_table(const Calibration& found) {
  std::string text = parameter_table(found.result, "key") + '\n';
  std::vector<std::array<std::string, 4>> rows{{"condition", "measured", "95 % band", "simulated"}};
  for (const PredictedMeasurement& p : found.points)
    rows.push_back({found.condition_name(p.condition) + ", " + p.name(),
                    readable_text(p.value, std::isnan(p.error) ? NAN : 1.96 * p.error, p.unit()),
                    readable_text(p.predicted.low, NAN, p.unit()) + " to " +
                        readable_text(p.predicted.high, NAN, p.unit()),
                    readable_text(p.simulated.mean, p.simulated.ci95, p.unit())});
  text += aligned(rows) + '\n';
  text += remark_lines(found.result);
  text += fmt::format("{} values under {} condition{}, {} settings in {} runs", found.points.size(),
                      found.conditions.size(), found.conditions.size() == 1 ? "" : "s",
                      found.result.settings, found.runs);
  if (std::isfinite(found.result.misfit))
    text += fmt::format(", misfit {:.2g} errors", found.result.misfit);
  for (const double scatter : found.result.scatter)
    text += fmt::format(", scatter {:.2g} %", 100 * scatter);
  const std::string warned =
      notice_lines(found.notices, static_cast<std::size_t>(found.runs), "run");
  return text + ".\n\n" + warned + (warned.empty() ? "" : "\n") + how_to_read(found) + "\n";
}

std::string calibration_csv(const Calibration& found) {
  std::string text = results::csv_line({"line", "condition", "what", "unit", "fall_m", "measured",
                                        "error", "predicted", "predicted_low", "predicted_high",
                                        "simulated", "simulated_ci95"});
  for (const PredictedMeasurement& p : found.points) {
    std::vector<std::string> cells{
        std::to_string(p.line), results::csv_cell(std::string_view(found.conditions[p.condition])),
        results::csv_cell(p.name()), results::csv_cell(p.unit()),
        p.fall > 0 ? results::csv_cell(p.fall) : ""};
    for (const double number : {p.value, p.error, p.predicted.value, p.predicted.low,
                                p.predicted.high, p.simulated.mean, p.simulated.ci95})
      cells.push_back(results::csv_cell(number));
    text += results::csv_line(cells);
  }
  return text;
}

std::string posterior_csv(const Calibration& found) {
  const std::vector<FittedParameter>& parameters = found.result.parameters;
  std::vector<std::string> names;
  for (const FittedParameter& p : parameters)
    names.push_back(p.unit.empty() ? p.name : fmt::format("{} ({})", p.name, p.unit));
  std::string text = results::csv_line(names);
  for (std::size_t i = 0; i < parameters.front().posterior.size(); ++i) {
    std::vector<std::string> cells;
    for (const FittedParameter& p : parameters) cells.push_back(results::csv_cell(p.posterior[i]));
    text += results::csv_line(cells);
  }
  return text;
}

}  // namespace mahlwerk::report
