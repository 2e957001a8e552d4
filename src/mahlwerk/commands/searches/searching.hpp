// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mahlwerk/campaign/run/resumable_runs.hpp"
#include "mahlwerk/campaign/search/search_job.hpp"
#include "mahlwerk/commands/arguments.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"

// Search for settings, shared by optimise and match.
namespace mahlwerk::commands {

/// Files that a search keeps beside its results until the results are written: finished trials and
/// checkpoints of runs. The folder is locked by this process. The destructor removes the folder if
/// it holds neither.
class ResumableSearch {
 public:
  /// `file`: name of that of the trials, `what`: what they are. Throws InputError as ResumableRuns
  /// does.
  explicit ResumableSearch(const std::filesystem::path& results, const char* file = "trials.sqlite",
                           std::string what = "the finished runs of the search");
  ~ResumableSearch();
  ResumableSearch(const ResumableSearch&) = delete;
  ResumableSearch& operator=(const ResumableSearch&) = delete;

  campaign::ResumableRuns& runs() { return runs_; }
  const std::filesystem::path& trials() const { return trials_; }
  /// Reports what is kept, after `found`: what was found so far. Returns the exit code.
  int report_interrupted(const std::string& found = {}) const;
  void remove();  ///< call after the results are written

 private:
  bool has_trials() const;
  bool has_states() const;

  campaign::ResumableRuns runs_;
  std::filesystem::path trials_;
  std::string what_;
  bool removed_ = false;
};

/// Runs the optimisation. Throws Interrupted.
campaign::Optimum run_search(const Running& running, const campaign::SearchJob& job,
                             const ResumableSearch& kept);

/// Runs the best setting with the soft engine if the event engine ran it, unless that takes too
/// long. Throws Interrupted.
std::optional<campaign::OptimumCheck> check_best(const Running& running,
                                                 const campaign::SearchJob& job,
                                                 const campaign::Optimum& found,
                                                 const ResumableSearch& kept);

/// Prints the summary of a result and, if it was `written`, where.
void print_found(const std::string& summary, const Places& places, bool written);

}  // namespace mahlwerk::commands
