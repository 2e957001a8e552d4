// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/conclude.hpp"

#include <algorithm>

#include "mahlwerk/campaign/run/engine_notices.hpp"
#include "mahlwerk/campaign/run/rolling.hpp"
#include "mahlwerk/results/notices/warnings.hpp"
#include "mahlwerk/results/quantities/replicate_setup.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"

namespace mahlwerk::campaign {

results::Outcome begun_outcome(const cases::Case& mill_case, const EngineChoice& choice) {
  const cases::Case decided = decided_case(mill_case, choice);
  results::Outcome outcome{.mill_case = decided,
                           .replicates = {static_cast<std::size_t>(mill_case.run.replicates),
                                          results::unrun_replicate(decided)}};
  outcome.mill_case.run.engine = mill_case.run.engine;
  outcome.mill_case.run.settle = mill_case.run.settle;
  outcome.engine = choice.engine;
  return outcome;
}

void conclude(results::Outcome& outcome, const EngineChoice& choice,
              const std::atomic<bool>* stop) {
  for (const results::Replicate& r : outcome.replicates) outcome.cpu_seconds += r.cpu_seconds;
  outcome.summary = results::summarise(outcome);
  outcome.notices = results::warnings(outcome);
  append(outcome.notices, rolling_notices(outcome));
  append(outcome.notices, engine_notices(outcome, choice, stop));
  std::ranges::stable_sort(outcome.notices, std::ranges::greater(), &Notice::severity);
}

}  // namespace mahlwerk::campaign
