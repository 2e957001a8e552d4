// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "mahlwerk/campaign/run/checkpoint.hpp"
#include "mahlwerk/campaign/run/memory.hpp"
#include "mahlwerk/campaign/sweep/plan.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/scene/observer.hpp"

namespace mahlwerk::campaign {

/// Where a run stands, for the line a user watches.
struct Progress {
  double simulated = 0, total = 0;  ///< [s] over all replicates
  double collisions = 0;
  double residual = 0;  ///< [1] worst relative residual of the energy balance so far
};

/// Makes the observer that keeps every record of one replicate of one point; empty: none is kept.
using ObserverFactory =
    std::function<std::unique_ptr<scene::Observer>(std::size_t point, int replicate)>;

/// Makes the files that get the frames of one replicate of one point; empty: there are none.
using FrameFilesFactory =
    std::function<std::unique_ptr<results::FrameFiles>(std::size_t point, int replicate)>;

struct RunOptions {
  int threads = 0;                                ///< 0: as many as the machine has
  const std::atomic<bool>* stop = nullptr;        ///< set: end cleanly, keep what was computed
  std::function<void(const Progress&)> progress;  ///< never from two threads at once
  ObserverFactory records;
  FrameFilesFactory frames;
  /// [bytes] there are for all that runs at once; more is refused before it starts.
  std::optional<double> memory = memory_available();
  Checkpoint* checkpoint = nullptr;  ///< where states are kept, and taken from
};

/// Runs every replicate of every case, several at a time; the result does not depend on how many.
/// Throws InputError if an engine of this version cannot run one of them.
std::vector<results::Outcome> run(const std::vector<cases::Case>& points,
                                  const RunOptions& options = {});
results::Outcome run(const cases::Case& what, const RunOptions& options = {});

/// As many as asked for, or as the machine has cores where that is 0.
int thread_count(int asked);

/// A case without [sweep] is itself; one with it becomes a case per point of its plan, in order,
/// but no more than `most`. Throws InputError with the faults of all points.
std::vector<cases::Case> points(const cases::Case& what, const cases::Catalogue& catalogue,
                                const std::vector<cases::Override>& overrides,
                                std::size_t most = Plan::most_points);

}  // namespace mahlwerk::campaign
