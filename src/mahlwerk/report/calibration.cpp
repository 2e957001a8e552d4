// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mahlwerk/report/aligned.hpp"
#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/csv.hpp"

namespace mahlwerk::report {

std::string CalibratedKey::interval_text() const {
  if (!determined) return "not determined";
  if (open_low) return "up to " + high;
  if (open_high) return low + " or more";
  return low + " to " + high;
}

bool CalibrationReport::all_determined() const {
  return std::ranges::all_of(keys, &CalibratedKey::determined);
}

std::string how_to_read(const CalibrationReport& found) {
  return fmt::format(
      "How to read it: if the model is right, the 95 % interval of a key contains the true value "
      "in 95 of 100 such data sets. {}{} A key that is not determined is not a result, whatever "
      "its "
      "value.",
      found.keys.size() > 1
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

std::string condition_name(const CalibrationReport& found, const CalibratedPoint& p) {
  const std::string& name = found.conditions[p.condition];
  return name.empty() ? "the case" : name;
}

}  // namespace

std::string calibration_table(const CalibrationReport& found) {
  std::vector<std::array<std::string, 4>> lines{{"key", "value", "95 % interval", ""}};
  for (const CalibratedKey& k : found.keys)
    lines.push_back({k.key, k.value, k.interval_text(), k.determined ? "" : "NOT DETERMINED"});
  std::string text = aligned(lines) + '\n';
  std::vector<std::array<std::string, 4>> rows{{"condition", "measured", "95 % band", "simulated"}};
  for (const CalibratedPoint& p : found.points)
    rows.push_back({condition_name(found, p) + ", " + p.what,
                    readable_text(p.measured, std::isnan(p.error) ? NAN : 1.96 * p.error, p.unit),
                    readable_text(p.low, NAN, p.unit) + " to " + readable_text(p.high, NAN, p.unit),
                    readable_text(p.simulated, p.ci95, p.unit)});
  text += aligned(rows) + '\n';
  for (const CalibratedKey& k : found.keys)
    for (const std::string& remark : k.remarks) text += fmt::format("{}: {}.\n", k.key, remark);
  for (const std::string& remark : found.remarks) text += remark + ".\n";
  text += fmt::format("{} values under {} condition{}, {} settings in {} runs", found.points.size(),
                      found.conditions.size(), found.conditions.size() == 1 ? "" : "s",
                      found.settings, found.runs);
  if (std::isfinite(found.misfit)) text += fmt::format(", misfit {:.2g} errors", found.misfit);
  for (const double scatter : found.scatter)
    text += fmt::format(", scatter {:.2g} %", 100 * scatter);
  const std::string warned =
      notice_lines(found.notices, static_cast<std::size_t>(found.runs), "run");
  return text + ".\n\n" + warned + (warned.empty() ? "" : "\n") + how_to_read(found) + "\n";
}

std::string calibration_csv(const CalibrationReport& found) {
  std::string text = results::csv_line({"line", "condition", "what", "unit", "fall_m", "measured",
                                        "error", "predicted", "predicted_low", "predicted_high",
                                        "simulated", "simulated_ci95"});
  for (const CalibratedPoint& p : found.points) {
    std::vector<std::string> cells{
        std::to_string(p.line), results::csv_cell(std::string_view(found.conditions[p.condition])),
        results::csv_cell(std::string_view(p.what)), results::csv_cell(std::string_view(p.unit)),
        p.fall > 0 ? results::csv_cell(p.fall) : ""};
    for (const double number :
         {p.measured, p.error, p.predicted, p.low, p.high, p.simulated, p.ci95})
      cells.push_back(results::csv_cell(number));
    text += results::csv_line(cells);
  }
  return text;
}

std::string posterior_csv(const CalibrationReport& found) {
  std::vector<std::string> names;
  for (const CalibratedKey& k : found.keys)
    names.push_back(k.unit.empty() ? k.key : fmt::format("{} ({})", k.key, k.unit));
  std::string text = results::csv_line(names);
  for (std::size_t i = 0; i < found.keys.front().posterior.size(); ++i) {
    std::vector<std::string> cells;
    for (const CalibratedKey& k : found.keys) cells.push_back(results::csv_cell(k.posterior[i]));
    text += results::csv_line(cells);
  }
  return text;
}

}  // namespace mahlwerk::report
