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

/// The states of all replicates of a run in one file, for a run that can be interrupted and
/// resumed. The file is written under a temporary name, then renamed. Thread-safe.
class Checkpoint {
 public:
  /// Called when the file cannot be written, once until a write succeeds. The run continues.
  using WriteErrorCallback = std::function<void(const Fault&)>;

  /// When states are kept that nobody asked for.
  struct Unasked {
    double after = 60;                           ///< [s] no file is written before
    std::size_t most = std::size_t{256} << 20U;  ///< [bytes] more are not kept
  };

  /// `what` identifies the run of `jobs` replicates: cases and version. The state of each is due
  /// every `every` [s]. Removes the partial file of a killed process: no other process may use
  /// `file`.
  Checkpoint(std::filesystem::path file, std::string what, std::size_t jobs, double every,
             WriteErrorCallback on_write_error = {}, std::optional<Unasked> unasked = {});

  /// Reads the states from the file. Throws InputError if there is none, it is damaged, or it
  /// belongs to another run.
  void load();
  bool loaded() const { return loaded_; }

  bool has_state(std::size_t job) const;                 ///< whether a state of it is kept
  void restore(std::size_t job, ReplicateRun& replica);  ///< sets its kept state, if there is one
  bool due(std::size_t job) const;                       ///< whether a save of its state is due
  /// Keeps the state of a replicate in memory.
  void save(std::size_t job, ReplicateRun& replica);
  void
  write_if_due();  ///< writes states that are not yet in the file, if the last write is long ago
  void flush();    ///< writes states that are not yet in the file
  void remove();   ///< removes the file once the run has ended
  const std::filesystem::path& file() const { return file_; }
  bool written() const;  ///< whether the file holds states of this run

  /// Why the last write of the file failed; empty if it succeeded.
  std::optional<Fault> write_error() const;

 private:
  void write();
  bool begun() const;  // whether the file may be written
  std::filesystem::path temporary_file() const { return file_.string() + ".part"; }

  std::filesystem::path file_;
  std::string run_id_;
  std::chrono::duration<double> interval_;
  std::optional<Unasked> unasked_;
  std::vector<std::string> states_;                              // by job
  std::size_t bytes_ = 0;                                        // of all states
  std::vector<std::chrono::steady_clock::time_point> saved_at_;  // of the last save, by job
  std::chrono::steady_clock::time_point written_at_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point made_at_ = std::chrono::steady_clock::now();
  bool loaded_ = false, unwritten_ = false, written_ = false, given_up_ = false;
  std::optional<Fault> write_error_;  // of the last write
  WriteErrorCallback on_write_error_;
  mutable std::mutex mutex_;
};

}  // namespace mahlwerk::campaign
