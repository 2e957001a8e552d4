// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "mahlwerk/campaign/search/trial_runs.hpp"
#include "mahlwerk/report/optimum.hpp"

// What optimise and match share: settings are looked for, and told.
namespace mahlwerk::app {

/// An outcome that settings are judged by.
struct Judged {
  std::string name, unit, about;  ///< as in summary.json
};

struct SearchJob {
  const campaign::TrialRuns* runs = nullptr;
  campaign::Goal goal;
  std::vector<Judged> outcomes;      ///< what is to be best, then what is limited
  std::vector<cases::Limit> limits;  ///< of the latter
  campaign::TrialRuns::Measure measure;
  std::string measure_name = {};    ///< tells it apart from others
  std::filesystem::path kept = {};  ///< where what was run is kept until the search has ended
};

/// Throws InputError if there are more keys than can be looked over, or the case has a [sweep].
void check_keys(const cases::Case& what, const std::vector<cases::SweptKey>& over,
                std::string_view section);

/// Looks for the best settings. Throws campaign::Interrupted.
campaign::Optimum look(const Request& request, const SearchJob& job);

report::OptimumReport report_of(const SearchJob& job, const campaign::Optimum& found);
std::string optimum_json(const report::OptimumReport& found, std::string_view version);

}  // namespace mahlwerk::app
