// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace mahlwerk::results {

/// Holds a file for this process, until it ends however it ends.
class FileLock {
 public:
  enum class Mode { exclusive, shared };
  enum class State {
    held,
    held_elsewhere,
    unsupported
  };  ///< the last: this file system knows none
  enum class AtRelease { keep_file, remove_file };

  /// Makes the file if need be. Throws std::system_error where it cannot be opened.
  explicit FileLock(const std::filesystem::path& file, Mode mode = Mode::exclusive,
                    AtRelease at_release = AtRelease::keep_file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  State state() const { return state_; }
  int error() const { return error_; }                  ///< why there are no locks
  static bool held(const std::filesystem::path& file);  ///< by any process

 private:
  std::filesystem::path file_;
  int descriptor_ = -1, error_ = 0;
  State state_ = State::held;
  AtRelease at_release_;
};

}  // namespace mahlwerk::results
