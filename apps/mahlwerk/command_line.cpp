// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <list>
#include <system_error>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/isa.hpp"
#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/commands/help/find_command.hpp"
#include "mahlwerk/commands/help/help.hpp"
#include "mahlwerk/commands/places.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"

namespace mahlwerk::app {
namespace {

using namespace commands;

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

/// CLI11 validator of a word: an error message with the nearest of `values`; empty if it is one.
auto one_of(const std::vector<std::string>& values) {
  return [values](const std::string& text) -> std::string {
    if (std::ranges::find(values, text) != values.end()) return {};
    const std::string near = nearest_word(text, values);
    return fmt::format("'{}' is not one of {}{}", text, fmt::join(values, ", "),
                       near.empty() ? "" : fmt::format("; did you mean '{}'?", near));
  };
}

/// Parser of the command line, built from the commands' descriptions of their options.
class CommandLine {
 public:
  explicit CommandLine(const std::vector<Command>& all) : all_(all) {
    app_.name("mahlwerk");
    app_.set_version_flag(
        "-V,--version", [] { return fmt::format("mahlwerk {} ({})", version(), name_of(isa())); });
    app_.require_subcommand(1);
    for (const Command& command : all) add(app_, command);
  }

  const Command* parse(std::vector<std::string> words) try {
    std::ranges::reverse(words);  // as CLI11 takes them
    app_.parse(std::move(words));
    for (const auto& [texts, target] : set_)
      for (const std::string& one : texts) target->push_back(override_of(one));
    return chosen_;
  } catch (const CLI::CallForHelp&) {
    print_help(all_, named_commands());
    return nullptr;
  } catch (const CLI::CallForVersion& version) {
    to_stdout(std::string(version.what()) + '\n');
    return nullptr;
  } catch (const CLI::ParseError& error) {
    throw InputError(fault_of(error));
  }

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
    if (!option.values.empty()) made->check(one_of(option.values));
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

  /// The command and subcommand that were found before an error.
  std::vector<std::string> named_commands() const {
    std::vector<std::string> path;
    for (auto found = app_.get_subcommands(); !found.empty();
         found = found.front()->get_subcommands())
      path.push_back(found.front()->get_name());
    return path;
  }

  /// A word that is not known explains more than what is missing because of it.
  Fault fault_of(const CLI::ParseError& error) const {
    const std::vector<std::string> path = named_commands();
    const std::string command =
        fmt::format("mahlwerk{}{}", path.empty() ? "" : " ", fmt::join(path, " "));
    Fault fault{command, error.what(), command + " --help lists its options", "bad-command-line"};
    if (path.empty()) return fault;
    for (const std::string& word : app_.remaining(true)) {
      const bool option = word.starts_with("-");
      fault.what = fmt::format("unknown {} '{}'", option ? "option" : "argument", word);
      if (!option) continue;
      const std::string near = nearest_option(find_command(all_, path), word);
      if (near == word.substr(0, word.find('=')))
        return {command, fmt::format("the option {} stands before the command", near),
                fmt::format("write it behind: {} ... {}", command, near), "bad-command-line"};
      if (!near.empty()) fault.remedy = fmt::format("did you mean '{}'? {}", near, fault.remedy);
      break;
    }
    return fault;
  }

  const std::vector<Command>& all_;
  CLI::App app_;
  /// Texts of --set, and where they go.
  std::list<std::pair<std::vector<std::string>, std::vector<cases::Override>*>> set_;
  const Command* chosen_ = nullptr;
};

}  // namespace

const Command* parse_command_line(const std::vector<Command>& all, std::vector<std::string> words) {
  return CommandLine(all).parse(std::move(words));
}

}  // namespace mahlwerk::app
