// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace mahlwerk::results {

/// Advisory lock (flock) on a file for this process. The system releases it when the process ends.
class FileLock {
 public:
  enum class Mode { exclusive, shared };
  enum class State {
    held,
    held_elsewhere,
    unsupported
  };  ///< unsupported: the file system has no locks
  enum class AtRelease { keep_file, remove_file };

  /// Creates the file if needed. Throws std::system_error if it cannot be opened.
  explicit FileLock(const std::filesystem::path& file, Mode mode = Mode::exclusive,
                    AtRelease at_release = AtRelease::keep_file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  State state() const { return state_; }
  int error() const { return error_; }                  ///< errno of an unsupported lock
  static bool held(const std::filesystem::path& file);  ///< whether any process holds the lock

 private:
  std::filesystem::path file_;
  int descriptor_ = -1, error_ = 0;
  State state_ = State::held;
  AtRelease at_release_;
};

}  // namespace mahlwerk::results
