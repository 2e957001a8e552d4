// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/compute.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "mahlwerk/commands/places.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"

namespace mahlwerk::commands {
namespace {

/// The reason why the first stopped run was stopped; empty if none was.
std::string first_failure(const std::vector<results::Outcome>& outcomes) {
  for (const results::Outcome& outcome : outcomes)
    for (const results::Replicate& r : outcome.replicates)
      if (!r.stop_reason.empty()) return r.stop_reason;
  return "";
}

}  // namespace

campaign::RunOptions run_options(int threads) {
  campaign::RunOptions options;
  options.threads = threads;
  options.stop = &stop_wanted();
  return options;
}

std::vector<results::Outcome> compute(const Running& running,
                                      const std::vector<cases::Case>& points,
                                      const campaign::Streams& streams,
                                      campaign::Checkpoint* checkpoint,
                                      const lammps::Launch& lammps) {
  ProgressLine line(running.quiet);
  campaign::RunOptions options = run_options(running.threads);
  options.progress = [&](const campaign::Progress& p) { line.show(p); };
  options.checkpoint = checkpoint;
  options.lammps = lammps;
  options.sums_up = true;
  streams.attach(options);
  return campaign::run(points, options);
}

std::vector<results::Outcome> compute(const Running& running,
                                      const std::vector<cases::Case>& points,
                                      const campaign::Streams& streams,
                                      campaign::ResumableRuns& kept,
                                      std::optional<double> interval) {
  ProgressLine line(running.quiet);
  campaign::RunOptions options = run_options(running.threads);
  options.progress = [&](const campaign::Progress& p) { line.show(p); };
  WriteErrorReporter not_kept;
  const auto on_resume = [&](std::size_t begun) {
    const bool alone = points.size() == 1;
    if (running.prints_text())
      to_stderr(fmt::format("{} where {} ended\n",
                            alone ? "resuming a run"
                                  : fmt::format("resuming {} of {} settings", begun, points.size()),
                            alone ? "it was" : "they were"));
  };
  std::vector<results::Outcome> outcomes = kept.compute(points, streams, options,
                                                        {.version = version(),
                                                         .interval = interval.value_or(1),
                                                         .on_resume = on_resume,
                                                         .on_write_error = std::ref(not_kept)});
  not_kept.repeat();
  return outcomes;
}

int report_exit_status(const std::vector<results::Outcome>& outcomes,
                       const std::string& continuation) {
  constexpr const char* kept = "results computed until then are kept, and marked incomplete";
  if (const std::string why = first_failure(outcomes); !why.empty())
    return report_end(stopped_by_physics,
                      fmt::format("stopped: {}\nResults computed until then are kept.", why),
                      {Fault{"", why, kept, "stopped"}});
  if (!stop_wanted()) return success;
  const bool whole = std::ranges::all_of(outcomes, results::complete);
  const std::string words = (whole ? "the results are complete" : kept) + continuation;
  return report_end(interrupted, fmt::format("interrupted: {}.", words),
                    {Fault{"", "interrupted", words, "interrupted"}});
}

int report_interrupted(const Running& running, const std::string& kept) {
  if (!running.prints_errors()) return interrupted;
  return report_end(interrupted, "interrupted: " + kept,
                    {Fault{"", "interrupted", kept, "interrupted"}});
}

}  // namespace mahlwerk::commands
