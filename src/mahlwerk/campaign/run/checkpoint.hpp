// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "mahlwerk/campaign/run/replicate.hpp"

namespace mahlwerk::campaign {

/// The states of all replicates of a run in one file, for a run that may be ended and gone on with
/// later. The file is written aside and put in place whole. Threads may call at the same time.
class Checkpoint {
 public:
  /// `what` tells the run of `jobs` replicates apart from others: cases and version. The state of
  /// each is due every `every` [s].
  Checkpoint(std::filesystem::path file, std::string what, std::size_t jobs, double every);

  /// Takes the states from the file. Throws InputError if there is none, it is damaged, or it is of
  /// another run.
  void load();
  bool loaded() const { return loaded_; }

  void restore(std::size_t job, Replica& replica);  ///< to its kept state, if there is one
  bool due(std::size_t job) const;
  /// Into the file if `now`, or if that is due; else it waits for the next that is, or for flush().
  void keep(std::size_t job, Replica& replica, bool now = false);
  void flush();
  void remove();                             ///< the run has ended as wanted
  bool written() const { return written_; }  ///< whether the last try to write the file succeeded

 private:
  void write();

  std::filesystem::path file_;
  std::string what_;
  std::chrono::duration<double> every_;
  std::vector<std::string> states_;                          // by job
  std::vector<std::chrono::steady_clock::time_point> kept_;  // when
  std::chrono::steady_clock::time_point filed_ = std::chrono::steady_clock::now();
  bool loaded_ = false, written_ = true, waits_ = false;
  mutable std::mutex mutex_;
};

}  // namespace mahlwerk::campaign
