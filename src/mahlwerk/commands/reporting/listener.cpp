// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/reporting/listener.hpp"

#include <utility>

namespace mahlwerk::commands {
namespace {

thread_local Listener* of_this_thread = nullptr;

}  // namespace

Listener* listener() {
  return of_this_thread;
}

Listening::Listening(Listener& chosen) : before_(std::exchange(of_this_thread, &chosen)) {}

Listening::~Listening() {
  of_this_thread = before_;
}

}  // namespace mahlwerk::commands
