// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// RunResult: the numbers of a run as JSON, bytes and words.
#include "outcome.hpp"

#include <pybind11/stl.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/commands/places.hpp"
#include "mahlwerk/report/report.hpp"
#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/hdf5.hpp"
#include "mahlwerk/results/files/json.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "records.hpp"

namespace mahlwerk::python {
namespace {

namespace py = pybind11;

py::object values_of(const results::Table& table, std::size_t c) {
  const std::vector<std::string>& words = table.columns[c].words;
  if (!words.empty()) {
    py::list list;
    for (const std::vector<double>& row : table.rows)
      list.append(std::isfinite(row[c]) ? words.at(static_cast<std::size_t>(row[c]))
                                        : std::string());
    return list;
  }
  std::vector<double> values;
  for (const std::vector<double>& row : table.rows) values.push_back(row[c]);
  return py::bytes(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
}

/// Each table: its description, and its columns with name, unit, meaning and values: bytes of
/// doubles, or a list of words.
py::dict tables(const RunResult& result) {
  py::dict all;
  for (const results::NamedTable& one : results::tables(result.outcome)) {
    py::list columns;
    for (std::size_t c = 0; c < one.table.columns.size(); ++c)
      columns.append(py::make_tuple(
          results::column_name(one.table.columns[c].name, one.table.columns[c].unit),
          one.table.columns[c].unit, one.table.columns[c].about, values_of(one.table, c)));
    all[py::str(one.name)] = py::make_tuple(one.about, columns);
  }
  return all;
}

/// The records of a replicate, counted from 1.
RecordBuffer& records(RunResult& result, std::size_t replicate) {
  if (replicate < 1 || replicate > result.records.size())
    throw py::index_error("there are no records of replicate " + std::to_string(replicate));
  return result.records[replicate - 1];
}

std::string failure(const RunResult& result) {
  for (const results::Replicate& r : result.outcome.replicates)
    if (!r.stop_reason.empty()) return r.stop_reason;
  return "";
}

void save(const RunResult& result, const std::filesystem::path& target, bool force) {
  const py::gil_scoped_release free;
  results::Folder folder(target, force);
  if (!result.records.empty()) {
    results::CollisionFile file(folder.file("collisions.h5"),
                                cases::write(result.outcome.mill_case), commands::version());
    for (std::size_t i = 0; i < result.records.size(); ++i)
      file.append(static_cast<int>(i), result.records[i].records);
    file.close();
  }
  report::write(folder, result.outcome, commands::version());
  folder.commit();
}

RecordBuffer read_records(const std::filesystem::path& file, int replicate) {
  const py::gil_scoped_release free;
  return {results::read_collisions(file, replicate - 1)};
}

}  // namespace

void bind_outcome(py::module_& m) {
  py::class_<RunResult>(m, "RunResult", "The outcome of a run in memory.")
      .def("summary_json",
           [](const RunResult& r) { return results::summary_json(r.outcome, commands::version()); })
      .def("resolved_case", [](const RunResult& r) { return cases::write(r.outcome.mill_case); })
      .def("report_page",
           [](const RunResult& r) {
             return report::report_page(r.outcome, commands::version(), true);
           })
      .def("sentence", [](const RunResult& r) { return report::sentence(r.outcome); })
      .def("tables", &tables)
      .def("records", &records, py::arg("replicate"), py::return_value_policy::reference_internal)
      .def_property_readonly("replicates_with_records",
                             [](const RunResult& r) { return r.records.size(); })
      .def_property_readonly("complete",
                             [](const RunResult& r) { return results::complete(r.outcome); })
      .def_property_readonly("failure", &failure)
      .def_property_readonly("cpu_seconds",
                             [](const RunResult& r) { return r.outcome.cpu_seconds; })
      .def("save", &save, py::arg("folder"), py::arg("force"));
  m.def("read_records", &read_records, py::arg("file"), py::arg("replicate"));
}

}  // namespace mahlwerk::python
