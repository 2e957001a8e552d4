// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/campaign/search/trial_runs.hpp"

namespace mahlwerk::campaign {

struct SearchJob {
  const TrialRuns* runs = nullptr;
  Goal goal;
  std::vector<SearchOutcome> outcomes;  ///< the objective, then the limited outcomes
  std::vector<cases::Limit> limits;     ///< of the limited outcomes
  TrialRuns::Measure measure;
  std::string measure_name = {};  ///< identifies `measure` in a TrialStore
};

/// Throws InputError if there are more than 8 keys, or the case has a [sweep].
void check_keys(const cases::Case& mill_case, const std::vector<cases::SweptKey>& over,
                std::string_view section);

/// The goal of a search over the keys of these runs, which are kept by reference.
Goal goal_of(const TrialRuns& runs, std::int64_t settings, std::int64_t replicates,
             bool maximise = false);

/// The search that [optimise] of the runs' case describes; the runs are kept by reference. Throws
/// InputError if it names quantities that the case does not have.
SearchJob optimise_job(const TrialRuns& runs);

/// Finds the best setting of a job by its runs, with the values of its keys and their texts.
Optimum optimise(const SearchJob& job, const Simulation& run);

/// Runs a setting with another engine.
using CheckRun = std::function<TrialResult(const TrialRuns& runs, const TrialRequest& one)>;
/// Runs the best setting with the soft engine if the event engine ran it, unless that takes too
/// long.
std::optional<OptimumCheck> check_best(const SearchJob& job, const Optimum& found,
                                       const CheckRun& run);

}  // namespace mahlwerk::campaign
