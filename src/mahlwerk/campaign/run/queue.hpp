// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <functional>
#include <string>

#include "mahlwerk/campaign/run/run.hpp"

namespace mahlwerk::campaign {

/// Where the states of a point's replicates are kept, and the job of its first replicate.
struct CheckpointSlot {
  /// What to do with the state of a replicate that has ended.
  enum class OnEnd {
    write,           ///< write it as soon as writes take little of the time
    write_when_due,  ///< write it with the next due write, if the replicate took long enough
    discard          ///< not needed: the point ends with this replicate
  };
  Checkpoint* checkpoint = nullptr;
  std::size_t first_job = 0;
  OnEnd on_end = OnEnd::write;
};

/// A queue of runs. Only active points are in memory: `open` returns a point's case when its first
/// replicate begins, `done` takes its outcome when the last one ends.
struct RunQueue {
  std::size_t size = 0;
  /// Returns the case of a point; an InputError makes the point fail. Called from several threads.
  std::function<cases::Case(std::size_t point)> open;
  /// Takes the outcome of a point, interrupted or not. Called from several threads. An exception
  /// ends the queue.
  std::function<void(std::size_t point, results::Outcome&& outcome)> done;
  /// Called instead of `done` when a point cannot be run, once none of its replicates is active. If
  /// empty, the failure ends the queue. A failure to write files always does.
  std::function<void(std::size_t point, const std::exception& why)> failed;
  std::function<CheckpointSlot(std::size_t point)> checkpoint_slot;  ///< empty: no state is kept
  int threads_per_replicate = 1;  ///< threads that share the work of one replicate
  double total = 0;               ///< [s] simulated in all, weighted by `weight`; 0: not known
  /// Weight of a point's simulated time in `total`; empty: 1.
  std::function<double(std::size_t point)> weight;
};

/// Whether a failure concerns one point only. A file that cannot be written and a catalogue that
/// cannot be read concern all points, and so does memory that was free before the point began.
bool is_point_failure(const std::exception& why);

/// Runs all points of a queue in options.threads threads, the replicates of a point together; a
/// thread runs one replicate at a time, or several side by side (replicates_together()). Returns
/// when all have ended, or when options.stop is set. Outcomes do not depend on the number of
/// threads.
void run_queue(const RunQueue& queue, const RunOptions& options);

}  // namespace mahlwerk::campaign
