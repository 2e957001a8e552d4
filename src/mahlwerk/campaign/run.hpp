// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::campaign {

/// Where a run stands, for the line a user watches.
struct Progress {
  double simulated = 0, wanted = 0;  ///< [s] over all replicates
  double collisions = 0;
  double residual = 0;  ///< [1] worst relative residual of the energy balance so far
};

struct Options {
  int threads = 0;                         ///< 0: as many as the machine has
  const std::atomic<bool>* stop = nullptr;  ///< set: end cleanly, keep what was computed
  std::function<void(const Progress&)> progress;  ///< called from one thread, a few times a second
};

/// Runs every replicate of a case, several at a time; the result does not depend on how many.
results::Outcome run(const cases::Case& what, const Options& options = {});

/// A case without [sweep] is itself; one with it becomes a case per point of the full product, in order.
/// Throws InputError with the faults of all points.
std::vector<cases::Case> points(const cases::Case& what, const cases::Catalogue& catalogue,
                                const std::vector<cases::Override>& overrides);

}  // namespace mahlwerk::campaign
