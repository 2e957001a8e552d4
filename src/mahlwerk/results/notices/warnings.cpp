// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/notices/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/results/quantities/grinding.hpp"
#include "mahlwerk/results/quantities/kinetics.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/sensors.hpp"
#include "mahlwerk/results/quantities/states.hpp"

namespace mahlwerk::results {
namespace {

/// Largest relative residuals of energy balances: of a collision; of a run, by rounding errors; of
/// a run of the soft engine, by the error of its time steps.
constexpr double closed_collision = 1e-9, closed_run = 1e-6, closed_run_in_steps = 1e-3;

/// Overlap over the ball's radius beyond which contact laws are not valid.
constexpr double sunk = 0.2;

double value(const Outcome& outcome, std::string_view name) {
  return named(outcome.summary.quantities, name).value;
}

/// [J] Energy that the charges of all replicates have stored since counting began, at the end of
/// each window.
std::vector<double> stored(const std::vector<const Replicate*>& chosen) {
  std::size_t windows = chosen.empty() ? 0 : chosen.front()->windows.size();
  for (const Replicate* r : chosen) windows = std::min(windows, r->windows.size());
  std::vector<double> sums(windows, 0);
  for (std::size_t i = 0; i < windows; ++i) {
    if (i > 0) sums[i] = sums[i - 1];
    for (const Replicate* r : chosen) sums[i] += r->windows[i].wall_work - r->windows[i].lost;
  }
  return sums;
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
  if (energy.size() < fewest) return;
  const double settling = value(outcome, "settling_time"), time = value(outcome, "simulated_time"),
               imbalance = value(outcome, "power_imbalance");
  const double windows = settling / chosen.front()->windows.front().length;
  if (!(settling > much * time) || !(std::abs(imbalance) > balanced) ||
      !start_differs(energy, static_cast<std::size_t>(windows + 0.5)))
    return;
  list.push_back(
      warning("not-settled",
              fmt::format("The charge had not settled when counting began: the first {} of {} "
                          "counted are an initial transient, and {} % {} power was drawn than "
                          "dissipated. A longer run.settle helps.",
                          show_rounded(settling, "s", 2), show_rounded(time, "s", 2),
                          two_digits(100 * std::abs(imbalance)), imbalance > 0 ? "more" : "less")));
}

/// Mean, least and greatest of a time over the replicates, in words: "0.4 s", "0.35 s to 0.5 s".
std::string range_in_words(const std::vector<const Replicate*>& chosen, const auto& of) {
  const auto [least, most] = std::ranges::minmax(chosen, {}, of);
  const std::string from = show_rounded(of(least), "s"), to = show_rounded(of(most), "s");
  return from == to ? from : fmt::format("{} to {}", from, to);
}

/// Says what run.settle = "auto" did, and warns where it found a trend until the end.
void automatic_settling(const Outcome& outcome, Notices& list) {
  const std::vector<const Replicate*> chosen = averaged_replicates(outcome);
  if (chosen.empty() || !cases::settles(outcome.mill_case)) return;
  const auto trending = std::ranges::count(chosen, false, &Replicate::settled);
  const std::string after =
      range_in_words(chosen, [](const Replicate* r) { return r->at_settled.time; });
  const double periods = value(outcome, "simulated_time") / cases::mill_period(outcome.mill_case);
  if (trending > 0)
    list.push_back(warning(
        "not-settled",
        fmt::format(
            "The mill had not settled after {}, when counting began: in {} of {} replicates "
            "power, hits or stored energy still had a trend. A longer run.time allows a "
            "longer settling; run.settle gives its time.",
            after, trending, chosen.size())));
  else
    list.push_back(
        note("settled",
             fmt::format("Counting began after {}, when dissipated and drawn power, hits and "
                         "stored energy had no trend. {:.4g} periods of the mill are counted.",
                         after, periods)));
}

/// Warns if less than one period of the mill was counted.
void part_of_a_period(const Outcome& outcome, Notices& list) {
  const double counted = value(outcome, "simulated_time"),
               period = cases::mill_period(outcome.mill_case);
  if (!complete(outcome) || !std::isfinite(period) || !(counted < 0.999 * period)) return;
  list.push_back(warning(
      "part-of-a-period",
      fmt::format("{} were counted, {} of a period of the mill ({}). Means over less than a period "
                  "depend on its phase; a drum may not yet flow. Write run.time = \"{}\" or more.",
                  show_rounded(counted, "s"), two_digits(counted / period),
                  show_rounded(period, "s"), show_rounded(period, "s"))));
}

/// Warns if drawn and dissipated power differ by more than the fluctuation of the stored energy:
/// then energy is stored, or given back, all the time (sta.11).
void powers_apart(const Outcome& outcome, Notices& list) {
  constexpr double much = 0.1, far = 3, rounding = 1e-9;
  constexpr std::size_t fewest = 10;
  const std::vector<const Replicate*> chosen = averaged_replicates(outcome);
  double lost = 0, drawn = 0, kinetic = 0;
  for (const Replicate* r : chosen)
    for (const Window& w : r->windows) lost += w.lost, drawn += w.wall_work, kinetic += w.kinetic;
  if (!(std::abs(drawn - lost) > rounding * kinetic)) return;
  const std::vector<double> energy = stored(chosen);
  const double apart = std::abs(drawn - lost) / std::max(std::abs(drawn), std::abs(lost));
  if (energy.size() < fewest || !(apart > much)) return;
  if (std::ranges::any_of(list, [](const Notice& n) { return n.code == "not-settled"; })) return;
  const observe::Trend trend = observe::trend(energy);
  if (!(std::abs(trend.change) > far * trend.scatter)) return;
  list.push_back(warning(
      "powers-apart",
      fmt::format(
          "Drawn and dissipated power differ by {} % of the larger one, {} was drawn, although "
          "in a settled mill both are equal: {} A longer run.settle, or run.settle = \"auto\", and "
          "a longer run.time "
          "help.",
          two_digits(100 * apart), drawn > lost ? "more" : "less",
          drawn > lost ? "the charge still gained energy when counting ended, for instance a bed "
                         "that is lifted and does not yet flow."
                       : "the charge still lost energy that it had when counting began.")));
}

void cut_short(const Outcome& outcome, Notices& list) {
  if (averaged_replicates(outcome).empty())
    list.push_back(warning("no-result", "No time was counted: there is no result."));
  if (outcome.interrupted && !complete(outcome))
    list.push_back(
        warning("interrupted",
                "The run was interrupted: these numbers come from the part that was computed."));
  for (std::size_t i = 0; i < outcome.replicates.size(); ++i)
    if (!outcome.replicates[i].stop_reason.empty())
      list.push_back(warning("stopped", fmt::format("Replicate {} was stopped: {}", i + 1,
                                                    outcome.replicates[i].stop_reason)));
}

void not_certain(const Outcome& outcome, Notices& list) {
  if (std::ranges::all_of(averaged_replicates(outcome), &Replicate::precision_reached)) return;
  list.push_back(warning(
      "not-certain",
      fmt::format(
          "{} is not known within {:.3g} % after the longest time allowed: a longer run.longest "
          "helps.",
          outcome.mill_case.run.until->quantity, 100 * outcome.mill_case.run.until->within)));
}

/// Says what intervals mean if parameters vary from replicate to replicate.
void drawn_parameters(const Outcome& outcome, Notices& list) {
  constexpr std::size_t few = 8;
  if (!outcome.mill_case.uncertainty) return;
  std::string keys;
  for (const cases::UncertainKey& one : outcome.mill_case.uncertainty->keys)
    keys += (keys.empty() ? "" : ", ") + one.key;
  const std::size_t count = averaged_replicates(outcome).size();
  list.push_back(note(
      "uncertain-parameters",
      fmt::format("Each replicate has another draw of {}: intervals contain 95 % of what these "
                  "uncertain values make possible, besides the scatter of the mill.",
                  keys)));
  if (count < few)
    list.push_back(warning(
        "few-draws",
        fmt::format("{} replicate{} few of the {} draws of [uncertainty]: the intervals are wide "
                    "or unknown. Write run.replicates = {} or more.",
                    count, count == 1 ? " holds" : "s hold", outcome.mill_case.uncertainty->count(),
                    std::min<std::size_t>(16, outcome.mill_case.uncertainty->count()))));
}

/// Whether energy was gained, rather than lost, in the run with the largest residual.
bool appeared(const Outcome& outcome) {
  double worst = 0;
  for (const Replicate& r : outcome.replicates)
    if (std::abs(r.energy_balance.residual()) > std::abs(worst))
      worst = r.energy_balance.residual();
  return worst > 0;
}

/// A collision that gains energy stops a run. This check finds negative losses in the sum.
void energy_gained(const Outcome& outcome, Notices& list) {
  const bool soft = cases::in_time_steps(outcome.engine);
  const double rounding = soft ? closed_run_in_steps : 1e-9;
  for (const Replicate& r : outcome.replicates) {
    const scene::EnergyBalance& a = r.energy_balance;
    const double turned_over = a.kinetic + std::abs(a.initial_energy) + std::abs(a.wall_work);
    const double lost = std::min(a.lost(), a.lost() - r.at_settled.lost());
    if (!(lost < -rounding * turned_over)) continue;
    const char* const why =
        soft
            ? "Under this contact law a tangential spring stiffens while it is stretched, which "
              "adds energy; at a restitution near 0 this energy exceeds what the dampers "
              "dissipate. A larger restitution, or law = \"linear-spring\", reduces it."
            : "This is an error of Mahlwerk, not of the case: please report it with the case file.";
    list.push_back(
        invalid("energy-gained",
                fmt::format("Collisions dissipated {:.3g} J, which is negative. {}", lost, why)));
    return;
  }
}

void energy_balances(const Outcome& outcome, Notices& list) {
  const double collision = value(outcome, "energy_residual");
  if (!(collision <= closed_collision))
    list.push_back(warning(
        "energy-residual",
        fmt::format("The energy balance of a collision does not close: residual {:.1e}, at most "
                    "{:.0e} is expected.",
                    collision, closed_collision)));
  const bool soft = cases::in_time_steps(outcome.engine);
  const double run = value(outcome, "energy_balance");
  const double closed = soft ? closed_run_in_steps : closed_run;
  if (!(run <= closed))
    list.push_back(warning(
        "energy-balance",
        fmt::format("The energy balance of a run does not close: energy {}, a residual of {:.1e}; "
                    "at most {:.0e} is expected.{}",
                    appeared(outcome) ? "appeared" : "was lost", run, closed,
                    soft ? " A shorter run.time_step or stiffer contacts may close it." : "")));
}

/// Warns of overlaps beyond the range of the contact laws.
void overlaps(const Outcome& outcome, Notices& list) {
  const double deepest = value(outcome, "deepest_overlap");
  if (!cases::in_time_steps(outcome.engine) || !(deepest > soft_overlap)) return;
  if (deepest > sunk)
    list.push_back(warning(
        "deep-overlap",
        fmt::format(
            "Two bodies overlapped by {} of a ball's radius. At such overlaps the contact law is "
            "no longer valid. A shorter run.time_step may help. {}",
            two_digits(deepest), overlap_advice(outcome.mill_case))));
  else
    list.push_back(warning(
        "soft-contacts",
        fmt::format("Two bodies overlapped by {} % of a ball's radius, more than {:.0f} %. {}",
                    two_digits(100 * deepest), 100 * soft_overlap,
                    overlap_advice(outcome.mill_case))));
}

}  // namespace

std::string overlap_advice(const cases::Case& mill_case) {
  const double softening = mill_case.contact.softening;
  if (softening < 1)
    return fmt::format(
        "Forces and contact times are those of softer bodies: contact.softening is {}, and 1 gives "
        "the stiffness of the material.",
        show_rounded(softening, ""));
  return "contact.softening is 1, so this is the stiffness of the material as the case gives it: "
         "check youngs_modulus and the stiffness of the contact law. If they are right, real "
         "bodies "
         "would be pressed as deep, or yield: metals do, and the force is then lower than computed "
         "(law = \"thornton-ning\" has a yield limit). Only slower or smaller balls lower the "
         "overlap.";
}

Notices warnings(const Outcome& outcome) {
  Notices list;
  cut_short(outcome, list);
  append(list, cases::jar_warnings(outcome.mill_case));
  append(list, cases::unusual_values(outcome.mill_case));
  append(list, cases::ignored_keys(outcome.mill_case, outcome.engine));
  energy_gained(outcome, list);
  energy_balances(outcome, list);
  overlaps(outcome, list);
  append(list, softened_quantities(outcome));
  append(list, state_notices(outcome.summary));
  drawn_parameters(outcome, list);
  append(list, reversal_notices(outcome));
  automatic_settling(outcome, list);
  not_steady(outcome, list);
  powers_apart(outcome, list);
  part_of_a_period(outcome, list);
  append(list, grinding_warnings(outcome));
  append(list, kinetics_warnings(outcome));
  append(list, sensor_warnings(outcome));
  not_certain(outcome, list);
  return list;
}

}  // namespace mahlwerk::results
