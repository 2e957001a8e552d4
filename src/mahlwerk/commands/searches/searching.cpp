// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/searches/searching.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/points/plan.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/json.hpp"

namespace mahlwerk::commands {
ResumableSearch::ResumableSearch(const std::filesystem::path& results, const char* file,
                                 std::string what)
    : runs_(results), trials_(runs_.folder() / file), what_(std::move(what)) {}

ResumableSearch::~ResumableSearch() {
  if (!removed_ && !has_trials() && !has_states()) remove();
}

bool ResumableSearch::has_trials() const {
  std::error_code none;
  return std::filesystem::exists(trials_, none);
}

bool ResumableSearch::has_states() const {
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(runs_.folder(), none))
    if (entry.path().extension() == ".checkpoint") return true;
  return false;
}

int ResumableSearch::report_interrupted(const std::string& found) const {
  const bool trials = has_trials(), states = has_states();
  std::string what = trials ? what_ : "";
  if (trials && states) what += " and ";
  if (states) what += "checkpoints of the mills' own runs";
  const std::string remedy =
      what.empty() ? "run the same command again to start over"
                   : fmt::format("{} are kept in {}; run the same command again to resume", what,
                                 runs_.folder().string());
  const std::string words =
      (what.empty() ? "interrupted before any run ended: " : "interrupted: ") + found + remedy;
  return report_end(interrupted, words, {Fault{"", "interrupted", found + remedy, "interrupted"}});
}

void ResumableSearch::remove() {
  removed_ = true;  // from here on another process may own the folder
  std::error_code none;
  std::filesystem::remove(trials_, none);
  runs_.remove();
}

campaign::Optimum run_search(const Running& running, const campaign::SearchJob& job,
                             const ResumableSearch& kept) {
  ProgressLine line(running.quiet);
  const campaign::RunOptions options = run_options(running.threads);
  int settings = 0, runs = 0;
  WriteErrorReporter not_kept;
  campaign::TrialStore store(kept.trials(), job.measure_name, std::ref(not_kept));
  campaign::Optimum found = campaign::optimise(job, [&](const auto& asked) {
    line.show(fmt::format("{} settings tried, {} runs", settings, runs));
    for (const campaign::TrialRequest& one : asked) {
      settings += one.first == 0 ? 1 : 0;
      runs += one.count;
    }
    return job.runs->run(asked, job.measure, options, store, version());
  });
  not_kept.repeat();
  return found;
}

void print_found(const std::string& summary, const Places& places, bool written) {
  to_stdout(summary + '\n');
  if (written) places_to_stdout(places);
}

std::optional<campaign::OptimumCheck> check_best(const Running& running,
                                                 const campaign::SearchJob& job,
                                                 const campaign::Optimum& found,
                                                 const ResumableSearch& kept) {
  ProgressLine line(running.quiet);
  const campaign::RunOptions options = run_options(running.threads);
  return campaign::check_best(
      job, found, [&](const campaign::TrialRuns& runs, const campaign::TrialRequest& one) {
        line.show("checking the best setting with the soft engine");
        WriteErrorReporter not_kept;
        campaign::TrialStore store(kept.trials(), job.measure_name, std::ref(not_kept));
        return runs.run({one}, job.measure, options, store, version()).front();
      });
}

}  // namespace mahlwerk::commands
