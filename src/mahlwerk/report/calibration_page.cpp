// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The page of a calibration.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/report/calibration.hpp"
#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {
namespace {

std::string key_rows(const CalibrationReport& found) {
  std::string rows;
  for (const CalibratedKey& k : found.keys)
    rows += fmt::format(
        "<tr><th scope=\"row\"><code>{}</code></th><td class=\"n\">{}</td><td class=\"n\">{}</td>"
        "<td class=\"n\">{} to {}</td></tr>\n",
        escaped(k.key), k.determined ? escaped(k.value) : "<s>" + escaped(k.value) + "</s>",
        escaped(k.interval_text()), escaped(k.from), escaped(k.to));
  return rows;
}

std::string remarks(const CalibrationReport& found) {
  std::string text;
  for (const CalibratedKey& k : found.keys) {
    std::string words;
    for (const std::string& remark : k.remarks)
      words += (words.empty() ? " " : "; ") + escaped(remark);
    if (!words.empty()) words += ".";
    if (!k.determined)
      text += note_box(
          fmt::format("<b>The data do not determine <code>{}</code>:</b>{}", escaped(k.key), words),
          true);
    else if (!words.empty())
      text += note_box(fmt::format("<code>{}</code>:{}", escaped(k.key), words), false);
  }
  for (const std::string& remark : found.remarks) text += note_box(escaped(remark) + ".", true);
  return text;
}

/// Position of a condition on the x axis.
double place_of(const CalibrationReport& found, const CalibratedPoint& p) {
  return found.condition_values.empty() ? static_cast<double>(p.condition + 1)
                                        : found.condition_values[p.condition];
}

std::string axis_text(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} ({})", name, unit);
}

/// Measured values, the band of the calibrated model, and the runs at its central draw.
Plot predictions(const CalibrationReport& found, const std::string& what) {
  std::vector<CalibratedPoint> points;
  for (const CalibratedPoint& p : found.points)
    if (p.what == what) points.push_back(p);
  std::ranges::stable_sort(points, {}, [&](const auto& p) { return place_of(found, p); });
  double most = 0;
  for (const CalibratedPoint& p : points) most = std::fmax(most, std::fmax(p.measured, p.high));
  const Multiple up = multiple(most, points.front().unit);
  Series band{.name = "calibrated model", .band = true}, runs{.name = "runs at its centre"},
      measured{.name = "measured"};
  band.mark = Mark::points;
  band.colour = 0;
  runs.mark = Mark::dots;
  runs.colour = 1;
  measured.mark = Mark::squares;
  for (const CalibratedPoint& p : points) {
    const double x = place_of(found, p);
    band.x.push_back(x);
    band.y.push_back(p.predicted / up.factor);
    band.low.push_back(p.low / up.factor);
    band.high.push_back(p.high / up.factor);
    runs.x.push_back(x);
    runs.y.push_back(p.simulated / up.factor);
    runs.error.push_back(p.ci95 / up.factor);
    measured.x.push_back(x);
    measured.y.push_back(p.measured / up.factor);
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
Plot marginal(const CalibratedKey& k) {
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
  return {.title = fmt::format("Probability of {}", k.key),
          .x = Axis{axis_text(k.key, k.unit), false, from, to},
          .y = Axis{"density, by that of the range"},
          .series = {series, prior},
          .height = 260};
}

/// Draws of two keys.
Plot pair_plot(const CalibratedKey& a, const CalibratedKey& b) {
  constexpr std::size_t most = 400;
  Series dots{.name = "", .mark = Mark::dots};
  const std::size_t step = std::max<std::size_t>(1, a.posterior.size() / most);
  for (std::size_t i = 0; i < a.posterior.size(); i += step) {
    dots.x.push_back(a.posterior[i]);
    dots.y.push_back(b.posterior[i]);
  }
  return {.title = fmt::format("{} and {}", a.key, b.key),
          .x = Axis{axis_text(a.key, a.unit)},
          .y = Axis{axis_text(b.key, b.unit)},
          .series = {dots},
          .height = 320};
}

std::string figures(const CalibrationReport& found) {
  std::string text;
  std::vector<std::string> done;
  for (const CalibratedPoint& p : found.points) {
    if (std::ranges::find(done, p.what) != done.end()) continue;
    done.push_back(p.what);
    text += figure(predictions(found, p.what),
                   found.errors_known
                       ? "Squares: measured, with 95 % of their errors. The band contains 95 % of "
                         "what the calibrated model predicts."
                       : "Squares: measured. The band contains 95 % of what the calibrated model "
                         "predicts.");
  }
  for (const CalibratedKey& k : found.keys)
    text += figure(marginal(k), "What the measurements leave possible of the range.");
  for (std::size_t i = 0; i < found.keys.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (std::abs(found.correlation[i][k]) > 0.5)
        text += figure(pair_plot(found.keys[k], found.keys[i]),
                       fmt::format("Draws of both keys together; correlation {:.2f}.",
                                   found.correlation[i][k]));
  return text;
}

std::string correlation(const CalibrationReport& found) {
  if (found.keys.size() < 2) return "";
  std::string head, rows;
  for (std::size_t i = 0; i < found.keys.size(); ++i) {
    const std::string key = escaped(found.keys[i].key);
    head += fmt::format("<th class=\"n\"><code>{}</code></th>", key);
    rows += fmt::format("<tr><th scope=\"row\"><code>{}</code></th>", key);
    for (const double c : found.correlation[i])
      rows += fmt::format("<td class=\"n\">{:.2f}</td>", c);
    rows += "</tr>\n";
  }
  return fmt::format(
      "<h2>Correlation of the keys</h2>\n<div class=\"wide\"><table>\n<thead><tr><th></th>{}"
      "</tr></thead>\n<tbody>\n{}</tbody>\n</table></div>\n",
      head, rows);
}

std::string point_rows(const CalibrationReport& found) {
  std::string rows;
  for (const CalibratedPoint& p : found.points) {
    const auto text = [&](double value, double half_width = NAN) {
      return escaped(readable(value, half_width, p.unit.empty() ? "1" : p.unit).text());
    };
    const std::string& condition = found.conditions[p.condition];
    rows += fmt::format(
        "<tr><td class=\"n\">{}</td><td>{}</td><td>{}</td><td class=\"n\">{}</td><td "
        "class=\"n\">{} to {}</td><td class=\"n\">{}</td></tr>\n",
        p.line, condition.empty() ? "the case" : escaped(condition), escaped(p.what),
        text(p.measured, std::isnan(p.error) ? NAN : 1.96 * p.error), text(p.low), text(p.high),
        text(p.simulated, p.ci95));
  }
  return rows;
}

}  // namespace

std::string calibration_page(const CalibrationReport& found, std::string_view version) {
  std::string body = fmt::format(
      "<p class=\"lead\">{} key{} of {}, calibrated to {} measured values of {} with {} settings "
      "in "
      "{} runs.</p>\n",
      found.keys.size(), found.keys.size() == 1 ? "" : "s", escaped(found.case_file),
      found.points.size(), escaped(found.data_file), found.settings, found.runs);
  body += remarks(found);
  body += notice_boxes(found.notices, static_cast<std::size_t>(found.runs), "run");
  body += fmt::format(
      "<h2>Calibrated keys</h2>\n<div class=\"wide\"><table>\n<thead><tr><th></th><th "
      "class=\"n\">value</th><th class=\"n\">95 % interval</th><th class=\"n\">range</th></tr>"
      "</thead>\n<tbody>\n{}</tbody>\n</table></div>\n",
      key_rows(found));
  body += note_box(escaped(how_to_read(found)), false);
  body += figures(found) + correlation(found);
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
