// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "compute.hpp"

#include <fmt/format.h>

#include <functional>

#include "messages.hpp"
#include "progress.hpp"

namespace mahlwerk::app {

campaign::RunOptions options_of(const Request& request, ProgressLine& line) {
  campaign::RunOptions options;
  options.threads = request.threads;
  options.lammps.ranks = request.ranks;
  options.stop = &stop_wanted();
  options.progress = [&](const campaign::Progress& p) { line.show(p); };
  return options;
}

std::vector<results::Outcome> compute(const Request& request,
                                      const std::vector<cases::Case>& points,
                                      const campaign::Streams& streams,
                                      campaign::Checkpoint* checkpoint,
                                      const std::filesystem::path& lammps) {
  ProgressLine line(request.quiet);
  campaign::RunOptions options = options_of(request, line);
  options.checkpoint = checkpoint;
  options.lammps.folder = lammps;
  options.lammps.resume = request.resume;
  streams.attach(options);
  return campaign::run(points, options);
}

std::vector<results::Outcome> compute(const Request& request,
                                      const std::vector<cases::Case>& points,
                                      const campaign::Streams& streams,
                                      campaign::ResumableRuns& kept, bool replays_of_all) {
  ProgressLine line(request.quiet);
  campaign::RunOptions options = options_of(request, line);
  options.replays_of_all = replays_of_all;
  WriteErrorReporter not_kept;
  const auto on_resume = [&](std::size_t begun) {
    const bool alone = points.size() == 1;
    if (!request.quiet && !request.json)
      to_stderr(fmt::format("{} where {} ended\n",
                            alone ? "resuming a run"
                                  : fmt::format("resuming {} of {} settings", begun, points.size()),
                            alone ? "it was" : "they were"));
  };
  std::vector<results::Outcome> outcomes = kept.compute(points, streams, options,
                                                        {.version = version(),
                                                         .interval = request.checkpoint.value_or(1),
                                                         .on_resume = on_resume,
                                                         .on_write_error = std::ref(not_kept)});
  not_kept.repeat();
  return outcomes;
}

}  // namespace mahlwerk::app
