// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "command_line.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/commands/command.hpp"
#include "mahlwerk/commands/help/find_command.hpp"
#include "mahlwerk/commands/help/help.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/commands/reporting/result_files.hpp"
#include "mahlwerk/commands/reporting/terminal.hpp"

namespace mahlwerk::app {
namespace {

using namespace commands;

extern "C" void ignore_signal(int) {}

int first_error = 0;  // errno of the first failed write to stdout; 0: none, or not known

/// Opens closed standard streams in the wrong direction, so that no file gets their descriptors and
/// each read or write of them fails.
void open_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) == -1)
      static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

/// Call before anything is printed or opened. A closed pipe (SIGPIPE) or a file at the limit of
/// `ulimit -f` (SIGXFSZ) then does not end a run, and no file gets the descriptor of a closed
/// standard stream.
void guard_output() {
  for (const int signal : {SIGPIPE, SIGXFSZ})
    std::signal(signal, ignore_signal);  // not SIG_IGN, which child processes would inherit
  open_closed_streams();
}

/// Whether writing to stdout failed; `error` is the errno of the current error.
bool output_failed(int error) {
  const bool failed = std::ferror(stdout) != 0;
  if (failed && first_error == 0) first_error = error;
  return failed;
}

/// Call after all output. Returns `code`, or output_lost if writing failed and `code` is success.
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

/// Takes --color from the words and applies it: it may stand before and after the command.
void take_color(std::vector<std::string>& words) {
  constexpr std::string_view name = "--color", with_value = "--color=";
  for (auto word = words.begin(); word != words.end() && *word != "--";) {
    const bool apart = *word == name;
    if (!apart && !word->starts_with(with_value)) {
      ++word;
      continue;
    }
    const auto value = apart ? word + 1 : word;
    const std::string mode = value == words.end() ? ""
                             : apart              ? *value
                                                  : value->substr(with_value.size());
    if (mode != "auto" && mode != "always" && mode != "never")
      throw InputError(Fault{"--color", fmt::format("'{}' is not auto, always or never", mode),
                             "write, for instance, --color never", "bad-command-line"});
    set_color(mode == "auto"     ? ColorMode::automatic
              : mode == "always" ? ColorMode::always
                                 : ColorMode::never);
    word = words.erase(word, value + 1);
  }
}

int perform(std::vector<std::string> words) {
  take_color(words);
  const std::vector<Command> all = all_commands();
  if (words.empty()) {
    print_short_help(all);
    return success;
  }
  check_command_words(all, words);
  const Command* command = parse_command_line(all, std::move(words));
  return command == nullptr ? static_cast<int>(success) : command->perform();
}

/// Runs the command, reports every exception, and returns the exit code.
int perform_and_report(std::span<char*> words) try {
  return perform({words.begin(), words.end()});
} catch (const InputError& e) {
  return report_end(bad_input, e.faults());
} catch (const RunError& e) {
  return report_end(stopped_by_physics, e.what(), {Fault{"", e.what(), "", "stopped"}});
} catch (const std::bad_alloc&) {
  return report_end(bad_input, faults_of_system(std::current_exception()));
} catch (const std::system_error& e) {
  if (output_failed(e.code().value())) return success;  // finish_output reports it
  return report_end(bad_input, faults_of_system(std::current_exception()));
} catch (const std::exception& e) {
  if (output_failed(0)) return success;
  return report_end(
      internal_error,
      fmt::format("internal error: {}\nPlease report this error together with the case file.",
                  e.what()),
      {Fault{"", e.what(), "report this error together with the case file", "internal-error"}});
}

}  // namespace
}  // namespace mahlwerk::app

int main(int argc, char** argv) {
  using namespace mahlwerk::app;
  const std::span words(argv + std::min(argc, 1), argv + argc);
  if (std::ranges::any_of(words, [](std::string_view word) { return word == "--json"; }))
    mahlwerk::commands::set_json_messages();
  guard_output();
  mahlwerk::commands::catch_early_signals();
  return finish_output(perform_and_report(words));
}
