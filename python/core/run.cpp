// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// run: one case, into memory and, on request, into a result folder.
#include "mahlwerk/campaign/run/run.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "job.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/campaign/run/assumed_values.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/campaign/run/streams.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/commands/places.hpp"
#include "mahlwerk/commands/reporting/result_files.hpp"
#include "mahlwerk/report/report.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "outcome.hpp"
#include "records.hpp"

namespace mahlwerk::python {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;

struct RunRequest {
  std::optional<fs::path> out;
  bool force = false;
  int threads = 0;
  bool keep_records = false;
  py::list observers;
  campaign::ReadWithValue read;
};

/// What a case is read from: its text, the place of its file, and the changes to it.
using CaseText = std::tuple<std::string, fs::path, Changes>;

cases::Case read_with_value(const CaseText& source, const std::string& key,
                            const std::string& value) {
  const auto& [text, file, changes] = source;
  std::vector<cases::Override> overrides = overrides_of(changes);
  overrides.push_back({key, value});
  return cases::read_text(text, file, commands::catalogue(), overrides);
}

/// Faults that make a run impossible, before any is computed.
void check(const cases::Case& mill_case, const RunRequest& request) {
  std::vector<Fault> wrong = campaign::run_faults(mill_case);
  if (!mill_case.sweep.empty())
    wrong.push_back({mill_case.file, "the case has a [sweep]: it is a campaign, not one run",
                     "call sweep() instead of run()", "one-case"});
  if (mill_case.observe.frames && !request.out)
    wrong.push_back({cases::location_of(mill_case, "observe.frames"),
                     "frames are files, and no folder is given for them",
                     "give a folder: run(out=\"results/name\"), or omit [observe] frames",
                     "no-folder"});
  if (!wrong.empty()) throw InputError(std::move(wrong));
}

std::string line_of(const campaign::Progress& p) {
  char text[160];
  std::snprintf(text, sizeof text, "%.4g of %.4g s simulated, %.3g collisions", p.simulated,
                p.total, p.collisions);
  return text;
}

/// Computes the case; the records go to the files of `streams`, to memory and to Python's
/// observers.
results::Outcome compute(const cases::Case& mill_case, const RunRequest& request,
                         const campaign::Streams* streams, std::atomic<bool>& stop, Job& job,
                         std::vector<RecordBuffer>& kept) {
  campaign::RunOptions options;
  options.threads = request.threads;
  options.stop = &stop;
  options.progress = [&](const campaign::Progress& p) {
    job.progress(p.total > 0 ? p.simulated / p.total : 0, line_of(p));
  };
  if (request.keep_records) kept.resize(static_cast<std::size_t>(mill_case.run.replicates));
  if (streams != nullptr) streams->attach(options);
  const auto to_files = options.records;
  options.records = [&, to_files](std::size_t point, int replicate) {
    ObserverList all;
    if (to_files) all.add(to_files(point, replicate));
    if (request.keep_records)
      all.add(std::make_unique<RecordList>(kept[static_cast<std::size_t>(replicate)].records));
    for (const py::handle one : request.observers)
      all.add(std::make_unique<PythonObserver>(one, replicate + 1, job));
    return std::move(all).combined();
  };
  results::Outcome outcome = campaign::run(mill_case, options);
  outcome.summary.sensitivity = campaign::sensitivity_to_assumed(outcome, request.read, options);
  return outcome;
}

/// Returns the result, whether Ctrl-C ended the run early, and why its files were not written.
py::tuple run(const cases::Case& mill_case, const CaseText& source,
              const std::optional<fs::path>& out, bool force, int threads, bool keep_records,
              const py::list& observers, const py::object& show) {
  const auto read = [&](const std::string& key, const std::string& value) {
    return read_with_value(source, key, value);
  };
  const RunRequest request{out, force, threads, keep_records, observers, read};
  check(mill_case, request);
  std::unique_ptr<results::Folder> folder;
  campaign::Streams streams(commands::version());
  if (out) {
    folder = std::make_unique<results::Folder>(*out, force);
    streams.add(mill_case, *folder, "");
  }
  std::atomic<bool> stop{false};
  Job job(stop);
  auto result = std::make_unique<RunResult>();
  std::vector<Fault> unwritten;
  const bool interrupted = job.run(
      [&] {
        result->outcome =
            compute(mill_case, request, folder ? &streams : nullptr, stop, job, result->records);
        if (!folder || job.failed()) return;  // nothing is written after an exception of Python
        unwritten = commands::write_result([&] {
          streams.close();
          report::write(*folder, result->outcome, commands::version());
          folder->commit();
        });
      },
      show);
  return py::make_tuple(py::cast(std::move(result)), interrupted, unwritten);
}

}  // namespace

void bind_run(py::module_& m) {
  m.def("run", &run, py::arg("case"), py::arg("source"), py::arg("out"), py::arg("force"),
        py::arg("threads"), py::arg("keep_records"), py::arg("observers"), py::arg("show"));
}

}  // namespace mahlwerk::python
