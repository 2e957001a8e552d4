// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::commands {

/// Receives what a command reports, in place of the terminal, for programs that call commands (the
/// Python module). The command must be asked for JSON. Calls come from the thread of the command,
/// except progress() and warning(), which any of its threads may call.
class Listener {
 public:
  virtual ~Listener() = default;
  virtual void progress(std::string_view line) = 0;
  virtual void warning(const Fault& warning) = 0;
  virtual void result(std::string json) = 0;
  /// The command ends with another exit code than success.
  virtual void ended(int code, const std::vector<Fault>& faults) = 0;

  std::atomic<bool> stop{false};  ///< set it to interrupt the command
};

/// The listener of this thread's command; null: the command reports to the terminal.
Listener* listener();

/// Makes a listener that of this thread, as long as this object exists.
class Listening {
 public:
  explicit Listening(Listener& chosen);
  ~Listening();
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;

 private:
  Listener* before_;
};

}  // namespace mahlwerk::commands
