// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Checks the best setting of a search with the soft engine.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/engine_choice.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/campaign/search/search_job.hpp"
#include "mahlwerk/observe/statistics.hpp"

namespace mahlwerk::campaign {
namespace {

/// Number of replicates to run with the soft engine: `wanted`, or fewer within the limit of work; 0
/// if a single one exceeds it.
int affordable(const cases::Case& one, int wanted) {
  const double each = soft_work(one);
  return static_cast<int>(std::min<double>(wanted, max_check_work / each));
}

/// Whether the event engine ran the setting: the soft engine replaces runs that are invalid.
bool ran_by_events(const TrialRuns& runs, const Trial& best) {
  const cases::Case one = runs.at(best.point, 0, 1);
  const auto engine = choose_engine(one).engine;
  return engine == cases::EngineName::event;
}

/// The reason why the setting cannot be checked; empty: run `check.replicates` replicates.
std::string refusal(const TrialRuns& runs, const Trial& best, OptimumCheck& check) {
  try {
    const cases::Case one = runs.at(best.point, 0, 1);
    if (const std::vector<Fault> wrong = run_faults(one); !wrong.empty()) return wrong.front().what;
    check.replicates = affordable(one, static_cast<int>(best.replicates.size()));
    if (check.replicates > 0) return "";
    return fmt::format(
        "that would take about {} core hours; mahlwerk run best.toml --set run.engine=soft runs it",
        two_digits(soft_work(one) / max_soft_work));
  } catch (const InputError& error) {
    return error.faults().front().what;
  }
}

/// Sets the mean of the optimised quantity over the replicates that have a value.
void take(const TrialResult& result, OptimumCheck& check) {
  std::vector<double> values;
  for (const auto& replicate : result.replicates)
    if (std::isfinite(replicate.front())) values.push_back(replicate.front());
  check.failure = result.failure;
  if (values.empty() && check.failure.empty()) check.failure = "its runs gave no value";
  check.value = observe::estimate(values);
}

}  // namespace

std::optional<OptimumCheck> check_best(const SearchJob& job, const Optimum& found,
                                       const CheckRun& run) {
  if (!found.best) return std::nullopt;
  const Trial& best = found.trials[*found.best];
  if (!ran_by_events(*job.runs, best)) return std::nullopt;
  OptimumCheck made{.engine = cases::EngineName::soft};
  const TrialRuns runs = job.runs->with_engine(made.engine);
  made.failure = refusal(runs, best, made);
  if (made.failure.empty()) take(run(runs, {0, best.point, 0, made.replicates}), made);
  return made;
}

}  // namespace mahlwerk::campaign
