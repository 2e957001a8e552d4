// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "output_guard.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <initializer_list>
#include <string>

#include "mahlwerk/commands/reporting/exit_codes.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"

namespace mahlwerk::app {
namespace {

extern "C" void ignore_signal(int) {}

int first_error = 0;  // errno of the first failed write to stdout; 0: none, or not known

/// Opens closed standard streams in the wrong direction, so that no file gets their descriptors and
/// each read or write of them fails.
void open_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) == -1)
      static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

}  // namespace

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
  using namespace commands;
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
