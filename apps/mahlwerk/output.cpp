// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>

#include "commands.hpp"
#include "mahlwerk/base/printable.hpp"
#include "messages.hpp"
#include "progress.hpp"

namespace mahlwerk::app {
namespace {

extern "C" void ignore_signal(int) {}

int first_error = 0;  // of stdout, where it was told

}  // namespace

void to_stdout(std::string_view text) {
  fmt::print("{}", printable(text));
}

void json_to_stdout(const results::Json& json) {
  fmt::print("{}\n", json.text(2));
}

void guard_output() {
  std::signal(SIGPIPE, ignore_signal);  // not ignored: that would be handed down to other programs
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    // Of the wrong kind, so that what is written is an error.
    if (::fcntl(stream, F_GETFD) == -1)
      static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
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
  const Fault fault{"", why, "make room, or keep its reader open; results in folders are complete",
                    "output-lost"};
  return report_end(code == success ? static_cast<int>(output_lost) : code, {fault});
}

}  // namespace mahlwerk::app
