// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// command: a command of the command line (sweep, fit, optimise, ...) in this process, with its
// result as JSON.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <string>
#include <vector>

#include "command.hpp"
#include "job.hpp"
#include "listener.hpp"
#include "mahlwerk/base/error.hpp"
#include "outcome.hpp"

namespace mahlwerk::python {
namespace {

namespace py = pybind11;

/// Collects what a command reports.
class Report final : public app::Listener {
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

const app::Command& command_named(const std::vector<app::Command>& all,
                                  const std::vector<std::string>& words) {
  const app::Command* found = nullptr;
  const std::vector<app::Command>* level = &all;
  for (const std::string& word : words) {
    const auto at =
        std::ranges::find_if(*level, [&](const app::Command& c) { return c.name == word; });
    if (at == level->end()) throw py::key_error("there is no command " + word);
    found = &*at;
    level = &found->subcommands;
  }
  if (found == nullptr) throw py::key_error("no command is given");
  return *found;
}

template <class T>
T cast(const py::handle& value, const char* name) try {
  return value.cast<T>();
} catch (const py::cast_error&) {
  throw py::type_error(std::string(name) +
                       " is of the wrong type: " + py::repr(value).cast<std::string>());
}
template <class T>
void take(const py::dict& options, const char* name, T& value) {
  if (options.contains(name) && !options[name].is_none()) value = cast<T>(options[name], name);
}
template <class T>
void take(const py::dict& options, const char* name, std::optional<T>& value) {
  if (options.contains(name) && !options[name].is_none()) value = cast<T>(options[name], name);
}

app::Request request_of(const py::dict& options) {
  app::Request request;
  request.json = true;
  std::vector<std::pair<std::string, std::string>> changes;
  take(options, "target", request.target);
  take(options, "data", request.data);
  take(options, "changes", changes);
  for (const auto& [key, value] : changes) request.set.push_back({key, value});
  take(options, "out", request.out);
  take(options, "threads", request.threads);
  take(options, "results", request.results);
  take(options, "checkpoint", request.checkpoint);
  take(options, "force", request.force);
  take(options, "quick", request.quick_only);
  take(options, "quantities", request.quantities);
  take(options, "mill", request.mill);
  take(options, "kind", request.kind);
  take(options, "jar", request.jar);
  take(options, "jar_kind", request.jar_kind);
  take(options, "balls", request.balls);
  return request;
}

/// Runs the command. Returns its exit code, its result as JSON, and its faults and warnings.
py::tuple command(const std::vector<std::string>& words, const py::dict& options,
                  const py::object& show) {
  const std::vector<app::Command> all = app::commands();
  const app::Command& chosen = command_named(all, words);
  const app::Request request = request_of(options);
  Report report;
  int code = app::success;
  const bool interrupted = report.job.run(
      [&] {
        const app::Listening listening(report);
        code = chosen.perform(request);
      },
      show);
  // A command that was too short to notice Ctrl-C ends as if it had.
  if (interrupted && code == app::success) code = app::interrupted;
  return py::make_tuple(code, report.json, report.faults, report.warnings);
}

}  // namespace

void bind_commands(py::module_& m) {
  m.def("command", &command, py::arg("words"), py::arg("options"), py::arg("show"));
}

}  // namespace mahlwerk::python
