// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/key_numbers.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/report/aligned.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/quantities/key_quantities.hpp"
#include "mahlwerk/results/quantities/traits.hpp"

namespace mahlwerk::report {
namespace {

using results::Outcome;
using results::Quantity;
using Line = std::array<std::string, 3>;
constexpr double one_hour = 3600;  // [s]

/// A quantity in the unit in which its number is short: long times are in hours.
Quantity in_a_short_unit(Quantity q) {
  if (q.unit != "s" || !(q.value >= one_hour)) return q;
  q.value /= one_hour;
  q.ci95 /= one_hour;
  q.ci95_time /= one_hour;
  q.unit = "h";
  return q;
}

/// "90 s", "30 min", "2 h": a milling time as people say it.
std::string duration(double seconds) {
  constexpr double minute = 60;
  if (seconds >= one_hour) return two_digits(seconds / one_hour) + " h";
  const bool whole = seconds >= 2 * minute && std::fmod(seconds, minute) == 0;
  return whole ? show_rounded(seconds / minute, "") + " min" : show_rounded(seconds, "s");
}

}  // namespace

std::string key_title(const Quantity& q, const cases::Case& c) {
  if (q.name == "collision_rate_above_threshold")
    return "hits of at least " + threshold_text(c.observe.threshold);
  if (q.name == "energy_normal_mean_above_threshold") return "mean normal energy of these hits";
  if (q.name == "time_to_dose")
    return "time to a dose of " +
           show_rounded(c.milling.value_or(cases::MillingTime()).dose, "J/kg");
  const auto time = cases::milling_time(c);
  if (time && (q.name == "specific_energy_dose" || q.name == "d50" || q.name == "conversion"))
    return fmt::format("{} after {}", label(q), duration(*time));
  return label(q);
}

std::string key_value(const Quantity& q) {
  if (q.name == "specific_energy_dose" && std::isnan(q.value)) return "no milling time given";
  return readable(in_a_short_unit(q)).text();
}

std::string key_range(double low, double high, const std::string& unit) {
  const double size = std::fmax(std::abs(low), std::abs(high));
  const Multiple in =
      unit == "s" && size >= one_hour ? Multiple{one_hour, "h"} : multiple(size, unit);
  const std::string one = two_digits(low / in.factor), other = two_digits(high / in.factor);
  return Readable{one == other ? "about " + one : fmt::format("{} to {}", one, other),
                  readable(1, NAN, in.unit).unit}
      .text();
}

namespace {

using Ends = std::pair<double, double>;

/// The range of a quantity over assumed values; empty if there is none.
std::string assumed_text(const Outcome& outcome, const Quantity& q) {
  if (!outcome.summary.sensitivity || !std::isfinite(q.value)) return "";
  const std::optional<Ends> ends = outcome.summary.sensitivity->range(q.name, q.value);
  return ends && ends->first < ends->second ? key_range(ends->first, ends->second, q.unit) : "";
}

std::vector<Line> key_lines(const Outcome& outcome) {
  std::vector<Line> lines{{"key numbers", "",
                           outcome.summary.sensitivity && !outcome.summary.sensitivity->keys.empty()
                               ? "over assumed values"
                               : ""}};
  for (const std::string& name : results::key_quantities(outcome.summary.quantities)) {
    const Quantity& q = named(outcome.summary.quantities, name);
    lines.push_back({key_title(q, outcome.mill_case), key_value(q), assumed_text(outcome, q)});
  }
  return lines;
}

/// One line for each assumed key, the largest influence on the power first.
std::vector<Line> cause_lines(const Outcome& outcome) {
  const results::Sensitivity& found = *outcome.summary.sensitivity;
  std::vector<Line> lines;
  for (const results::AssumedInfluence& one : found.keys) {
    const Quantity& q = named(outcome.summary.quantities, found.quantities.front());
    const Ends ends{one.at_ends[0].front(), one.at_ends[1].front()};
    const bool by_chance = !found.beyond_chance(0, ends.first, q.value) &&
                           !found.beyond_chance(0, ends.second, q.value);
    lines.push_back({one.key,
                     fmt::format("{} to {}, assumed {}", one.ends[0], one.ends[1], one.value),
                     fmt::format("{} {}{}", label(q), key_range(ends.first, ends.second, q.unit),
                                 by_chance ? ", no more than by chance" : "")});
  }
  return lines;
}

std::string list_of(const std::vector<std::string>& keys) {
  std::string text;
  for (const std::string& key : keys) text += (text.empty() ? "" : ", ") + key;
  return text;
}

/// What the ranges over assumed values are, and which values are missing there; empty if nothing
/// with a known range was assumed.
std::string about_assumed(const Outcome& outcome) {
  if (!outcome.summary.sensitivity) return "";
  const results::Sensitivity& found = *outcome.summary.sensitivity;
  std::string text;
  if (!found.keys.empty())
    text = fmt::format(
        "Assumed values, one at a time, at each end of its plausible range; {} of {} for "
        "each, relative to the same with the assumed value. Ranges leave out what chance makes.",
        found.replicates == 1 ? "one run" : fmt::format("{} runs", found.replicates),
        show_rounded(found.time, "s", 2));
  if (!found.left_out.empty()) {
    const bool all = outcome.mill_case.run.sensitivity == cases::SensitivityMode::on;
    text += fmt::format("{}What these assumed values decide was not computed: {}. {}",
                        text.empty() ? "" : " ", list_of(found.left_out),
                        all ? "The ends of their ranges do not fit the rest of the case."
                            : "run.sensitivity = \"on\" does it.");
  }
  return text;
}

constexpr std::string_view of_starts =
    "± is the 95 % confidence half-width over replicates, which differ by their start alone.";

}  // namespace

std::string key_table(const Outcome& outcome) {
  std::string text = aligned(key_lines(outcome)) + '\n' + std::string(of_starts) + '\n';
  const std::string about = about_assumed(outcome);
  return about.empty() ? text : text + about + '\n' + aligned(cause_lines(outcome));
}

std::string key_section(const Outcome& outcome) {
  const auto row = [](const Line& line) {
    return fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"n\">{}</td><td class=\"n\">{}</td></tr>\n",
        escaped(line[0]), escaped(line[1]), escaped(line[2]));
  };
  const std::vector<Line> lines = key_lines(outcome);
  std::string rows;
  for (std::size_t i = 1; i < lines.size(); ++i) rows += row(lines[i]);
  std::string text = fmt::format(
      "<div class=\"wide\"><table class=\"key\">\n<thead><tr><th></th><th "
      "class=\"n\">{}</th><th class=\"n\">{}</th></tr></thead>\n<tbody>\n{}</tbody>\n</table>"
      "</div>\n<p><small>{}</small></p>\n",
      escaped(lines[0][1]), escaped(lines[0][2]), rows, of_starts);
  const std::string about = about_assumed(outcome);
  if (about.empty()) return text;
  rows.clear();
  for (const Line& line : cause_lines(outcome)) rows += row(line);
  text += fmt::format("<section class=\"box\"><h2>What assumed values decide</h2>\n<p>{}</p>\n",
                      escaped(about));
  if (!rows.empty())
    text += fmt::format("<div class=\"wide\"><table><tbody>\n{}</tbody></table></div>\n", rows);
  return text + "</section>\n";
}

}  // namespace mahlwerk::report
