// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// RunResult: the numbers of a run as JSON and numpy arrays.
#include "outcome.hpp"

#include <pybind11/stl.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "commands.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/report/report.hpp"
#include "mahlwerk/results/files/collision_columns.hpp"
#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/hdf5.hpp"
#include "mahlwerk/results/files/json.hpp"
#include "mahlwerk/results/files/writer.hpp"
#include "records.hpp"

namespace mahlwerk::python {
namespace {

namespace py = pybind11;

/// numpy type of a column: numbers, or words of the length of the longest.
std::string format_of(const results::Column& column) {
  std::size_t longest = 1;
  for (const std::string& word : column.words) longest = std::max(longest, word.size());
  return column.words.empty() ? "f8" : "U" + std::to_string(longest);
}

/// The table as a structured array, with the column names of the CSV file.
py::array structured(const results::Table& table) {
  const py::module_ numpy = py::module_::import("numpy");
  py::list fields;
  for (const results::Column& column : table.columns)
    fields.append(
        py::make_tuple(results::column_name(column.name, column.unit), format_of(column)));
  const py::object array = numpy.attr("empty")(table.rows.size(), fields);
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const results::Column& column = table.columns[c];
    const py::str name(results::column_name(column.name, column.unit));
    if (column.words.empty()) {
      std::vector<double> values;
      for (const std::vector<double>& row : table.rows) values.push_back(row[c]);
      array[name] = py::array(py::ssize_t(values.size()), values.data());
    } else {
      py::list words;
      for (const std::vector<double>& row : table.rows)
        words.append(std::isfinite(row[c]) ? column.words.at(static_cast<std::size_t>(row[c]))
                                           : std::string());
      array[name] = words;
    }
  }
  return array;
}

py::dict tables(const RunResult& result) {
  py::dict all;
  for (const results::NamedTable& one : results::tables(result.outcome)) {
    py::list columns;
    for (const results::Column& column : one.table.columns)
      columns.append(py::make_tuple(results::column_name(column.name, column.unit), column.unit,
                                    column.about));
    all[py::str(one.name)] = py::make_tuple(structured(one.table), one.about, columns);
  }
  return all;
}

/// The records of a replicate, counted from 1: a view of the memory of the result.
py::array records(const py::object& self, std::size_t replicate) {
  auto& result = self.cast<RunResult&>();
  if (replicate < 1 || replicate > result.records.size())
    throw py::index_error("there are no records of replicate " + std::to_string(replicate));
  const std::vector<scene::Collision>& list = result.records[replicate - 1];
  py::array view(record_type(), {list.size()}, {sizeof(scene::Collision)}, list.data(), self);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

std::string failure(const RunResult& result) {
  for (const results::Replicate& r : result.outcome.replicates)
    if (!r.stop_reason.empty()) return r.stop_reason;
  return "";
}

void save(const RunResult& result, const std::filesystem::path& target, bool force) {
  const py::gil_scoped_release free;
  results::Folder folder(target, force);
  report::write(folder, result.outcome, app::version());
  folder.commit();
}

py::array read_records(const std::filesystem::path& file, int replicate) {
  std::vector<scene::Collision> read;
  {
    const py::gil_scoped_release free;
    read = results::read_collisions(file, replicate - 1);
  }
  return as_array(std::move(read));
}

py::dict columns_of_records() {
  py::dict columns;
  for (const results::CollisionColumn& column : results::collision_columns())
    columns[column.name] = py::make_tuple(column.unit, column.about);
  return columns;
}

}  // namespace

void bind_outcome(py::module_& m) {
  py::class_<RunResult>(m, "RunResult", "The outcome of a run in memory.")
      .def("summary_json",
           [](const RunResult& r) { return results::summary_json(r.outcome, app::version()); })
      .def("resolved_case", [](const RunResult& r) { return cases::write(r.outcome.mill_case); })
      .def("report_page",
           [](const RunResult& r) { return report::report_page(r.outcome, app::version(), true); })
      .def("sentence", [](const RunResult& r) { return report::sentence(r.outcome); })
      .def("tables", &tables)
      .def("records", &records, py::arg("replicate"))
      .def_property_readonly("replicates_with_records",
                             [](const RunResult& r) { return r.records.size(); })
      .def_property_readonly("complete",
                             [](const RunResult& r) { return results::complete(r.outcome); })
      .def_property_readonly("failure", &failure)
      .def_property_readonly("cpu_seconds",
                             [](const RunResult& r) { return r.outcome.cpu_seconds; })
      .def("save", &save, py::arg("folder"), py::arg("force"));
  m.def("read_records", &read_records, py::arg("file"), py::arg("replicate"));
  m.def("record_columns", &columns_of_records);
}

}  // namespace mahlwerk::python
