// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace mahlwerk::results {
namespace {

/// Whether the open file still has this name: the previous holder may have removed it.
bool is_there(int descriptor, const std::filesystem::path& file) {
  struct stat opened {
  }, named{};
  return ::fstat(descriptor, &opened) == 0 && ::stat(file.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

FileLock::FileLock(const std::filesystem::path& file, Mode mode, AtRelease at_release)
    : file_(file), at_release_(at_release) {
  for (;;) {
    descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0)
      throw std::system_error(errno, std::generic_category(), file.generic_string());
    if (::flock(descriptor_, (mode == Mode::exclusive ? LOCK_EX : LOCK_SH) | LOCK_NB) != 0) {
      error_ = errno;
      state_ = error_ == EWOULDBLOCK ? State::held_elsewhere : State::unsupported;
      return;
    }
    if (is_there(descriptor_, file)) return;
    ::close(descriptor_);
  }
}

FileLock::~FileLock() {
  std::error_code none;  // the file is removed before the lock is released
  if (state_ == State::held && at_release_ == AtRelease::remove_file)
    std::filesystem::remove(file_, none);
  ::close(descriptor_);
}

bool FileLock::held(const std::filesystem::path& file) {
  int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC);  // NFS locks need write access
  if (descriptor < 0) descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool held = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return held;
}

}  // namespace mahlwerk::results
