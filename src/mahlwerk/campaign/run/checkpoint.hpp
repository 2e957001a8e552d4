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
#include "mahlwerk/campaign/run/state_file.hpp"

namespace mahlwerk::campaign {

/// The states of all replicates of a run in one file, for a run that can be interrupted and
/// resumed: when they are saved and written. Thread-safe.
class Checkpoint {
 public:
  /// [bytes] States that only the memory has are written beyond this, due or not.
  static constexpr std::size_t most_in_memory = std::size_t{32} << 20U;

  /// Called when the file cannot be written, once until a write succeeds. The run continues.
  using WriteErrorCallback = std::function<void(const Fault&)>;

  /// When states are kept that nobody asked for.
  struct Unasked {
    double after = 60;  ///< [s] no file is written before, unless states fill the memory
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
  /// Keeps the state of a replicate, in memory until it is written.
  void save(std::size_t job, ReplicateRun& replica);
  void
  write_if_due();  ///< writes states that are not yet in the file, if the last write is long ago
  /// Writes states of replicates that ended, unless writes would take a good part of the time.
  void write_soon();
  void flush();   ///< writes states that are not yet in the file
  void remove();  ///< removes the file once the run has ended
  const std::filesystem::path& file() const { return states_.file(); }
  bool written() const;  ///< whether the file holds states of this run

  /// Why the last write of the file failed; empty if it succeeded.
  std::optional<Fault> write_error() const;

 private:
  using Clock = std::chrono::steady_clock;
  void write();
  bool begun() const;  // whether the file may be written
  bool crowded() const;

  StateFile states_;
  std::chrono::duration<double> interval_, write_took_{};
  std::optional<Unasked> unasked_;
  std::vector<Clock::time_point> saved_at_;  // of the last save, by job
  Clock::time_point written_at_ = Clock::now(), made_at_ = Clock::now();
  bool loaded_ = false, unwritten_ = false, written_ = false, given_up_ = false;
  std::optional<Fault> write_error_;  // of the last write
  WriteErrorCallback on_write_error_;
  mutable std::mutex mutex_;
};

}  // namespace mahlwerk::campaign
