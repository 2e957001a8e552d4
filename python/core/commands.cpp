// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// command: a command of the command line (sweep, fit, optimise, ...) in this process, with its
// result as JSON.
#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "job.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/commands/command.hpp"
#include "mahlwerk/commands/reporting/listener.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "outcome.hpp"

namespace mahlwerk::python {
namespace {

namespace py = pybind11;

/// Collects what a command reports.
class Report final : public commands::Listener {
 public:
  Report() : job(stop) {}
  void progress(std::string_view line) override { job.progress(NAN, std::string(line)); }
  void warning(const Fault& warning) override {
    const std::lock_guard lock(mutex_);
    warnings.push_back(warning);
  }
  void result(std::string json_text) override { json = std::move(json_text); }
  void ended(int, const std::vector<Fault>& list) override { faults = list; }

  Job job;
  std::string json;
  std::vector<Fault> warnings, faults;

 private:
  std::mutex mutex_;
};

/// "; did you mean NAME?", or nothing.
std::string suggestion(const std::string& wrong, const std::vector<std::string>& known) {
  const std::string near = nearest_word(wrong, known);
  return near.empty() ? "" : fmt::format("; did you mean {}?", near);
}

const commands::Command& command_named(const std::vector<commands::Command>& all,
                                       const std::vector<std::string>& words) {
  const commands::Command* found = nullptr;
  const std::vector<commands::Command>* level = &all;
  for (const std::string& word : words) {
    const auto at =
        std::ranges::find_if(*level, [&](const commands::Command& c) { return c.name == word; });
    if (at == level->end()) {
      std::vector<std::string> known;
      for (const commands::Command& one : *level) known.push_back(one.name);
      throw py::key_error("there is no command " + word + suggestion(word, known));
    }
    found = &*at;
    level = &found->subcommands;
  }
  if (found == nullptr) throw py::key_error("no command is given");
  return *found;
}

template <class T>
std::string_view type_words() {
  if constexpr (std::is_same_v<T, std::string> || std::is_same_v<T, std::optional<std::string>>)
    return "a text, a quantity with its unit";
  else if constexpr (std::is_same_v<T, std::vector<std::string>>)
    return "a list of texts";
  else if constexpr (std::is_same_v<T, int> || std::is_same_v<T, std::optional<std::uint64_t>>)
    return "a whole number";
  else if constexpr (std::is_same_v<T, bool>)
    return "True or False";
  else if constexpr (std::is_same_v<T, py::dict>)
    return "a dict of texts";
  else if constexpr (std::is_same_v<T, std::optional<double>>)
    return "a number";
  else
    return "a path";
}

template <class T>
T cast(const py::handle& value, const char* name) try {
  return value.cast<T>();
} catch (const py::cast_error&) {
  throw py::type_error(
      fmt::format("{} is {}, not {}", name, type_words<T>(), py::repr(value).cast<std::string>()));
}
void take(const py::handle& value, const char* name, std::vector<cases::Override>& list) {
  Changes changes;
  for (const auto& [key, text] : cast<py::dict>(value, name))
    changes.emplace_back(cast<std::string>(key, name),
                         cast<std::optional<std::string>>(text, name));
  list = overrides_of(changes);
}
template <class T>
void take(const py::handle& value, const char* name, std::optional<T>& target) {
  target = cast<T>(value, name);
}
template <class T>
void take(const py::handle& value, const char* name, T& target) {
  target = cast<T>(value, name);
}

/// The names of an option in Python: "jar_kind" of --jar-kind, "jobs" and "threads" of
/// --jobs,--threads, "case" of CASE.
std::vector<std::string> names_of(const commands::Option& option) {
  std::vector<std::string> names{""};
  for (const char c : option.name)
    if (c == ',')
      names.emplace_back();
    else if (c != '-')
      names.back() += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    else if (!names.back().empty())
      names.back() += '_';
  return names;
}

/// Refuses values that the command line refuses. 0 and "" are those of options that are not given.
void check_limits(const commands::Option& option, const std::string& name) {
  if (const auto* count = std::get_if<int*>(&option.target); count != nullptr && **count != 0) {
    const auto [least, most] = option.range;
    if (most > 0 && (**count < least || **count > most))
      throw py::value_error(fmt::format("{} is from {} to {}, or 0 for the default, not {}", name,
                                        least, most, **count));
  }
  if (const auto* seconds = std::get_if<std::optional<double>*>(&option.target))
    if (const double time = (*seconds)->value_or(1); !(time > 0 && time < 1e9))
      throw py::value_error(fmt::format("{} is a number of seconds above 0, not {}", name, time));
  if (const auto* word = std::get_if<std::string*>(&option.target))
    if (!(*word)->empty() && !option.values.empty() &&
        std::ranges::count(option.values, **word) == 0)
      throw py::value_error(
          fmt::format("{} is one of {}, not '{}'", name, fmt::join(option.values, ", "), **word));
}

/// Sets the options of a command by their names, and that its result is JSON.
void set_options(const commands::Command& command, const py::dict& values) {
  for (const auto& item : values) {
    const auto name = item.first.cast<std::string>();
    const py::handle value = item.second;
    const auto option = std::ranges::find_if(command.options, [&](const commands::Option& one) {
      return std::ranges::count(names_of(one), name) > 0;
    });
    if (option == command.options.end()) {
      std::vector<std::string> known;
      for (const commands::Option& one : command.options)
        for (const std::string& other : names_of(one)) known.push_back(other);
      throw py::type_error("mahlwerk " + command.name + " has no option " + name +
                           suggestion(name, known));
    }
    if (value.is_none()) continue;
    std::visit([&](auto* target) { take(value, name.c_str(), *target); }, option->target);
    check_limits(*option, name);
  }
  for (const commands::Option& option : command.options)
    if (option.name == "--json") *std::get<bool*>(option.target) = true;
}

/// Runs the command. Returns its exit code, its result as JSON, and its faults and warnings.
py::tuple command(const std::vector<std::string>& words, const py::dict& options,
                  const py::object& show) {
  const std::vector<commands::Command> all = commands::all_commands();
  const commands::Command& chosen = command_named(all, words);
  set_options(chosen, options);
  Report report;
  int code = commands::success;
  const bool interrupted = report.job.run(
      [&] {
        const commands::Listening listening(report);
        code = chosen.perform();
      },
      show);
  // A command that was too short to notice Ctrl-C ends as if it had.
  if (interrupted && code == commands::success) code = commands::interrupted;
  return py::make_tuple(code, report.json, report.faults, report.warnings);
}

}  // namespace

void bind_commands(py::module_& m) {
  m.def("command", &command, py::arg("words"), py::arg("options"), py::arg("show"));
}

}  // namespace mahlwerk::python
