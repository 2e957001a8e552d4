// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Whether the counted part of a run is that of a settled mill (docs/theory/statistics.md, sta.8 to
// sta.12).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/results/notices/warnings.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/mill_speed.hpp"

namespace mahlwerk::results {
namespace {

double quantity(const Outcome& outcome, std::string_view name) {
  return named(outcome.summary.quantities, name).value;
}

bool says(const Notices& list, std::string_view code) {
  return std::ranges::any_of(list, [&](const Notice& n) { return n.code == code; });
}

/// [J] Energy that the charges of all replicates have stored since counting began, at the end of
/// each window.
std::vector<double> stored(const std::vector<const Replicate*>& chosen) {
  std::size_t windows = chosen.empty() ? 0 : chosen.front()->windows.size();
  for (const Replicate* r : chosen) windows = std::min(windows, r->windows.size());
  std::vector<double> sums(windows, 0);
  for (std::size_t i = 0; i < windows; ++i) {
    if (i > 0) sums[i] = sums[i - 1];
    for (const Replicate* r : chosen) sums[i] += r->windows[i].given() - r->windows[i].lost;
  }
  return sums;
}

/// Energies of all windows: what is below rounding of the kinetic energy is nothing.
struct TurnedOver {
  explicit TurnedOver(const std::vector<const Replicate*>& chosen) {
    for (const Replicate* r : chosen)
      for (const Window& w : r->windows) lost += w.lost, drawn += w.given(), kinetic += w.kinetic;
  }
  bool is_rounding(double energy) const { return !(std::abs(energy) > 1e-9 * kinetic); }
  bool is_nothing() const { return is_rounding(lost) && is_rounding(drawn); }
  double imbalance() const { return drawn / lost - 1; }
  // [J]; drawn with what a feed gives; the kinetic energy summed over the windows
  double lost = 0, drawn = 0, kinetic = 0;
};

/// [s] Of the mill; of one that a motor turns, at its mean speed in the counted time.
double period_in_run(const Outcome& outcome) {
  const double period = cases::mill_period(outcome.mill_case);
  return outcome.mill_case.drive ? period / std::abs(mill_rate(outcome)) : period;
}

/// Whether the speed of the mill changes, as prescribed, while it is counted: so do all numbers.
bool speed_changes(const Outcome& outcome, const std::vector<const Replicate*>& chosen) {
  const kinematics::SpeedProgram& program = outcome.mill_case.mill.speed_over_time;
  return program.repeats() || std::ranges::any_of(chosen, [&](const Replicate* r) {
           return r->at_settled.time < program.end();
         });
}

/// What lets a mill settle before it is counted.
std::string remedy(const Outcome& outcome) {
  return outcome.mill_case.run.settle
             ? "A longer run.settle helps, or run.settle = \"auto\"."
             : "A longer run.time allows a longer settling; run.settle gives its time.";
}

/// Whether the stored energy when counting began, zero here, differs from that after the first
/// windows by more than its scatter (sta.8).
bool start_differs(const std::vector<double>& stored, std::size_t first) {
  constexpr double far = 3;  // standard deviations
  if (first == 0 || first + 1 >= stored.size()) return false;
  const std::vector<double> rest(stored.begin() + static_cast<std::ptrdiff_t>(first), stored.end());
  const double mean = observe::estimate(rest).mean;
  double squares = 0;
  for (const double s : rest) squares += (s - mean) * (s - mean);
  return std::abs(mean) > far * std::sqrt(squares / static_cast<double>(rest.size() - 1));
}

/// Warns if the means contain an initial transient: a long transient of the power, an imbalance of
/// drawn and dissipated power, and a stored energy that changes. Short series show none of them.
void not_steady(const Outcome& outcome, Notices& list) {
  constexpr double much = 0.1, balanced = 0.01;
  constexpr std::size_t fewest = 50;  // windows: ten batches
  const std::vector<const Replicate*> chosen = averaged_replicates(outcome);
  const std::vector<double> energy = stored(chosen);
  if (energy.size() < fewest || TurnedOver(chosen).is_nothing()) return;
  if (speed_changes(outcome, chosen)) return;
  const double settling = quantity(outcome, "settling_time"),
               time = quantity(outcome, "simulated_time"),
               imbalance = outcome.mill_case.flow ? TurnedOver(chosen).imbalance()
                                                  : quantity(outcome, "power_imbalance");
  const double windows = settling / chosen.front()->windows.front().length;
  if (!(settling > much * time) || !(std::abs(imbalance) > balanced) ||
      !start_differs(energy, static_cast<std::size_t>(windows + 0.5)))
    return;
  list.push_back(
      warning("not-settled",
              fmt::format("The charge had not settled when counting began: the first {} of {} "
                          "counted are an initial transient, and {} % {} power was drawn than "
                          "dissipated. {}",
                          show_rounded(settling, "s", 2), show_rounded(time, "s", 2),
                          two_digits(100 * std::abs(imbalance)), imbalance > 0 ? "more" : "less",
                          remedy(outcome))));
}

/// Mean, least and greatest of a time over the replicates, in words: "0.4 s", "0.35 s to 0.5 s".
std::string range_in_words(const std::vector<const Replicate*>& chosen, const auto& of) {
  const auto [least, most] = std::ranges::minmax(chosen, {}, of);
  const std::string from = show_rounded(of(least), "s"), to = show_rounded(of(most), "s");
  return from == to ? from : fmt::format("{} to {}", from, to);
}

/// The times in words after which run.settle = "auto" began to count.
std::string settled_after(const std::vector<const Replicate*>& chosen) {
  return range_in_words(chosen, [](const Replicate* r) { return r->at_settled.time; });
}

/// Warns where run.settle = "auto" found a trend until the end.
void trend_until_the_end(const Outcome& outcome, Notices& list) {
  const std::vector<const Replicate*> chosen = averaged_replicates(outcome);
  if (chosen.empty() || !cases::settles(outcome.mill_case)) return;
  const auto trending = std::ranges::count(chosen, false, &Replicate::settled);
  if (trending == 0) return;
  list.push_back(warning(
      "not-settled",
      fmt::format("The mill had not settled after {}, when counting began: in {} of {} replicates "
                  "power, hits or stored energy still had a trend. {}",
                  settled_after(chosen), trending, chosen.size(), remedy(outcome))));
}

/// Says what run.settle = "auto" did, where nothing warns of what it counted.
void automatic_settling(const Outcome& outcome, Notices& list) {
  const std::vector<const Replicate*> chosen = averaged_replicates(outcome);
  if (chosen.empty() || !cases::settles(outcome.mill_case)) return;
  if (says(list, "not-settled") || says(list, "powers-apart")) return;
  const double periods = quantity(outcome, "simulated_time") / period_in_run(outcome);
  list.push_back(note(
      "settled", fmt::format("Counting began after {}, when dissipated and drawn power, hits and "
                             "stored energy had no certain trend. Periods of the mill counted: "
                             "{:.4g}.",
                             settled_after(chosen), periods)));
}

/// Warns if less than one period of the mill was counted.
void part_of_a_period(const Outcome& outcome, Notices& list) {
  const double counted = quantity(outcome, "simulated_time"), period = period_in_run(outcome);
  if (!complete(outcome) || !std::isfinite(period) || !(counted < 0.999 * period)) return;
  list.push_back(warning(
      "part-of-a-period",
      fmt::format("{} were counted, {} of a period of the mill ({}). Means over less than a period "
                  "depend on its phase; a drum may not yet flow. Write run.time = \"{}\" or more.",
                  show_rounded(counted, "s"), two_digits(counted / period),
                  show_rounded(period, "s"), show_rounded(period, "s"))));
}

/// Warns if the dissipated power or the rate of hits changed while it was counted, in the mean of
/// the replicates: trends that no single replicate shows (sta.12).
void counted_trend(const Outcome& outcome, Notices& list) {
  constexpr double much = 0.2, certain = 1.5;
  constexpr std::size_t batches = 20, fewest = 2 * batches;
  const std::vector<const Replicate*> chosen = averaged_replicates(outcome);
  std::size_t windows = chosen.empty() ? 0 : chosen.front()->windows.size();
  for (const Replicate* r : chosen) windows = std::min(windows, r->windows.size());
  if (windows < fewest || says(list, "not-settled") || TurnedOver(chosen).is_nothing()) return;
  if (speed_changes(outcome, chosen)) return;
  const auto trend_of = [&](double Window::*member) {
    std::vector<double> sums(batches, 0);
    for (std::size_t i = 0; i < windows / batches * batches; ++i)
      for (const Replicate* r : chosen) sums[i / (windows / batches)] += r->windows[i].*member;
    return observe::trend(sums);
  };
  for (const auto& [name, member] :
       {std::pair("the dissipated power", &Window::lost), {"the rate of hits", &Window::above}}) {
    const observe::Trend trend = trend_of(member);
    if (!(std::abs(trend.change) > std::max(much * trend.mean, certain * trend.ci95))) continue;
    list.push_back(warning(
        "not-settled",
        fmt::format("While it was counted, {} {} by {} (± {}) % of its mean, from the first to the "
                    "last part of the time. {}",
                    name, trend.change > 0 ? "rose" : "fell",
                    two_digits(100 * std::abs(trend.change) / trend.mean),
                    two_digits(100 * trend.ci95 / trend.mean), remedy(outcome))));
    return;
  }
}

/// Warns if so few hits were counted that neither their rate nor a slow change of it is known.
void few_hits(const Outcome& outcome, Notices& list) {
  constexpr std::int64_t few = 100;
  std::int64_t hits = 0;
  for (const Replicate* r : averaged_replicates(outcome)) hits += r->tally.above.count;
  if (hits == 0 || hits >= few) return;
  list.push_back(warning(
      "few-hits", fmt::format("Only {} hit{} above the threshold {} counted: their rate and their "
                              "energies are as uncertain as their number, and a slow change of the "
                              "rate would not show. A longer run.time counts more.",
                              hits, hits == 1 ? "" : "s", hits == 1 ? "was" : "were")));
}

/// Warns if drawn and dissipated power differ by more than the fluctuation of the stored energy:
/// then energy is stored, or given back, all the time (sta.11).
void powers_apart(const Outcome& outcome, Notices& list) {
  constexpr double much = 0.1, far = 3;
  constexpr std::size_t fewest = 10;
  const std::vector<const Replicate*> chosen = averaged_replicates(outcome);
  const TurnedOver sums(chosen);
  const double lost = sums.lost, drawn = sums.drawn;
  if (sums.is_rounding(drawn - lost)) return;
  const std::vector<double> energy = stored(chosen);
  const double apart = std::abs(drawn - lost) / std::max(std::abs(drawn), std::abs(lost));
  if (energy.size() < fewest || !(apart > much)) return;
  if (says(list, "not-settled")) return;
  const observe::Trend trend = observe::trend(energy);
  if (!(std::abs(trend.change) > far * trend.scatter)) return;
  list.push_back(warning(
      "powers-apart",
      fmt::format(
          "Drawn and dissipated power differ by {} % of the larger one, {} was drawn, although "
          "in a settled mill both are equal: {} {}",
          two_digits(100 * apart), drawn > lost ? "more" : "less",
          drawn > lost ? "the charge still gained energy when counting ended, for instance a bed "
                         "that is lifted and does not yet flow."
                       : "the charge still lost energy that it had when counting began.",
          remedy(outcome))));
}

}  // namespace

Notices settling_warnings(const Outcome& outcome) {
  Notices list;
  trend_until_the_end(outcome, list);
  not_steady(outcome, list);
  counted_trend(outcome, list);
  powers_apart(outcome, list);
  automatic_settling(outcome, list);
  part_of_a_period(outcome, list);
  few_hits(outcome, list);
  return list;
}

}  // namespace mahlwerk::results
