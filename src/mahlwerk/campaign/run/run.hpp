// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "mahlwerk/campaign/points/plan.hpp"
#include "mahlwerk/campaign/run/checkpoint.hpp"
#include "mahlwerk/campaign/run/memory.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/lammps/launch.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/scene/observer.hpp"

namespace mahlwerk::campaign {

/// Progress of a run, for the progress line.
struct Progress {
  double simulated = 0, total = 0;  ///< [s] over all replicates
  double collisions = 0;
  double residual = 0;  ///< [1] worst relative residual of the energy balance so far
};

/// Makes the observer that records all collisions of one replicate of one point; empty: none is
/// recorded.
using ObserverFactory =
    std::function<std::unique_ptr<scene::Observer>(std::size_t point, int replicate)>;

/// Makes the files for the frames of one replicate of one point; empty: there are none.
using FrameFilesFactory =
    std::function<std::unique_ptr<results::FrameFiles>(std::size_t point, int replicate)>;

struct RunOptions {
  int threads = 0;                          ///< 0: as many as the machine has
  const std::atomic<bool>* stop = nullptr;  ///< when set: end regularly, keep what was computed
  std::function<void(const Progress&)> progress;  ///< never called from two threads at once
  ObserverFactory records;
  FrameFilesFactory frames;
  /// Whether every replicate keeps frames in memory (results::Replicate::replay), not only the
  /// first.
  bool replays_of_all = false;
  /// Whether maps and spectra of many replicates are summed up and forgotten: the tables of the
  /// outcome are the same, those of single replicates are gone (results::Replicate::read_before).
  bool sums_up = false;
  /// [bytes] available for all concurrent replicates; a run that needs more is refused.
  std::optional<double> memory = memory_available();
  Checkpoint* checkpoint = nullptr;  ///< keeps states, and supplies them
  lammps::Launch lammps;  ///< in its folder each run has one of its own (lammps_folder())
};

/// Runs every replicate of every case, several at a time; the result does not depend on their
/// number. Throws InputError if an engine of this version cannot run one of the cases, or memory is
/// short.
std::vector<results::Outcome> run(const std::vector<cases::Case>& points,
                                  const RunOptions& options = {});
results::Outcome run(const cases::Case& mill_case, const RunOptions& options = {});

/// `asked`, or the number of cores if that is 0.
int thread_count(int asked);

/// The cases of a plan: `mill_case` itself without [sweep], else one case per point of its plan, in
/// order, but at most `most`. Throws InputError with the faults of all points.
std::vector<cases::Case> points(const cases::Case& mill_case, const cases::Catalogue& catalogue,
                                const std::vector<cases::Override>& overrides,
                                std::size_t most = Plan::max_points);

}  // namespace mahlwerk::campaign
