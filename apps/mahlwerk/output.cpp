// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "output.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>

#include "commands.hpp"
#include "listener.hpp"
#include "mahlwerk/base/printable.hpp"
#include "messages.hpp"
#include "progress.hpp"
#include "terminal.hpp"

namespace mahlwerk::app {
namespace {

extern "C" void ignore_signal(int) {}

int first_error = 0;  // errno of the first failed write to stdout; 0: none, or not known

}  // namespace

void to_stdout(std::string_view text) {
  if (listener() != nullptr) return;
  fmt::print("{}", printable(text));
}

void json_to_stdout(const results::Json& json) {
  if (listener() != nullptr) return listener()->result(json.text());
  fmt::print("{}\n", json.text(2));
}

void guard_output() {
  std::signal(SIGPIPE, ignore_signal);  // not SIG_IGN, which child processes would inherit
  open_closed_streams();
}

bool output_failed(int error) {
  const bool failed = std::ferror(stdout) != 0;
  if (failed && first_error == 0) first_error = error;
  return failed;
}

int finish_output(int code) {
  errno = 0;
  const bool flushed = std::fflush(stdout) == 0;
  if (!output_failed(errno) && flushed) return code;
  const int error = first_error != 0 ? first_error : EIO;
  const std::string why = std::string("standard output cannot be written: ") + std::strerror(error);
  if (stop_wanted() && code == success) code = interrupted;
  const Fault fault{
      "", why,
      "free disk space, or keep the reader of the pipe open; results in folders are complete",
      "output-lost"};
  return report_end(code == success ? static_cast<int>(output_lost) : code, {fault});
}

}  // namespace mahlwerk::app
