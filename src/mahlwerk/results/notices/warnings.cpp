// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/notices/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/mill_power.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/mill_speed.hpp"
#include "mahlwerk/results/quantities/motion_states.hpp"
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

/// Names parts that no ball has touched since the start of the run.
void untouched_parts(const Outcome& outcome, Notices& list) {
  const auto chosen = averaged_replicates(outcome);
  std::string names;
  for (std::size_t i = 0; i < outcome.mill_case.machine_parts.size(); ++i)
    if (!chosen.empty() && std::ranges::all_of(chosen, [&](const Replicate* r) {
          return i + 1 < r->loads.size() && norm(r->loads[i + 1].impulse) == 0;
        }))
      names += (names.empty() ? "" : ", ") + outcome.mill_case.machine_parts[i].name;
  if (!names.empty())
    list.push_back(warning(
        "part-untouched",
        fmt::format("No ball touched these parts: {}. They may lie outside the jar, or above the "
                    "charge.",
                    names)));
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

/// Warns of replicates of which some fly and others roll on the wall: the means are those of a
/// change between two motions, which their power need not show.
void flight_and_rolling(const Outcome& outcome, Notices& list) {
  constexpr double much = 0.5;  // of the time
  double least = 1, most = 0;
  const auto balls = static_cast<double>(cases::balls_count(outcome.mill_case.balls));
  for (const Replicate* r : averaged_replicates(outcome)) {
    const double share =
        (r->energy_balance.contact_time - r->at_settled.contact_time) / (r->time() * balls);
    least = std::min(least, share);
    most = std::max(most, share);
  }
  if (!(most - least > much)) return;
  list.push_back(warning(
      "flight-and-rolling",
      fmt::format(
          "The balls are in sustained contact from {:.0f} % of the time in one replicate to "
          "{:.0f} % in another: they fly, or roll and slide on the wall, or change from one "
          "to the other. Rates and energies of hits are means over both. A longer run.settle "
          "counts the motion that lasts; replicates.csv has each.",
          100 * least, 100 * most)));
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
  if (outcome.engine == cases::EngineName::lammps) return;  // it closes by its definition (lmp.7)
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
        fmt::format(
            "The energy balance of a run does not close: energy {}, a residual of {:.1e}; "
            "at most {:.0e} is expected.{}",
            appeared(outcome) ? "appeared" : "was lost", run, closed,
            soft ? " A quarter of the time step (run.time_step) or stiffer contacts may close it."
                 : "")));
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
        fmt::format("Two bodies overlapped by {:.3g} % of a ball's radius, more than {:.0f} %. {}",
                    100 * deepest, 100 * soft_overlap, overlap_advice(outcome.mill_case))));
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
  append(list, cases::mill_power_notices(outcome.mill_case, mill_rate(outcome)));
  append(list, cases::unusual_values(outcome.mill_case));
  append(list, cases::ignored_keys(outcome.mill_case, outcome.engine));
  energy_gained(outcome, list);
  energy_balances(outcome, list);
  overlaps(outcome, list);
  append(list, softened_quantities(outcome));
  append(list, state_notices(outcome.summary));
  append(list, motion_state_notices(outcome));
  flight_and_rolling(outcome, list);
  untouched_parts(outcome, list);
  drawn_parameters(outcome, list);
  append(list, reversal_notices(outcome));
  append(list, settling_warnings(outcome));
  for (const cases::Part* part : cases::parts_of(outcome.mill_case))
    if (part->notices != nullptr) append(list, part->notices(outcome));
  not_certain(outcome, list);
  return list;
}

}  // namespace mahlwerk::results
