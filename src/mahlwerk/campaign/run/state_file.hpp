// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::campaign {

/// The states of replicates, and the file that keeps them: a state is in memory until the file has
/// it. No other process may use the file.
class StateFile {
 public:
  /// `what` identifies the run of `jobs` replicates.
  StateFile(std::filesystem::path file, std::string what, std::size_t jobs);

  /// Finds the states in the file. Throws InputError if there is none, it is damaged, or it belongs
  /// to another run.
  void load();
  bool has(std::size_t job) const { return states_[job].size > 0; }
  /// The state of a replicate that has one. Throws InputError if the file no longer gives it.
  std::string state(std::size_t job) const;
  void set(std::size_t job, std::string bytes);
  /// The refusal of a file whose states no run can have.
  static InputError damaged(const std::filesystem::path& file);
  void clear();  ///< lets go all states; the file stays as it is

  /// Writes all states under a temporary name, then renames it, and lets go those in memory. Throws
  /// InputError or filesystem_error on failure: then all is as before.
  void write();

  const std::filesystem::path& file() const { return file_; }
  std::filesystem::path temporary_file() const { return file_.string() + ".part"; }
  std::size_t bytes() const { return in_memory_ + in_file_; }  ///< of all states
  std::size_t in_memory() const { return in_memory_; }         ///< [bytes] not yet in the file
  std::size_t in_file() const { return in_file_; }             ///< [bytes] only there

 private:
  /// A state in memory or, with no bytes there, at a place in the file. Of size 0: none.
  struct State {
    std::string bytes;
    std::uint64_t place = 0, size = 0;
    bool only_in_file() const { return bytes.empty() && size > 0; }
  };
  using Put = std::function<void(std::string_view)>;
  void count();
  void forget_lost();
  static bool give(const State& state, std::istream& from, const Put& put);

  std::filesystem::path file_;
  std::string run_id_;
  std::vector<State> states_;  // by job
  std::size_t in_memory_ = 0, in_file_ = 0;
};

}  // namespace mahlwerk::campaign
