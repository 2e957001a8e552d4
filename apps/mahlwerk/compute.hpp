// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "commands.hpp"
#include "mahlwerk/campaign/run/resumable_runs.hpp"

namespace mahlwerk::app {

class ProgressLine;

/// What `request` says of threads, with `line` showing how far it is, until Ctrl-C.
campaign::RunOptions options_of(const Request& request, ProgressLine& line);

/// All points computed together.
std::vector<results::Outcome> compute(const Request& request,
                                      const std::vector<cases::Case>& points,
                                      const campaign::Streams& streams,
                                      campaign::Checkpoint* checkpoint);
/// The same, gone on with where a process was ended.
std::vector<results::Outcome> compute(const Request& request,
                                      const std::vector<cases::Case>& points,
                                      const campaign::Streams& streams,
                                      campaign::ResumableRuns& kept);

}  // namespace mahlwerk::app
