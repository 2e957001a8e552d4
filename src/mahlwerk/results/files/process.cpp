// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/process.hpp"

#include <signal.h>
#include <unistd.h>

#include <cerrno>

namespace mahlwerk::results {

int own_process_id() {
  return ::getpid();
}

bool process_exists(int id) {
  return ::kill(id, 0) == 0 || errno == EPERM;
}

}  // namespace mahlwerk::results
