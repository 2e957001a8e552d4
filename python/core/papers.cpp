// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What mahlwerk.papers takes from the library: numbers and units as text, labels of axes, fitted
// laws, the faults and quantities of a campaign before it runs, notices and the frame of a page.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mahlwerk/base/data_folder.hpp"
#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/campaign/store/store.hpp"
#include "mahlwerk/commands/places.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/plot/axis_labels.hpp"
#include "mahlwerk/report/plot/law_words.hpp"
#include "mahlwerk/report/plot/rich_text.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/files/json.hpp"
#include "mahlwerk/results/files/manifest.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"
#include "outcome.hpp"

namespace mahlwerk::python {
namespace {

namespace py = pybind11;
using report::FittedLaw;
using report::LawForm;

constexpr std::array<const char*, 3> law_forms{"line", "power", "parabola"};

LawForm law_form(const std::string& name) {
  for (std::size_t i = 0; i < law_forms.size(); ++i)
    if (name == law_forms[i]) return static_cast<LawForm>(i);
  throw py::value_error("there is no law " + name);
}

/// The same; a text that is no such quantity raises ValueError.
template <class Read>
auto quantity_or_error(const Read& read) try {
  return read();
} catch (const UnitError& error) {
  throw py::value_error(error.what());
}

std::string plain_unit(const std::string& unit) {
  return unit == "1" ? "" : unit;
}

double quantity_in(const std::string& text, const std::string& unit) {
  return quantity_or_error([&] { return parse_in(text, plain_unit(unit)); });
}

double si_value(const std::string& text) {
  return quantity_or_error([&] { return parse_quantity(text).value; });
}

/// A bound in the unit of a quantity of the summary: J/g, deg. Units without a name are SI.
double bound_in(const std::string& text, const std::string& unit) {
  const double si = si_value(text);
  try {
    const double zero = parse_quantity("0 " + unit).value;
    return (si - zero) / (parse_quantity("1 " + unit).value - zero);
  } catch (const UnitError&) {
    return si;  // "1", "1/s"
  }
}

bool same_value(const std::string& a, const std::string& b) {
  if (a == b) return true;
  try {
    const mahlwerk::Quantity x = parse_quantity(a), y = parse_quantity(b);
    const double size = std::max(std::abs(x.value), std::abs(y.value));
    return x.dimension == y.dimension && std::abs(x.value - y.value) <= 1e-12 * size;
  } catch (const UnitError&) {
    return false;  // words
  }
}

/// (form, coefficients, half-widths, reference, R2) of each law.
py::list fitted_laws(const std::vector<double>& x, const std::vector<double>& y,
                     const std::vector<double>& ci95) {
  py::list all;
  for (const FittedLaw& law : report::fitted_laws(x, y, ci95))
    all.append(py::make_tuple(law_forms[static_cast<std::size_t>(law.form)], law.coefficients,
                              law.ci95, law.reference, law.r_squared));
  return all;
}

std::string law_words(const std::string& form, const std::vector<double>& coefficients,
                      double reference, double r_squared, const std::string& key,
                      const std::string& x_unit, const std::string& quantity, double factor,
                      const std::string& unit) {
  const FittedLaw law{.form = law_form(form),
                      .coefficients = coefficients,
                      .reference = reference,
                      .r_squared = r_squared};
  return report::law_words(law, {.x = report::symbol_of_key(key),
                                 .x_unit = x_unit,
                                 .y = report::symbol_of_quantity(quantity),
                                 .multiple = {factor, unit}});
}

/// Label, least and largest value of a quantity.
py::tuple traits(const std::string& quantity) {
  const results::Range range = results::range_of(quantity);
  return py::make_tuple(report::label(quantity), range.least, range.most);
}

/// Why points of a campaign cannot run.
std::vector<Fault> campaign_faults(const std::string& text, const std::filesystem::path& file,
                                   const Changes& set) {
  const std::vector<cases::Override> overrides = overrides_of(set);
  const cases::Catalogue catalogue = commands::catalogue();
  const cases::Case whole = cases::read_text(text, file, catalogue, overrides);
  if (whole.sweep.empty())
    return {{file.generic_string(), "the case has no [sweep]: no key varies",
             "add [sweep] and the values of a key below it", "no-sweep"}};
  std::vector<Fault> faults;
  for (const cases::Case& point : campaign::points(whole, catalogue, overrides))
    for (Fault& fault : campaign::run_faults(point)) faults.push_back(std::move(fault));
  return faults;
}

/// The notices of campaigns in these folders: lines for the terminal, boxes of a page, and JSON.
py::tuple notice_texts(const std::vector<std::filesystem::path>& folders, const std::string& what) {
  results::NoticeCounts all;
  std::size_t points = 0;
  for (const std::filesystem::path& folder : folders) {
    const campaign::Store store(folder / "campaign.sqlite", campaign::Store::Access::read);
    points += store.counts().points;
    for (const results::NoticeCount& one : store.notices())
      for (std::size_t i = 0; i < one.runs; ++i) results::count(all, {one.first});
  }
  results::sort(all);
  return py::make_tuple(report::notice_lines(all, points, what),
                        report::notice_boxes(all, points, what), results::notices_json(all).text());
}

int report_end(int code, const std::string& words, const std::vector<Fault>& faults, bool as_json) {
  if (as_json) commands::set_json_messages();
  return commands::report_end(code, words, faults);
}

void bind_numbers(py::module_& m) {
  m.def(
      "readable_parts",
      [](double value, double ci95, const std::string& unit, double size) {
        const report::Readable shown = report::readable(value, ci95, unit, size);
        return py::make_tuple(shown.number, shown.unit);
      },
      "Number and unit as the program prints them, in the multiple that suits `size`.");
  m.def(
      "multiple",
      [](double size, const std::string& unit) {
        const report::Multiple made = report::multiple(size, unit);
        return py::make_tuple(made.factor, made.unit);
      },
      "Factor and name of the multiple of a unit that suits a number.");
  m.def("student95", &observe::student95);
  m.def("two_digits", [](double value) { return mahlwerk::two_digits(value); });
  m.def("shortest", [](double value) { return mahlwerk::shortest(value); });
  m.def("lerp", [](double a, double b, double t) { return std::lerp(a, b, t); });
  m.def("quantity_in", &quantity_in, "The number of a text in a unit.");
  m.def("si_value", &si_value);
  m.def("bound_in", &bound_in);
  m.def("same_value", &same_value);
  m.def("number_text", [](const std::string& text) {
    const NumberText read = mahlwerk::number_text(text);
    return py::make_tuple(read.number, std::string(read.rest));
  });
  m.def("csv_cell", [](const std::string& text) { return results::csv_cell(text); });
  m.def("column_name", [](const std::string& name, const std::string& unit) {
    return results::column_name(name, unit);
  });
}

void bind_labels(py::module_& m) {
  m.def("fitted_laws", &fitted_laws);
  m.def("law_words", &law_words);
  m.def("plain_text", [](const std::string& text) { return report::plain_text(text); });
  m.def("axis_of_quantity", [](const std::string& name, double factor, const std::string& unit) {
    return report::quantity_axis(name, {factor, unit});
  });
  m.def("axis_of_key", [](const std::string& key, const std::string& unit) {
    return report::key_axis(key, unit);
  });
  m.def("symbol_of_key", [](const std::string& key) { return report::symbol_of_key(key); });
  m.def("traits", &traits);
}

}  // namespace

void bind_papers(py::module_& m) {
  bind_numbers(m);
  bind_labels(m);
  m.def("campaign_faults", &campaign_faults);
  m.def("notice_texts", &notice_texts);
  m.def("report_end", &report_end);
  m.def("page", [](const std::string& title, const std::string& body, const std::string& footer) {
    return report::page(title, body, footer);
  });
  m.def("listed_files", [](const std::filesystem::path& folder) {
    return results::listed_files(folder).value_or(std::set<std::string>());
  });
  m.def("list_files", &results::list_files);
  m.def("data_folder", [](const std::string& part) { return mahlwerk::data_folder(part); });
}

py::list swept_keys(const cases::Case& whole) {
  py::list all;
  for (const cases::SweptKey& one : whole.sweep.keys)
    all.append(py::make_tuple(one.key, one.values, one.range));
  return all;
}

py::list quantities(const cases::Case& whole) {
  results::Outcome none;
  none.mill_case = whole;
  py::list all;
  for (const results::Quantity& q : results::summarise(none).quantities)
    all.append(py::make_tuple(q.name, q.unit));
  return all;
}

}  // namespace mahlwerk::python
