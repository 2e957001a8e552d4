// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/assumed_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/cases/reversal.hpp"
#include "mahlwerk/results/quantities/key_quantities.hpp"

namespace mahlwerk::campaign {
namespace {

/// Counted time of a run at an end over that of a replicate of the result.
constexpr double time_share = 0.4;

/// [s] What a run at an end simulates.
double simulated(const results::Replicate& whole) {
  return whole.at_settled.time + time_share * whole.time();
}

/// How many assumed keys can be varied within the time that the result itself simulated.
std::size_t affordable(const results::Outcome& outcome) {
  double budget = 0;
  for (const results::Replicate& r : outcome.replicates) budget += r.energy_balance.time;
  return static_cast<std::size_t>(budget / (2 * simulated(outcome.replicates.front())));
}

/// The case for one end: one replicate in each sense of rotation, shorter, without what the key
/// quantities do not need.
cases::Case at_end(cases::Case made, const results::Outcome& outcome) {
  const results::Replicate& whole = outcome.replicates.front();
  cases::MillingTime milling = made.milling.value_or(cases::MillingTime());
  milling.time = cases::milling_time(made);
  made.milling = milling;
  made.run.engine = outcome.engine;
  made.run.until.reset();
  made.run.settle = whole.at_settled.time;
  made.run.time = time_share * whole.time();
  made.run.replicates = cases::needs_both_senses(made) ? 2 : 1;
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

/// Difference of the first quantity between the ends.
double influence(const results::AssumedInfluence& one) {
  const double span = std::abs(one.at_ends[1].front() - one.at_ends[0].front());
  return std::isnan(span) ? 0 : span;
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

}  // namespace

double assumed_values_cost(const cases::Case& decided, double settling) {
  if (!wanted(decided)) return 0;
  const double whole = static_cast<double>(decided.run.replicates) * (settling + decided.run.time);
  const double key = 2 * (settling + time_share * decided.run.time);
  auto keys = static_cast<double>(assumed_with_range(decided).size());
  if (decided.run.sensitivity == cases::SensitivityMode::automatic)
    keys = std::min(keys, std::floor(whole / key));
  return keys * key / whole;
}

std::optional<results::Sensitivity> sensitivity_to_assumed(const results::Outcome& outcome,
                                                           const ReadWithValue& read,
                                                           const RunOptions& options) {
  cases::Case decided = outcome.mill_case;
  decided.run.engine = outcome.engine;
  if (!wanted(decided) || !results::complete(outcome)) return std::nullopt;
  std::size_t most = affordable(outcome);
  if (outcome.mill_case.run.sensitivity == cases::SensitivityMode::on)
    most = outcome.mill_case.origins.size();
  results::Sensitivity found;
  found.time = time_share * outcome.replicates.front().time();
  found.quantities = results::key_quantities(outcome.summary.quantities);
  std::vector<cases::Case> ends;
  for (const cases::Origin& origin : assumed_with_range(decided)) {
    if (found.keys.size() == most) {
      found.left_out.push_back(origin.key);
      continue;
    }
    try {
      cases::Case low = at_end(read(origin.key, origin.range[0]), outcome);
      cases::Case high = at_end(read(origin.key, origin.range[1]), outcome);
      ends.push_back(std::move(low));
      ends.push_back(std::move(high));
      found.keys.push_back({origin.key, origin.value, origin.range, origin.source, {}});
    } catch (const InputError&) {
      found.left_out.push_back(origin.key);  // an end that does not fit the rest of the case
    }
  }
  if (found.keys.empty() && found.left_out.empty()) return std::nullopt;
  RunOptions own = options;
  own.records = {};
  own.frames = {};
  own.checkpoint = nullptr;
  own.progress = {};  // that of the run itself has reached its end
  const std::vector<results::Outcome> outcomes = run(ends, own);
  if (!std::ranges::all_of(outcomes, results::complete)) return std::nullopt;
  for (std::size_t i = 0; i < found.keys.size(); ++i)
    for (std::size_t end = 0; end < 2; ++end)
      found.keys[i].at_ends[end] = values_of(outcomes[2 * i + end], found.quantities);
  std::ranges::stable_sort(found.keys, std::ranges::greater(), influence);
  return found;
}

}  // namespace mahlwerk::campaign
