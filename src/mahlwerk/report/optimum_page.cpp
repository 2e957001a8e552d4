// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The page of a search for the best settings.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/report/optimum.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {
namespace {

/// The multiple of the unit that suits all drawn values.
Multiple multiple_of(const Optimum& found) {
  double most = 0;
  for (const Trial& s : found.trials)
    if (std::isfinite(s.outcome(0).mean)) most = std::fmax(most, std::abs(s.outcome(0).mean));
  return multiple(most, found.outcome.unit);
}

std::string with_unit(const std::string& what, const std::string& unit) {
  return unit.empty() || unit == "1" ? what : fmt::format("{} ({})", what, unit);
}

/// Settings in the order in which they were tried, and the best so far by the final model.
Plot history(const Optimum& found) {
  const Multiple up = multiple_of(found);
  Series tried{.name = "settings tried", .mark = Mark::dots}, best{.name = "best so far"};
  best.mark = Mark::line;
  for (std::size_t i = 0; i < found.trials.size(); ++i) {
    const Trial& s = found.trials[i];
    if (!s.failure.empty() || !std::isfinite(s.outcome(0).mean)) continue;
    tried.x.push_back(static_cast<double>(i + 1));
    tried.y.push_back(s.outcome(0).mean / up.factor);
    tried.error.push_back(std::isfinite(s.outcome(0).ci95) ? s.outcome(0).ci95 / up.factor : 0);
  }
  double until = NAN;
  for (std::size_t i = 0; i < found.trials.size(); ++i) {
    const Trial& s = found.trials[i];
    if (s.failure.empty() && s.probability_feasible >= 0.5) {
      const double now = s.model.mean / up.factor;
      until = found.maximise ? std::fmax(until, now) : std::fmin(until, now);
    }
    if (std::isnan(until)) continue;  // none so far
    best.x.push_back(static_cast<double>(i + 1));
    best.y.push_back(until);
  }
  return {.title = "Settings tried",
          .x = Axis{"setting number"},
          .y = Axis{with_unit(label(found.outcome.name), up.unit)},
          .series = {tried, best}};
}

/// A slice of the model through its optimum along a key, and all settings.
Plot slice(const Optimum& found, std::size_t key) {
  const Multiple up = multiple_of(found);
  const KeyOptimum& k = found.keys[key];
  Series mean{.name = "model, other keys at its optimum"},
      low{.name = "95 % interval of the model", .colour = 6};
  Series high{.name = "", .colour = 6}, tried{.name = "settings tried", .mark = Mark::dots};
  tried.colour = 1;
  for (std::size_t i = 0; i < k.x.size(); ++i) {
    for (Series* s : {&mean, &low, &high}) s->x.push_back(k.x[i]);
    mean.y.push_back(k.slice[i].mean / up.factor);
    low.y.push_back((k.slice[i].mean - k.slice[i].ci95) / up.factor);
    high.y.push_back((k.slice[i].mean + k.slice[i].ci95) / up.factor);
  }
  for (const Trial& s : found.trials) {
    if (!s.failure.empty() || !std::isfinite(s.outcome(0).mean)) continue;
    tried.x.push_back(s.x[key]);
    tried.y.push_back(s.outcome(0).mean / up.factor);
  }
  return {.title = fmt::format("{} over {}", label(found.outcome.name), k.key),
          .x = Axis{.label = with_unit(k.key, k.unit),
                    .logarithmic = k.logarithmic,
                    .least = k.x.front(),
                    .most = k.x.back()},
          .y = {with_unit(label(found.outcome.name), up.unit)},
          .series = {low, high, mean, tried}};
}

constexpr std::array<std::string_view, 5> key_heads{
    "best tried", "optimum (95 % interval)", "model's optimum", "alone within 2 %", "search range"};

/// On narrow screens each cell is on its own line, preceded by its heading (data-head).
std::string key_cell(std::size_t column, const std::string& text) {
  return fmt::format("<td class=\"n\" data-head=\"{}\">{}</td>", key_heads[column], escaped(text));
}

std::string key_rows(const Optimum& found) {
  std::string rows;
  for (const KeyOptimum& k : found.keys)
    rows += fmt::format("<tr><th scope=\"row\"><code>{}</code></th>{}{}{}{}{}</tr>\n",
                        escaped(k.key), key_cell(0, k.text.best), key_cell(1, k.range_text()),
                        key_cell(2, k.text.model),
                        key_cell(3, k.text.good_low == k.text.good_high
                                        ? k.text.good_low
                                        : k.text.good_low + " to " + k.text.good_high),
                        key_cell(4, k.text.from + " to " + k.text.to));
  return rows;
}

std::string key_table(const Optimum& found) {
  std::string heads;
  for (const std::string_view head : key_heads)
    heads += fmt::format("<th class=\"n\">{}</th>", head);
  return fmt::format(
      "<h2>The best settings</h2>\n<div class=\"wide\"><table class=\"stacked\">\n"
      "<thead><tr><th></th>{}</tr></thead>\n<tbody>\n{}</tbody>\n</table></div>\n",
      heads, key_rows(found));
}

std::string cell(const observe::Estimate& t, const std::string& unit) {
  return fmt::format("<td class=\"n\">{}</td>", escaped(readable(t.mean, t.ci95, unit).text()));
}

std::string setting_row(const Optimum& found, std::size_t number) {
  const Trial& s = found.trials[number];
  const bool best = found.best == number;
  std::string row = fmt::format("<tr><th scope=\"row\">{}{}{}</th>", best ? "<b>" : "", number + 1,
                                best ? " best</b>" : "");
  for (const std::string& value : s.values)
    row += fmt::format("<td class=\"n\">{}</td>", escaped(value));
  if (!s.failure.empty())
    return row + fmt::format("<td colspan=\"{}\">{}</td></tr>\n", 4 + found.limits.size(),
                             escaped(s.failure));
  row += cell(s.outcome(0), found.outcome.unit) + cell(s.model, found.outcome.unit);
  for (std::size_t i = 0; i < found.limits.size(); ++i)
    row += cell(s.outcome(i + 1), found.limits[i].unit);
  return row + fmt::format("<td class=\"n\">{:.0f} %</td><td class=\"n\">{}</td></tr>\n",
                           100 * s.probability_best, s.replicates.size());
}

std::string settings(const Optimum& found) {
  std::string head;
  for (const KeyOptimum& k : found.keys)
    head += fmt::format("<th class=\"n\"><code>{}</code></th>", escaped(k.key));
  head += fmt::format("<th class=\"n\">{}</th><th class=\"n\">by the model</th>",
                      escaped(label(found.outcome.name)));
  for (const OptimumLimit& limit : found.limits)
    head += fmt::format("<th class=\"n\">{}</th>", escaped(label(limit.quantity)));
  std::string rows;
  for (std::size_t i = 0; i < found.trials.size(); ++i) rows += setting_row(found, i);
  return fmt::format(
      "<h2>Settings tried</h2>\n<div class=\"wide\"><table>\n<thead><tr><th></th>{}<th "
      "class=\"n\">probability</th><th class=\"n\">runs</th></tr></thead>\n<tbody>\n{}</tbody>\n"
      "</table></div>\n<p><small>Probability of being the best of those tried.</small></p>\n",
      head, rows);
}

std::string lead(const Optimum& found) {
  std::string text = fmt::format(
      "{} settings of {} tried, {} runs, to make the {} as {} as possible", found.trials.size(),
      found.case_file, found.runs(), label(found.outcome.name), found.maximise ? "large" : "small");
  if (found.best)
    text += fmt::format(": {} at the best setting",
                        readable(found.trials[*found.best].model.mean,
                                 found.trials[*found.best].model.ci95, found.outcome.unit)
                            .text());
  return text + ".";
}

}  // namespace

std::vector<Plot> optimum_plots(const Optimum& found) {
  std::vector<Plot> plots{history(found)};
  if (found.best)
    for (std::size_t key = 0; key < found.keys.size(); ++key) plots.push_back(slice(found, key));
  return plots;
}

std::string optimum_page(const Optimum& found, std::string_view version, std::string_view extra) {
  std::string body = fmt::format("<p class=\"lead\">{}</p>\n", escaped(lead(found)));
  if (found.best) body += key_table(found);
  std::string points;
  for (const std::string& sentence : sentences(found))
    points += fmt::format("<p>{}.</p>\n", escaped(sentence));
  body += fmt::format(
      "<section class=\"box{}\"><h2>Certainty of the result</h2>\n{}"
      "</section>\n",
      found.best && !found.trials[*found.best].invalid() ? "" : " warn", points);
  body += notice_boxes(found.notices, found.trials.size(), "setting");
  body += extra;
  const std::vector<Plot> plots = optimum_plots(found);
  for (std::size_t i = 0; i < plots.size(); ++i)
    body += figure(
        plots[i],
        i == 0 ? "Bars are 95 % intervals over replicates. The line is the prediction of the final "
                 "model for the best setting so far."
               : "Grey lines are the 95 % interval of the mean by the model. Settings tried lie "
                 "off the curve if their other keys differ; their intervals are not drawn.");
  body += settings(found);
  return page(found.title.empty() ? "An optimum" : found.title, body,
              fmt::format("Mahlwerk {}. The settings are in settings.csv, the case with the best "
                          "setting in best.toml.",
                          escaped(version)));
}

}  // namespace mahlwerk::report
