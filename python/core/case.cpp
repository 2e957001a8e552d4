// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A resolved case, and the keys that a case may have.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <string>
#include <utility>
#include <vector>

#include "mahlwerk/cases/file/table.hpp"
#include "mahlwerk/cases/keys.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/commands/places.hpp"
#include "outcome.hpp"

namespace mahlwerk::python {
namespace {

namespace py = pybind11;

cases::Case read_case(const std::string& text, const std::filesystem::path& file,
                      const Changes& changes) {
  return cases::read_text(text, file, commands::catalogue(), overrides_of(changes));
}

py::list origins(const cases::Case& mill_case) {
  py::list all;
  for (const cases::Origin& o : mill_case.origins) {
    py::object range = py::none();
    if (!o.range[0].empty()) range = py::make_tuple(o.range[0], o.range[1]);
    all.append(py::make_tuple(o.key, o.value, o.source, o.assumed, o.unverified, range));
  }
  return all;
}

/// (key, unit, words, about) of every key.
py::list keys() {
  py::list all;
  for (const cases::KeyInfo& key : cases::all_keys())
    all.append(py::make_tuple(key.key, key.unit, key.words, key.about));
  return all;
}

}  // namespace

std::vector<cases::Override> overrides_of(const Changes& changes) {
  std::vector<cases::Override> made;
  for (const auto& [key, value] : changes)
    made.push_back({.key = key, .value = value.value_or(""), .unset = !value});
  return made;
}

void bind_case(py::module_& m) {
  py::class_<cases::Case>(m, "ResolvedCase", "A case with every value filled in.")
      .def("write", &cases::write)
      .def("origins", &origins)
      .def("swept_keys", &swept_keys)
      .def("quantities", &quantities)
      .def_property_readonly("sweeps", [](const cases::Case& c) { return !c.sweep.empty(); })
      .def_readonly("title", &cases::Case::title)
      .def("__eq__", [](const cases::Case& a, const cases::Case& b) { return a == b; });
  m.def("read_case", &read_case, py::arg("text"), py::arg("file"), py::arg("changes"));
  m.def("keys", &keys);
  m.def("keys_in_text",
        [](const std::string& text) { return cases::keys_in(cases::parse_tree(text, "case")); });
  m.def("case_files", [](const std::string& target) { return commands::case_files(target); });
}

}  // namespace mahlwerk::python
