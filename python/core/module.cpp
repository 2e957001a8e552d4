// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The module mahlwerk._core: what the Python package takes from the library. Faults become the
// exceptions of mahlwerk.errors.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <exception>
#include <string>
#include <system_error>

#include "job.hpp"
#include "mahlwerk/base/data_folder.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/isa.hpp"
#include "mahlwerk/commands/places.hpp"
#include "mahlwerk/commands/reporting/result_files.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "outcome.hpp"

namespace mahlwerk::python {
namespace {

namespace py = pybind11;

void raise(const char* type, const py::object& content) {
  const py::object made = py::module_::import("mahlwerk.errors").attr(type)(content);
  PyErr_SetObject(py::type::handle_of(made).ptr(), made.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const InputError& e) {
    raise("InputError", py::cast(e.faults()));
  } catch (const RunError& e) {
    raise("RunError", py::str(e.what()));
  } catch (const std::system_error&) {
    raise("InputError", py::cast(commands::faults_of_system(thrown)));
  } catch (const Interrupted&) {
    raise("Interrupted", py::str("nothing was computed"));
  }
}

}  // namespace

PYBIND11_MODULE(_core, m) {
  m.doc() = "The compiled part of mahlwerk. Use the package mahlwerk.";
  py::class_<Fault>(m, "Fault", "One fault of an input: where it is, what it is, and the remedy.")
      .def(py::init([](std::string where, std::string what, std::string remedy, std::string code) {
             return Fault{std::move(where), std::move(what), std::move(remedy), std::move(code)};
           }),
           py::arg("where"), py::arg("what"), py::arg("remedy"), py::arg("code"))
      .def_readonly("where", &Fault::where, "File and line, or key; may be empty.")
      .def_readonly("what", &Fault::what, "The cause.")
      .def_readonly("remedy", &Fault::remedy, "What to do; may be empty.")
      .def_readonly("code", &Fault::code, "Heading on the page of errors.")
      .def("__str__", [](const Fault& f) { return describe({f}); })
      .def("__repr__",
           [](const Fault& f) { return "<Fault " + f.code + ": " + describe({f}) + ">"; })
      .def(py::pickle(
          [](const Fault& f) { return py::make_tuple(f.where, f.what, f.remedy, f.code); },
          [](const py::tuple& t) {
            return Fault{t[0].cast<std::string>(), t[1].cast<std::string>(),
                         t[2].cast<std::string>(), t[3].cast<std::string>()};
          }));
  m.def("describe_faults", [](const std::vector<Fault>& faults) { return describe(faults); });
  py::register_exception_translator(&translate);
  m.def("set_data_folder", [](const std::string& folder) { set_data_folder(folder); });
  m.attr("version") = std::string(commands::version());
  m.def("stop_all_jobs", &stop_all_jobs, "Ends all work and waits for it; at exit.");
  m.def("isa", [] { return std::string(name_of(isa())); });
  m.def(
      "readable",
      [](double value, double ci95, const std::string& unit, double least, double most) {
        return report::readable_within(value, ci95, unit, {least, most}).text();
      },
      py::arg("value"), py::arg("ci95"), py::arg("unit"), py::arg("least"), py::arg("most"),
      "A number with its half-width and unit as the program prints it.");
  bind_case(m);
  bind_records(m);
  bind_outcome(m);
  bind_run(m);
  bind_commands(m);
  bind_papers(m);
}

}  // namespace mahlwerk::python
