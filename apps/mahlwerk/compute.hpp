// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "commands.hpp"
#include "mahlwerk/campaign/run/resumable_runs.hpp"

namespace mahlwerk::app {

class ProgressLine;

/// Run options: threads of `request`, progress on `line`, stop on Ctrl-C.
campaign::RunOptions options_of(const Request& request, ProgressLine& line);

/// Computes all points together. `checkpoint` may be null. `lammps`: the folder of
/// runs by LAMMPS; empty: temporary ones.
std::vector<results::Outcome> compute(const Request& request,
                                      const std::vector<cases::Case>& points,
                                      const campaign::Streams& streams,
                                      campaign::Checkpoint* checkpoint,
                                      const std::filesystem::path& lammps = {});
/// The same, resuming from the checkpoints in `kept`. `replays_of_all`: every replicate keeps
/// frames (campaign::RunOptions).
std::vector<results::Outcome> compute(const Request& request,
                                      const std::vector<cases::Case>& points,
                                      const campaign::Streams& streams,
                                      campaign::ResumableRuns& kept, bool replays_of_all = false);

}  // namespace mahlwerk::app
