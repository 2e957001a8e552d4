// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/results/grinding.hpp"
#include "mahlwerk/results/summary.hpp"

namespace mahlwerk::results {
namespace {

/// The balance of a collision closes to 1e-9, that of a run to what its billions of roundings
/// allow; where contacts are followed in steps, to what the step allows.
constexpr double closed_collision = 1e-9, closed_run = 1e-6, closed_run_in_steps = 1e-3;

/// Of a ball's radius: far beyond what contact laws are made for.
constexpr double sunk = 0.2;

double named(const std::vector<Quantity>& list, std::string_view name) {
  return std::ranges::find(list, name, &Quantity::name)->value;
}

/// What the start of a run does to its means: the settling that its power shows, and power drawn
/// that is not dissipated.
std::string not_steady(const std::vector<Quantity>& quantities) {
  constexpr double much = 0.1, balanced = 0.01;
  const double settling = named(quantities, "settling_time"),
               time = named(quantities, "simulated_time");
  const double imbalance = named(quantities, "power_imbalance");
  if (!(settling > much * time) || !(std::abs(imbalance) > balanced)) return "";
  return fmt::format(
      "The charge had not settled when counting began: the first {:.2g} s of {:.2g} s counted "
      "stand "
      "out, and {:.2g} % more power was drawn than dissipated. A longer run.settle helps.",
      settling, time, 100 * imbalance);
}

}  // namespace

std::vector<std::string> warnings(const Outcome& outcome) {
  std::vector<std::string> list;
  const std::vector<Quantity> quantities = summarise(outcome);
  if (averaged(outcome).empty()) list.emplace_back("No time was counted: there is no result.");
  if (outcome.interrupted && !complete(outcome))
    list.emplace_back(
        "The run was interrupted: these numbers come from the part that was computed.");
  for (std::size_t i = 0; i < outcome.replicates.size(); ++i) {
    if (!outcome.replicates[i].stopped.empty())
      list.push_back(
          fmt::format("Replicate {} was stopped: {}", i + 1, outcome.replicates[i].stopped));
  }
  for (std::string& warning : cases::jar_warnings(outcome.what)) list.push_back(std::move(warning));
  const double collision = named(quantities, "energy_residual");
  if (!(collision <= closed_collision))
    list.push_back(
        fmt::format("The energy balance of a collision does not close: residual {:.1e}, at most "
                    "{:.0e} is expected.",
                    collision, closed_collision));
  const double deepest = named(quantities, "deepest_overlap");
  if (outcome.engine == "soft" && deepest > sunk)
    list.push_back(fmt::format(
        "Two bodies overlapped by {:.2g} of a ball's radius. Where balls are squeezed so, forces "
        "are no longer those of the contact law: a larger contact.softening, stiffer contacts or a "
        "shorter run.time_step help.",
        deepest));
  if (const std::string words = not_steady(quantities); !words.empty()) list.push_back(words);
  for (std::string& warning : grinding_warnings(outcome)) list.push_back(std::move(warning));
  if (!std::ranges::all_of(averaged(outcome), &Replicate::sure))
    list.push_back(fmt::format(
        "{} is not known within {:.3g} % at the longest time allowed: a longer run.longest helps.",
        outcome.what.run.until->quantity, 100 * outcome.what.run.until->within));
  const double run = named(quantities, "energy_balance");
  const double closed = outcome.engine == "soft" ? closed_run_in_steps : closed_run;
  if (!(run <= closed))
    list.push_back(fmt::format(
        "The energy balance of a run does not close: residual {:.1e}, at most {:.0e} is "
        "expected.{}",
        run, closed,
        outcome.engine == "soft" ? " A shorter run.time_step or stiffer contacts may close it."
                                 : ""));
  return list;
}

}  // namespace mahlwerk::results
