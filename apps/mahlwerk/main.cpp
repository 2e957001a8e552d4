// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <initializer_list>
#include <list>
#include <span>
#include <system_error>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/isa.hpp"
#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/commands/command.hpp"
#include "mahlwerk/commands/help/about.hpp"
#include "mahlwerk/commands/places.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/commands/reporting/result_files.hpp"

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

/// Splits "mill.speed=500 rpm" into key and value. Throws InputError without "=".
cases::Override override_of(const std::string& text) {
  const auto at = text.find('=');
  if (at == 0 || at == std::string::npos)
    throw InputError(Fault{"--set " + text, "this is not of the form key=value",
                           "write, for instance, --set mill.frequency=\"12 Hz\"", "bad-override"});
  return {text.substr(0, at), text.substr(at + 1)};
}

/// CLI11 validator: an error message if `text` is not a number of seconds; empty if it is.
std::string no_seconds(const std::string& text) {
  double seconds = 0;
  if (CLI::detail::lexical_cast(text, seconds) && seconds > 0 && seconds < 1e9) return {};
  return "'" + text + "' is not a number of seconds above 0; write, for instance, --checkpoint 60";
}

/// CLI11 validator: an error message if `text` is no whole number from 0 on that 64 bits hold.
std::string no_whole_number(const std::string& text) {
  std::uint64_t n = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, n);
  if (error == std::errc() && stop == end) return {};
  return "'" + text + "' is not a whole number from 0 on; write, for instance, --seed 7";
}

std::string exit_code_line() {
  std::string line;
  for (const Explained& code : exit_codes())
    line += fmt::format("{}{} {}", line.empty() ? "Exit codes: " : ", ", code.word, code.meaning);
  return line + ".";
}

/// Parser of the command line, built from the commands' descriptions of their options.
class CommandLine {
 public:
  explicit CommandLine(const std::vector<Command>& all) {
    app_.name("mahlwerk");
    app_.set_version_flag(
        "--version", [] { return fmt::format("mahlwerk {} ({})", version(), name_of(isa())); });
    app_.require_subcommand(1);
    app_.description(fmt::format("{}\nStart with:  mahlwerk run {}", purpose(), first_example()));
    app_.footer(exit_code_line());
    for (const Command& command : all) add(app_, command);
  }

  /// Sets the arguments of the chosen command and returns it; nullptr if the program must exit with
  /// `ended`.
  const Command* parse(int argc, char** argv) try {
    app_.parse(argc, argv);
    for (const auto& [texts, target] : set_)
      for (const std::string& one : texts) target->push_back(override_of(one));
    return chosen_;
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() != 0 && json_messages())
      ended = report_end(bad_input,
                         {Fault{"mahlwerk", e.what(), "see mahlwerk --help", "bad-command-line"}});
    else
      ended = app_.exit(e) == 0 ? success : bad_input;
    return nullptr;
  }

  int ended = success;

 private:
  void add(CLI::App& above, const Command& command) {
    CLI::App* sub = above.add_subcommand(command.name, command.about);
    for (const Option& option : command.options) add(*sub, option);
    for (const Command& part : command.subcommands) add(*sub, part);
    sub->callback([this, &command] {  // CLI11 calls it after the callbacks of the subcommands
      const auto chosen = [this](const Command& part) { return &part == chosen_; };
      if (std::ranges::none_of(command.subcommands, chosen)) chosen_ = &command;
    });
  }

  void add(CLI::App& sub, const Option& option) {
    CLI::Option* made =
        std::visit([&](auto* target) { return add(sub, option, target); }, option.target);
    made->required(option.required);
    if (!option.type.empty()) made->type_name(option.type);
    if (option.range[1] > 0) made->check(CLI::Range(option.range[0], option.range[1]));
    if (!option.values.empty()) made->check(CLI::IsMember(option.values));
    if (!option.excludes.empty()) made->excludes(named(sub, option.excludes));
    if (!option.needs.empty()) made->needs(named(sub, option.needs));
  }

  /// App::get_option() ends the process where memory is short: it allocates, and is noexcept.
  static CLI::Option* named(CLI::App& sub, const std::string& name) {
    for (CLI::Option* option : sub.get_options())
      if (option->check_name(name)) return option;
    throw CLI::OptionNotFound(name);
  }

  CLI::Option* add(CLI::App& sub, const Option& option, bool* flag) {
    return sub.add_flag(option.name, *flag, option.about);
  }
  CLI::Option* add(CLI::App& sub, const Option& option, std::vector<cases::Override>* list) {
    set_.push_back({{}, list});
    return sub.add_option(option.name, set_.back().first, option.about)->allow_extra_args(false);
  }
  CLI::Option* add(CLI::App& sub, const Option& option, std::vector<std::string>* list) {
    const bool positional = !option.name.starts_with("-");
    return sub.add_option(option.name, *list, option.about)->allow_extra_args(positional);
  }
  CLI::Option* add(CLI::App& sub, const Option& option, std::optional<double>* seconds) {
    return sub.add_option(option.name, *seconds, option.about)->check(no_seconds);
  }
  CLI::Option* add(CLI::App& sub, const Option& option, std::optional<std::uint64_t>* whole) {
    return sub.add_option(option.name, *whole, option.about)->check(no_whole_number);
  }
  template <class Value>
  CLI::Option* add(CLI::App& sub, const Option& option, Value* value) {
    return sub.add_option(option.name, *value, option.about);
  }

  CLI::App app_;
  /// Texts of --set, and where they go.
  std::list<std::pair<std::vector<std::string>, std::vector<cases::Override>*>> set_;
  const Command* chosen_ = nullptr;
};

/// Command names of other programs, and our command for each.
constexpr std::array<std::array<std::string_view, 2>, 11> synonyms{{{"simulate", "run"},
                                                                    {"start", "run"},
                                                                    {"solve", "run"},
                                                                    {"validate", "check"},
                                                                    {"info", "describe"},
                                                                    {"show", "describe"},
                                                                    {"calibrate", "fit"},
                                                                    {"campaign", "sweep"},
                                                                    {"init", "new"},
                                                                    {"create", "new"},
                                                                    {"template", "new"}}};

/// Throws InputError if the first word is not a command. The remedy suggests the nearest command.
void check_command(std::string_view word, const std::vector<Command>& all) {
  std::vector<std::string> known;
  for (const Command& command : all) known.push_back(command.name);
  if (word.starts_with("-") || std::ranges::find(known, word) != known.end()) return;
  std::string meant = nearest_word(word, known);
  for (const auto& [other, ours] : synonyms)
    if (word == other) meant = ours;
  throw InputError(Fault{"mahlwerk", fmt::format("unknown command '{}'", word),
                         (meant.empty() ? "" : fmt::format("did you mean 'mahlwerk {}'? ", meant)) +
                             "mahlwerk --help lists all commands",
                         "bad-command-line"});
}

int perform(int argc, char** argv) {
  const std::vector<Command> all = all_commands();
  if (argc > 1) check_command(argv[1], all);
  CommandLine line(all);
  const Command* command = line.parse(argc, argv);
  return command == nullptr ? line.ended : command->perform();
}

/// Runs the command, reports every exception, and returns the exit code.
int perform_and_report(int argc, char** argv) try {
  return perform(argc, argv);
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
  const std::span words(argv, static_cast<std::size_t>(argc));
  if (std::ranges::any_of(words, [](std::string_view word) { return word == "--json"; }))
    mahlwerk::commands::set_json_messages();
  guard_output();
  mahlwerk::commands::catch_early_signals();
  return finish_output(perform_and_report(argc, argv));
}
