// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The page of a calibration.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/report/calibration.hpp"
#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/parameters.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {
namespace {

std::string key_rows(const Calibration& found) {
  std::string rows;
  for (const FittedParameter& p : found.result.parameters)
    rows += fmt::format(
        "<tr><th scope=\"row\"><code>{}</code></th><td class=\"n\">{}</td><td class=\"n\">{}</td>"
        "<td class=\"n\">{} to {}</td></tr>\n",
        escaped(p.name), value_cell_text(p), escaped(p.interval_text()), escaped(p.text.least),
        escaped(p.text.most));
  return rows;
}

double place_of(const Calibration& found, const PredictedMeasurement& p) {
  return found.condition_values.empty() ? static_cast<double>(p.condition + 1)
                                        : found.condition_values[p.condition];
}

std::string axis_text(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} ({})", name, unit);
}

/// Measured values, the band of the calibrated model, and the runs at its central draw.
Plot predictions(const Calibration& found, const std::string& what) {
  std::vector<PredictedMeasurement> points;
  for (const PredictedMeasurement& p : found.points)
    if (p.name() == what) points.push_back(p);
  std::ranges::stable_sort(points, {}, [&](const auto& p) { return place_of(found, p); });
  double most = 0;
  for (const PredictedMeasurement& p : points)
    most = std::fmax(most, std::fmax(p.value, p.predicted.high));
  const Multiple up = multiple(most, points.front().unit());
  Series band{.name = "calibrated model", .band = true}, runs{.name = "runs at its centre"},
      measured{.name = "measured"};
  band.mark = Mark::points;
  band.colour = 0;
  runs.mark = Mark::dots;
  runs.colour = 1;
  measured.mark = Mark::squares;
  for (const PredictedMeasurement& p : points) {
    const double x = place_of(found, p);
    band.x.push_back(x);
    band.y.push_back(p.predicted.value / up.factor);
    band.low.push_back(p.predicted.low / up.factor);
    band.high.push_back(p.predicted.high / up.factor);
    runs.x.push_back(x);
    runs.y.push_back(p.simulated.mean / up.factor);
    runs.error.push_back(p.simulated.ci95 / up.factor);
    measured.x.push_back(x);
    measured.y.push_back(p.value / up.factor);
    measured.error.push_back(1.96 * p.error / up.factor);
  }
  return {.title = fmt::format("{}: measured and calibrated", what),
          .x = Axis{found.condition_values.empty()
                        ? "number of the condition"
                        : axis_text(found.condition_key, found.condition_unit)},
          .y = Axis{axis_text(what, up.unit)},
          .series = {band, runs, measured}};
}

/// Histogram of a key's posterior over its range.
Plot marginal(const FittedParameter& k) {
  constexpr int bins = 40;
  const double from = k.least, to = k.most;
  Series series{.name = "", .mark = Mark::steps};
  std::vector<double> count(bins, 0);
  for (const double value : k.posterior)
    count[static_cast<std::size_t>(
        std::clamp(static_cast<int>(bins * (value - from) / (to - from)), 0, bins - 1))] +=
        bins / static_cast<double>(k.posterior.size());
  for (int i = 0; i <= bins; ++i) series.x.push_back(from + (to - from) * i / bins);
  series.y = count;
  Series prior{.name = "before the measurements", .x = {from, to}, .y = {1, 1}, .colour = 6};
  series.name = "with the measurements";
  return {.title = fmt::format("Probability of {}", k.name),
          .x = Axis{axis_text(k.name, k.unit), false, from, to},
          .y = Axis{"density, by that of the range"},
          .series = {series, prior},
          .shape = 0.36};
}

/// Draws of two keys.
Plot pair_plot(const FittedParameter& a, const FittedParameter& b) {
  constexpr std::size_t most = 400;
  Series dots{.name = "", .mark = Mark::dots};
  const std::size_t step = std::max<std::size_t>(1, a.posterior.size() / most);
  for (std::size_t i = 0; i < a.posterior.size(); i += step) {
    dots.x.push_back(a.posterior[i]);
    dots.y.push_back(b.posterior[i]);
  }
  return {.title = fmt::format("{} and {}", a.name, b.name),
          .x = Axis{axis_text(a.name, a.unit)},
          .y = Axis{axis_text(b.name, b.unit)},
          .series = {dots},
          .shape = 0.44};
}

std::string figures(const Calibration& found) {
  const std::vector<FittedParameter>& keys = found.result.parameters;
  std::string text;
  std::vector<std::string> done;
  for (const PredictedMeasurement& p : found.points) {
    if (std::ranges::find(done, p.name()) != done.end()) continue;
    done.push_back(p.name());
    text += figure(predictions(found, p.name()),
                   found.errors_known
                       ? "Squares: measured, with 95 % of their errors. The band contains 95 % of "
                         "what the calibrated model predicts."
                       : "Squares: measured. The band contains 95 % of what the calibrated model "
                         "predicts.");
  }
  for (const FittedParameter& k : keys)
    text += figure(marginal(k), "What the measurements leave possible of the range.");
  for (std::size_t i = 0; i < keys.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (std::abs(found.result.correlation[i][k]) > 0.5)
        text += figure(pair_plot(keys[k], keys[i]),
                       fmt::format("Draws of both keys together; correlation {:.2f}.",
                                   found.result.correlation[i][k]));
  return text;
}

std::string point_rows(const Calibration& found) {
  std::string rows;
  for (const PredictedMeasurement& p : found.points) {
    const auto text = [&](double value, double half_width = NAN) {
      return escaped(readable(value, half_width, p.unit().empty() ? "1" : p.unit()).text());
    };
    rows += fmt::format(
        "<tr><td class=\"n\">{}</td><td>{}</td><td>{}</td><td class=\"n\">{}</td><td "
        "class=\"n\">{} to {}</td><td class=\"n\">{}</td></tr>\n",
        p.line, escaped(found.condition_name(p.condition)), escaped(p.name()),
        text(p.value, std::isnan(p.error) ? NAN : 1.96 * p.error), text(p.predicted.low),
        text(p.predicted.high), text(p.simulated.mean, p.simulated.ci95));
  }
  return rows;
}

}  // namespace

std::string calibration_page(const Calibration& found, std::string_view version) {
  std::string body = fmt::format(
      "<p class=\"lead\">{} key{} of {}, calibrated to {} measured values of {} with {} settings "
      "in "
      "{} runs.</p>\n",
      found.result.parameters.size(), found.result.parameters.size() == 1 ? "" : "s",
      escaped(found.case_file), found.points.size(), escaped(found.data_file),
      found.result.settings, found.runs);
  body += remark_boxes(found.result);
  body += notice_boxes(found.notices, static_cast<std::size_t>(found.runs), "run");
  body += fmt::format(
      "<h2>Calibrated keys</h2>\n<div class=\"wide\"><table>\n<thead><tr><th></th><th "
      "class=\"n\">value</th><th class=\"n\">95 % interval</th><th class=\"n\">range</th></tr>"
      "</thead>\n<tbody>\n{}</tbody>\n</table></div>\n",
      key_rows(found));
  body += note_box(escaped(how_to_read(found)), false);
  body += figures(found) + correlation_table(found.result, "keys", 2);
  body += fmt::format(
      "<h2>Measured and calibrated</h2>\n<div class=\"wide\"><table>\n<thead><tr><th "
      "class=\"n\">line</th><th>condition</th><th></th><th class=\"n\">measured</th><th "
      "class=\"n\">95 % band</th><th class=\"n\">runs at the centre</th></tr></thead>\n"
      "<tbody>\n{}</tbody>\n</table></div>\n",
      point_rows(found));
  return page(
      found.title.empty() ? "A calibration" : found.title, body,
      fmt::format("Mahlwerk {}. The numbers are in fit.json, fit.csv and posterior.csv, the "
                  "calibrated case with its uncertainty in calibrated.toml.",
                  escaped(version)));
}

}  // namespace mahlwerk::report
