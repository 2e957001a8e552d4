// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "mahlwerk/campaign/run/resumable_runs.hpp"
#include "mahlwerk/campaign/search/search_job.hpp"
#include "mahlwerk/report/optimum.hpp"
#include "mahlwerk/results/files/json_value.hpp"

// What optimise and match share: settings are looked for, and told.
namespace mahlwerk::app {

/// What a search keeps beside its results until these are written: what it was told, and states of
/// runs. It is this process's alone; where nothing was kept, nothing stays.
class ResumableSearch {
 public:
  /// Throws InputError as ResumableRuns does.
  explicit ResumableSearch(const std::filesystem::path& results);
  ~ResumableSearch();
  ResumableSearch(const ResumableSearch&) = delete;
  ResumableSearch& operator=(const ResumableSearch&) = delete;

  campaign::ResumableRuns& runs() { return runs_; }
  const std::filesystem::path& trials() const { return trials_; }
  int report_interrupted() const;  ///< what is kept; the exit code
  void remove();                   ///< the results have been written

 private:
  bool has_trials() const;
  bool has_states() const;

  campaign::ResumableRuns runs_;
  std::filesystem::path trials_;
  bool removed_ = false;
};

/// Looks for the best settings. Throws Interrupted.
campaign::Optimum run_search(const Request& request, const campaign::SearchJob& job,
                             const ResumableSearch& kept);

/// Runs the best setting by the soft engine where its own runs are invalid, unless that takes too
/// long. Throws Interrupted.
std::optional<report::OptimumCheck> check_best(const Request& request,
                                               const campaign::SearchJob& job,
                                               const campaign::Optimum& found,
                                               const ResumableSearch& kept);

report::OptimumReport report_of(const campaign::SearchJob& job, const campaign::Optimum& found);
results::Json optimum_json(const report::OptimumReport& found, std::string_view version);

}  // namespace mahlwerk::app
