// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/run/replicate.hpp"

namespace mahlwerk::campaign {

/// The states of all replicates of a run in one file, for a run that may be ended and gone on with
/// later. The file is written aside and put in place whole. Threads may call at the same time.
class Checkpoint {
 public:
  /// Told when the file cannot be written, once until it can be again. The run goes on without.
  using WriteErrorCallback = std::function<void(const Fault&)>;

  /// `what` tells the run of `jobs` replicates apart from others: cases and version. The state of
  /// each is due every `every` [s]. What a process that was killed left half written is removed:
  /// the file must be this process's alone.
  Checkpoint(std::filesystem::path file, std::string what, std::size_t jobs, double every,
             WriteErrorCallback on_write_error = {});

  /// Takes the states from the file. Throws InputError if there is none, it is damaged, or it is of
  /// another run.
  void load();
  bool loaded() const { return loaded_; }

  bool has_state(std::size_t job) const;                 ///< whether there is a kept state of it
  void restore(std::size_t job, ReplicateRun& replica);  ///< to its kept state, if there is one
  bool due(std::size_t job) const;
  /// Into the file if `now`, or if that is due; else it waits for the next that is, or for flush().
  void save(std::size_t job, ReplicateRun& replica, bool now = false);
  void flush();
  void remove();  ///< the run has ended as wanted

  /// That the last try to write the file did not succeed, and why; nothing if it did.
  std::optional<Fault> write_error() const;

 private:
  void write();
  std::filesystem::path temporary_file() const { return file_.string() + ".part"; }

  std::filesystem::path file_;
  std::string run_id_;
  std::chrono::duration<double> interval_;
  std::vector<std::string> states_;                              // by job
  std::vector<std::chrono::steady_clock::time_point> saved_at_;  // when
  std::chrono::steady_clock::time_point written_at_ = std::chrono::steady_clock::now();
  bool loaded_ = false, unwritten_ = false;
  std::optional<Fault> write_error_;  // the last try to write
  WriteErrorCallback on_write_error_;
  mutable std::mutex mutex_;
};

}  // namespace mahlwerk::campaign
