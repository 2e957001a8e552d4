// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/assumed_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/run/further_runs.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/cases/reversal.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/results/quantities/key_quantities.hpp"

namespace mahlwerk::campaign {
namespace {

/// [s] Counted time of a run at an end, where the result counts `whole` [s]: 0.4 of it, but whole
/// periods of the mill.
double counted_at_end(const cases::Case& mill_case, double whole) {
  constexpr double share = 0.4, rounding = 1e-6;
  const double period = cases::mill_period(mill_case);
  if (!(whole > (1 - rounding) * period)) return share * whole;  // part of a period, or none
  return std::min(whole, std::ceil(share * whole / period - rounding) * period);
}

/// How many assumed keys can be varied within the time that the result itself simulated: two runs
/// each, which simulate `each` [s], and one with all assumed values.
std::size_t affordable(double budget, double each) {
  return static_cast<std::size_t>(std::max(0.0, (budget / each - 1) / 2));
}

/// Replicates of a run at an end: one in each sense of rotation, which costs little; those of the
/// case where it asks for the influences.
std::int64_t replicates_at_end(const cases::Case& c) {
  const std::int64_t least = cases::needs_both_senses(c) ? 2 : 1;
  return c.run.sensitivity == cases::SensitivityMode::on ? std::max(least, c.run.replicates)
                                                         : least;
}

/// The case for one end: shorter, without what the key quantities do not need.
cases::Case at_end(cases::Case made, const results::Outcome& outcome) {
  const results::Replicate& whole = outcome.replicates.front();
  cases::MillingTime milling = made.milling.value_or(cases::MillingTime());
  milling.time = cases::milling_time(made);
  made.milling = milling;
  made.run.engine = outcome.engine;
  made.run.until.reset();
  made.run.settle = whole.at_settled.time;
  made.run.time = counted_at_end(outcome.mill_case, whole.time());
  made.run.replicates = replicates_at_end(outcome.mill_case);
  made.contact.softening = outcome.mill_case.contact.softening;
  made.observe.collisions = made.observe.final_state = false;
  made.observe.frames.reset();
  made.capture.reset();
  made.grinding.reset();
  made.kinetics.reset();
  made.fit.clear();
  return made;
}

std::vector<double> values_of(const results::Outcome& outcome,
                              const std::vector<std::string>& names) {
  std::vector<double> found;
  for (const std::string& name : names) {
    const auto& list = outcome.summary.quantities;
    const auto q = std::ranges::find(list, name, &results::Quantity::name);
    found.push_back(q == list.end() ? std::numeric_limits<double>::quiet_NaN() : q->value);
  }
  return found;
}

/// What differences of two runs at ends are by chance (sta.13).
std::vector<double> scatter_of(const results::Outcome& outcome, double counted,
                               const std::vector<std::string>& names) {
  std::vector<double> found;
  const std::vector<const results::Replicate*> chosen = results::averaged_replicates(outcome);
  for (const std::string& name : names) {
    std::vector<double> values;
    for (const results::Replicate* r : chosen)
      values.push_back(results::value_of(outcome, *r, name));
    const observe::Estimate mean = observe::estimate(values);
    const auto n = static_cast<double>(values.size());
    // Two runs of m replicates, more for their shorter time.
    const auto m = static_cast<double>(replicates_at_end(outcome.mill_case));
    const double wide = mean.ci95 * std::sqrt(2 * n / m * chosen.front()->time() / counted);
    found.push_back(std::isfinite(wide) ? wide : 0);
  }
  return found;
}

/// Difference of the first quantity between the ends.
double influence(const results::AssumedInfluence& one) {
  const double span = std::abs(one.at_ends[1].front() - one.at_ends[0].front());
  return std::isnan(span) ? 0 : span;
}

/// The result's value times the ratio of the run at an end to that with the assumed value; where
/// one has no number or is 0, the run at the end as it is.
double relative_to(double as_assumed, double at_end, double result) {
  const double ratio = at_end / as_assumed;
  return as_assumed > 0 && result > 0 && std::isfinite(ratio) ? result * ratio : at_end;
}

/// The assumed values with a known range that the engine of the run reads.
std::vector<cases::Origin> assumed_with_range(cases::Case decided) {
  cases::drop_irrelevant_assumptions(decided);
  const bool rolls = decided.run.engine != cases::EngineName::event ||
                     decided.contact.lasting == cases::SustainedContactModel::roll;
  std::erase_if(decided.origins, [&](const cases::Origin& origin) {
    return !origin.assumed || origin.range[0].empty() ||
           (!rolls && origin.key.ends_with("rolling_friction"));
  });
  return decided.origins;
}

bool wanted(const cases::Case& decided) {
  return decided.run.sensitivity != cases::SensitivityMode::off && !decided.uncertainty &&
         decided.run.engine != cases::EngineName::lammps;
}

/// How many assumed keys the case wants varied, for a result that simulated `budget` [s] and runs
/// that simulate `each` [s].
std::size_t most_keys(const cases::Case& decided, double budget, double each) {
  const bool all = decided.run.sensitivity == cases::SensitivityMode::on;
  return all ? decided.origins.size() : affordable(budget, each);
}

/// Adds the keys to vary to `found`, and those left out; returns the runs: with the assumed values,
/// then at both ends of each key.
std::vector<cases::Case> runs_of_keys(const cases::Case& decided, const results::Outcome& outcome,
                                      const ReadWithValue& read, results::Sensitivity& found) {
  double budget = 0;
  for (const results::Replicate& r : outcome.replicates) budget += r.energy_balance.time;
  const std::size_t most =
      most_keys(decided, budget, outcome.replicates.front().at_settled.time + found.time);
  std::vector<cases::Case> runs{at_end(outcome.mill_case, outcome)};
  for (const cases::Origin& origin : assumed_with_range(decided)) {
    if (found.keys.size() == most) {
      found.left_out.push_back(origin.key);
      continue;
    }
    try {
      cases::Case low = at_end(read(origin.key, origin.range[0]), outcome);
      cases::Case high = at_end(read(origin.key, origin.range[1]), outcome);
      runs.push_back(std::move(low));
      runs.push_back(std::move(high));
      found.keys.push_back({origin.key, origin.value, origin.range, origin.source, {}});
    } catch (const InputError&) {
      found.left_out.push_back(origin.key);  // an end that does not fit the rest of the case
    }
  }
  return runs;
}

/// Sets the values at the ends from the outcomes of the runs_of_keys().
void set_values(const results::Outcome& outcome, const std::vector<results::Outcome>& outcomes,
                results::Sensitivity& found) {
  const std::vector<double> result = values_of(outcome, found.quantities),
                            as_assumed = values_of(outcomes.front(), found.quantities);
  for (std::size_t i = 0; i < found.keys.size(); ++i)
    for (std::size_t end = 0; end < 2; ++end) {
      std::vector<double> values = values_of(outcomes[2 * i + end + 1], found.quantities);
      for (std::size_t q = 0; q < values.size(); ++q)
        values[q] = relative_to(as_assumed[q], values[q], result[q]);
      found.keys[i].at_ends[end] = std::move(values);
    }
}

}  // namespace

double assumed_values_cost(const cases::Case& decided, double settling) {
  if (!wanted(decided)) return 0;
  const double whole = static_cast<double>(decided.run.replicates) * (settling + decided.run.time);
  const double each = settling + counted_at_end(decided, decided.run.time);
  const std::size_t keys =
      std::min(assumed_with_range(decided).size(), most_keys(decided, whole, each));
  const auto replicates = static_cast<double>(replicates_at_end(decided));
  return keys == 0 ? 0 : static_cast<double>(2 * keys + 1) * replicates * each / whole;
}

std::optional<results::Sensitivity> sensitivity_to_assumed(const results::Outcome& outcome,
                                                           const ReadWithValue& read,
                                                           const RunOptions& options) {
  cases::Case decided = outcome.mill_case;
  decided.run.engine = outcome.engine;
  if (!wanted(decided) || !results::complete(outcome)) return std::nullopt;
  results::Sensitivity found;
  found.time = counted_at_end(outcome.mill_case, outcome.replicates.front().time());
  found.replicates = replicates_at_end(outcome.mill_case);
  found.quantities = results::key_quantities(outcome.summary.quantities);
  found.scatter = scatter_of(outcome, found.time, found.quantities);
  const std::vector<cases::Case> runs = runs_of_keys(decided, outcome, read, found);
  if (found.keys.empty())
    return found.left_out.empty() ? std::nullopt : std::optional(std::move(found));
  const std::vector<results::Outcome> outcomes = run(runs, without_files(options));
  if (!std::ranges::all_of(outcomes, results::complete)) return std::nullopt;
  set_values(outcome, outcomes, found);
  std::ranges::stable_sort(found.keys, std::ranges::greater(), influence);
  return found;
}

}  // namespace mahlwerk::campaign
