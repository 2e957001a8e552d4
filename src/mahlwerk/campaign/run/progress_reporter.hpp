// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <mutex>

#include "mahlwerk/campaign/run/run.hpp"

namespace mahlwerk::campaign {

/// Progress of all replicates together, reported at most ten times a second.
class ProgressReporter {
 public:
  ProgressReporter(const RunOptions& options, double total) : options_(&options) {
    sum_.total = total;
  }

  void add(double simulated, double collisions, double residual) {
    if (!options_->progress) return;
    const std::lock_guard lock(mutex_);
    sum_.simulated += simulated;
    sum_.collisions += collisions;
    sum_.residual = std::max(sum_.residual, residual);
    const auto now = std::chrono::steady_clock::now();
    if (now - reported_ < std::chrono::milliseconds(100)) return;
    reported_ = now;
    options_->progress(sum_);
  }

 private:
  const RunOptions* options_;
  Progress sum_;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point reported_ = std::chrono::steady_clock::now();
};

}  // namespace mahlwerk::campaign
