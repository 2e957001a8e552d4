// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

// Processes of this machine by their ids, and space on its disks (POSIX).
namespace mahlwerk::results {

int own_process_id();

/// Whether there is a process with this id, of whatever user.
bool process_exists(int id);

/// Holds back SIGINT, SIGTERM and SIGHUP from this thread, so that none ends a short piece of work.
class HeldSignals {
 public:
  HeldSignals();
  ~HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

 private:
  struct Before;
  std::unique_ptr<Before> before_;
};

/// Makes a file of this size [bytes], for which the disk keeps space. Returns 0, or the errno if
/// the disk has no such space; 0 without a file where space cannot be kept.
int reserve_space(const std::filesystem::path& file, std::size_t size);

}  // namespace mahlwerk::results
