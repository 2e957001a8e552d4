// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/campaign/search/trial_runs.hpp"

namespace mahlwerk::campaign {

/// An outcome that settings are judged by.
struct SearchOutcome {
  std::string name, unit, about;  ///< as in summary.json
};

struct SearchJob {
  const TrialRuns* runs = nullptr;
  Goal goal;
  std::vector<SearchOutcome> outcomes;  ///< what is to be best, then what is limited
  std::vector<cases::Limit> limits;     ///< of the latter
  TrialRuns::Measure measure;
  std::string measure_name = {};  ///< tells it apart from others
};

/// Throws InputError if there are more keys than can be looked over, or the case has a [sweep].
void check_keys(const cases::Case& what, const std::vector<cases::SweptKey>& over,
                std::string_view section);

/// Of a search over the keys of these runs, which are kept by reference.
Goal goal_of(const TrialRuns& runs, std::int64_t settings, std::int64_t replicates,
             bool maximise = false);

/// What [optimise] of the runs' case asks for; the runs are kept by reference. Throws InputError
/// where it names quantities that the case does not have.
SearchJob optimise_job(const TrialRuns& runs);

}  // namespace mahlwerk::campaign
