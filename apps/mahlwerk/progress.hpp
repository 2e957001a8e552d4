// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <string>

#include "mahlwerk/campaign/run/run.hpp"

namespace mahlwerk::app {

/// Set by Ctrl-C while it is caught; a second Ctrl-C ends the program at once.
const std::atomic<bool>& stop_wanted();
void catch_ctrl_c();

/// One line that tells where a run stands; only on a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  void show(const campaign::Progress& progress);
  void show(std::string line);

 private:
  bool on_, shown_ = false;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace mahlwerk::app
