// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <string>

#include "mahlwerk/campaign/run/run.hpp"

namespace mahlwerk::commands {

class Listener;

/// Set by Ctrl-C, SIGTERM or SIGHUP after catch_ctrl_c(), or by the listener of this thread. A
/// second signal other than SIGHUP ends the program at once.
const std::atomic<bool>& stop_wanted();
/// Call it before a command makes its first file or folder.
void catch_ctrl_c();
/// Until then these signals end the program at once, with a message and the exit code of an
/// interruption: there is nothing to keep. Call it first.
void catch_early_signals();

/// Progress of a run on stderr: on a terminal one line that is overwritten, else a new line every
/// 30 s (or MAHLWERK_PROGRESS_EVERY seconds). A listener gets every line.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  void show(const campaign::Progress& progress);
  void show(std::string line);
  /// "200 s left" of work of which this share is done; in minutes and hours on a terminal. Empty if
  /// the share has not grown since the first call.
  std::string left(double share);

 private:
  void warn_if_endless(const campaign::Progress& progress);

  using Clock = std::chrono::steady_clock;
  Listener* listener_;
  bool on_, terminal_, shown_ = false;
  std::chrono::duration<double> every_{0};  // between two lines without a terminal
  Clock::time_point started_ = Clock::now(), last_ = started_;
  std::optional<double> first_share_;   // of the first call of left(): what is resumed took no time
  Clock::time_point rated_ = started_;  // when the rate of the run was last looked at
  double simulated_ = 0;                // [s] then
  bool warned_ = false;
};

}  // namespace mahlwerk::commands
