// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/campaign/run/resumable_runs.hpp"
#include "mahlwerk/commands/arguments.hpp"

namespace mahlwerk::commands {

/// Options of runs: the number of threads (0: all cores), and stop on Ctrl-C.
campaign::RunOptions run_options(int threads);

/// Computes all points together, with a progress line. `checkpoint` may be null. `lammps`: where
/// and how LAMMPS computes them.
std::vector<results::Outcome> compute(const Running& running,
                                      const std::vector<cases::Case>& points,
                                      const campaign::Streams& streams,
                                      campaign::Checkpoint* checkpoint = nullptr,
                                      const lammps::Launch& lammps = {});
/// The same, resuming from the checkpoints in `kept`, of which one is written every `interval` [s]
/// (empty: 1 s).
std::vector<results::Outcome> compute(const Running& running,
                                      const std::vector<cases::Case>& points,
                                      const campaign::Streams& streams,
                                      campaign::ResumableRuns& kept,
                                      std::optional<double> interval);

/// Reports on stderr if a run did not complete, and how it can be continued. Returns the exit code.
int report_exit_status(const std::vector<results::Outcome>& outcomes,
                       const std::string& continuation = {});
/// Reports an interruption and what is kept, unless `running` is quiet. Returns the exit code.
int report_interrupted(const Running& running, const std::string& kept);

}  // namespace mahlwerk::commands
