// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "mahlwerk/campaign/run/kept_runs.hpp"
#include "mahlwerk/campaign/search/search_job.hpp"
#include "mahlwerk/report/optimum.hpp"
#include "mahlwerk/results/files/json_value.hpp"

// What optimise and match share: settings are looked for, and told.
namespace mahlwerk::app {

/// What a search keeps beside its results until these are written: what it was told, and states of
/// runs. It is this process's alone; where nothing was kept, nothing stays.
class KeptSearch {
 public:
  /// Throws InputError as KeptRuns does.
  explicit KeptSearch(const std::filesystem::path& results);
  ~KeptSearch();
  KeptSearch(const KeptSearch&) = delete;
  KeptSearch& operator=(const KeptSearch&) = delete;

  campaign::KeptRuns& runs() { return runs_; }
  const std::filesystem::path& trials() const { return trials_; }
  int tell_interrupted() const;  ///< what is kept; the exit code
  void remove();                 ///< the results have been written

 private:
  bool has_trials() const;
  bool has_states() const;

  campaign::KeptRuns runs_;
  std::filesystem::path trials_;
  bool removed_ = false;
};

/// Looks for the best settings. Throws Interrupted.
campaign::Optimum look(const Request& request, const campaign::SearchJob& job,
                       const KeptSearch& kept);

/// Runs the best setting by the soft engine where its own runs are invalid, unless that takes too
/// long. Throws Interrupted.
std::optional<report::OptimumCheck> check_best(const Request& request,
                                               const campaign::SearchJob& job,
                                               const campaign::Optimum& found,
                                               const KeptSearch& kept);

report::OptimumReport report_of(const campaign::SearchJob& job, const campaign::Optimum& found);
results::Json optimum_json(const report::OptimumReport& found, std::string_view version);

}  // namespace mahlwerk::app
