// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <initializer_list>

namespace mahlwerk::results {

int own_process_id() {
  return ::getpid();
}

bool process_exists(int id) {
  return ::kill(id, 0) == 0 || errno == EPERM;
}

struct HeldSignals::Before {
  sigset_t mask;
};

HeldSignals::HeldSignals() : before_(std::make_unique<Before>()) {
  sigset_t held;
  sigemptyset(&held);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&held, signal);
  pthread_sigmask(SIG_BLOCK, &held, &before_->mask);
}

HeldSignals::~HeldSignals() {
  pthread_sigmask(SIG_SETMASK, &before_->mask, nullptr);
}

int reserve_space(const std::filesystem::path& file, std::size_t size) {
  int failed = 0;
#ifdef __linux__
  const int made = ::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  if (made < 0) return errno;
  if (::fallocate(made, 0, 0, static_cast<off_t>(size)) != 0) failed = errno;
  ::close(made);
  if (failed != 0) ::unlink(file.c_str());
  // File systems without this call, and `ulimit -f`, say nothing about the space.
  if (failed == EOPNOTSUPP || failed == ENOSYS || failed == EFBIG || failed == EINVAL) failed = 0;
#else
  static_cast<void>(file);
  static_cast<void>(size);
#endif
  return failed;
}

}  // namespace mahlwerk::results
