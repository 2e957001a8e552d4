// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "mahlwerk/campaign/run/run.hpp"

namespace mahlwerk::campaign {

/// Where the states of a point's replicates are kept, from which job on.
struct CheckpointSlot {
  /// What becomes of the state of a replicate that has ended.
  enum class OnEnd {
    write,           ///< at once
    write_when_due,  ///< with the next that is due, if it took long enough to be worth it
    discard          ///< nobody waits for it: the point ends with it
  };
  Checkpoint* checkpoint = nullptr;
  std::size_t first_job = 0;
  OnEnd on_end = OnEnd::write;
};

/// Runs that wait to be done. Only those at work are in memory: a point's case is asked for when
/// its first replicate begins, and its outcome is given away when the last one ends.
struct RunQueue {
  std::size_t size = 0;
  /// The case of a point; an InputError makes it fail. From several threads at once.
  std::function<cases::Case(std::size_t point)> open;
  /// What came of it, interrupted or not; from several threads at once. What it throws ends all.
  std::function<void(std::size_t point, results::Outcome&& outcome)> done;
  /// Instead of `done`, once none of its replicates is at work: why the point cannot be run. If
  /// there is none, it ends all; so does trouble with files, which is not the point's.
  std::function<void(std::size_t point, const std::exception& why)> failed;
  std::function<CheckpointSlot(std::size_t point)> checkpoint_slot;  ///< none: no state is kept
  int threads_per_replicate = 1;  ///< that share the work of one replicate
  double total = 0;  ///< [s] to be simulated in all; with `weight`, of that; 0: not known
  /// What a point's second counts towards `total`; none: 1.
  std::function<double(std::size_t point)> weight;
};

/// Works a queue off, as many replicates at a time as options.threads, each point's replicates
/// together. Returns when all is done, or options.stop was set. The outcomes do not depend on how
/// many threads there are.
void run_queue(const RunQueue& queue, const RunOptions& options);

}  // namespace mahlwerk::campaign
