// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/measure/measured.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/text.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/catalogue/catalogue_read.hpp"
#include "mahlwerk/cases/catalogue/catalogue_write.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/measure/draws.hpp"
#include "mahlwerk/commands/measure/next.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/report/aligned.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/json.hpp"
#include "mahlwerk/results/files/writer.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;
using results::Json;

/// The row for `mahlwerk fit` and its headings, with the conditions of --set.
std::array<std::string, 2> data_lines(const MeasureOutput& given, const Measured& measured) {
  std::vector<std::string> headings, cells;
  for (const cases::Override& one : given.set) {
    headings.push_back(results::csv_cell(std::string_view(one.key)));
    cells.push_back(results::csv_cell(std::string_view(one.value)));
  }
  for (const auto& [heading, cell] : measured.row) {
    headings.push_back(heading);
    cells.push_back(cell);
  }
  return {results::csv_line(headings), results::csv_line(cells)};
}

/// The text to append to the table of measurements. Throws InputError if it has other columns.
std::string data_text(const MeasureOutput& given, const Measured& measured) {
  const auto [headings, cells] = data_lines(given, measured);
  std::error_code none;
  if (!fs::exists(*given.data, none)) return headings + cells;
  std::ifstream stream(*given.data);
  std::string first;
  std::getline(stream, first);
  if (fmt::format("{}\n", first) != headings)
    throw InputError(
        Fault{given.data->string(),
              "the table has other columns than " + headings.substr(0, headings.size() - 1),
              "name another file for --data, or give the same --set as before", "bad-data"});
  return cells;
}

/// Everything that will be written, made before anything is.
struct MeasuredFiles {
  std::string entry, data;
  std::optional<cases::Case> calibrated;
  std::optional<results::Folder> folder;
};

void prepare(const MeasureOutput& given, const Measured& measured, MeasuredFiles& files) {
  if (given.entry) {
    refuse_existing(*given.entry, given.running.force);
    files.entry = cases::entry_text(*measured.entry);
    cases::read_entry(files.entry, measured.entry->category, measured.entry->name,
                      given.entry->string());
  }
  if (given.data) files.data = data_text(given, measured);
  if (given.case_target.empty()) {
    if (given.next || given.running.out)
      throw InputError(Fault{given.next ? "--next" : "--out", "no case is given",
                             "give --case CASE", "bad-command-line"});
    return;
  }
  files.calibrated = case_with(given, measured);
  add_draws(measured, *files.calibrated);
  const fs::path usual =
      default_folder(given.case_target, one_case_file(given.case_target, "measure"), false)
          .string() +
      "-measured";
  files.folder.emplace(given.running.out.value_or(usual), given.running.force);
}

void write_files(const MeasureOutput& given, MeasuredFiles& files) {
  if (given.entry) results::write_whole(*given.entry, files.entry);
  if (given.data) results::append_text(*given.data, files.data);
  if (!files.folder) return;
  results::write_case(*files.folder, *files.calibrated, "calibrated.toml");
  files.folder->commit();
}

/// The number as people say it: degrees, revolutions per minute, millilitres.
std::string readable_finding(const measure::Finding& one) {
  struct Spoken {
    std::string_view unit, spoken;
  };
  static constexpr std::array<Spoken, 3> units{{{"rad", "deg"}, {"rad/s", "rpm"}, {"m3", "ml"}}};
  for (const Spoken& unit : units)
    if (one.unit == unit.unit) {
      const double factor = 1 / parse_in(fmt::format("1 {}", unit.spoken), unit.unit);
      return report::readable(factor * one.value.mean, factor * one.value.ci95, unit.spoken).text();
    }
  return report::readable(one.value.mean, one.value.ci95, one.unit).text();
}

std::string findings_table(const measure::Findings& found) {
  std::vector<std::array<std::string, 3>> lines{{"", "95 % interval", "key"}};
  for (const measure::Finding& one : found.list)
    lines.push_back({one.label, readable_finding(one), one.key});
  return report::aligned(lines);
}

/// The values as options of other commands.
std::string set_options(const measure::Findings& found) {
  std::string words;
  for (const measure::Finding& one : found.list)
    if (!one.key.empty())
      words += fmt::format(
          " --set {}", shell_word(fmt::format("{}={}", one.key,
                                              measured_text(one.value.mean, one.value, one.unit))));
  return words;
}

void print_measured(const MeasureOutput& given, const Measured& measured,
                    const MeasuredFiles& files) {
  std::string text = fmt::format("{}\n\n{}", measured.title, findings_table(measured.found));
  if (!measured.more.empty()) text += "\n" + measured.more;
  for (const std::string& remark : measured.found.remarks) text += fmt::format("\n{}\n", remark);
  const std::string set = set_options(measured.found);
  if (given.entry || given.data || files.folder || !set.empty()) text += "\n";
  if (!set.empty()) text += fmt::format("in a case:{}\n", set);
  if (given.entry) text += fmt::format("entry:     {}\n", given.entry->string());
  if (given.data) text += fmt::format("data:      {}\n", given.data->string());
  if (files.folder)
    text += fmt::format("case:      {}\n", (files.folder->target() / "calibrated.toml").string());
  to_stdout(text);
}

Json measured_json(const Measured& measured, const std::string& next) {
  Json values = Json::array(), remarks = Json::array();
  for (const measure::Finding& one : measured.found.list)
    values.push_back(Json::object({{"key", one.key.empty() ? Json() : Json(one.key)},
                                   {"label", one.label},
                                   {"value", one.value.mean},
                                   {"low", one.value.mean - one.value.ci95},
                                   {"high", one.value.mean + one.value.ci95},
                                   {"unit", one.unit}}));
  for (const std::string& one : measured.found.remarks) remarks.push_back(one);
  return Json::object({{"study", "measure"},
                       {"program", fmt::format("mahlwerk {}", version())},
                       {"title", measured.title},
                       {"values", std::move(values)},
                       {"remarks", std::move(remarks)},
                       {"details", measured.details},
                       {"next", next}});
}

}  // namespace

Options entry_option(MeasureOutput& given) {
  return {{.name = "--entry",
           .target = &given.entry,
           .about = "file of a catalogue entry to write: my-catalogue/mills/my-mill.toml"}};
}

Options data_options(MeasureOutput& given) {
  return {{.name = "--data",
           .target = &given.data,
           .about = "table for mahlwerk fit, which gets a row with this measurement; --set gives "
                    "its condition"}};
}

Options case_options(MeasureOutput& given) {
  return joined(
      {{{.name = "--case",
         .target = &given.case_target,
         .about = "a case, which is written with the measured values and their intervals"},
        {"--set", &given.set,
         "value of another key of the case, or a condition of the measurement: "
         "--set mill.frequency=\"25 Hz\"; may be repeated",
         "KEY=VALUE"},
        {"--next", &given.next, "run the case to find what to measure next: seconds to minutes"}},
       options_of(given.running, ", with -measured"),
       {json(given.running.json)}});
}

int report_measured(const MeasureOutput& given, const Measured& measured) {
  MeasuredFiles files;
  prepare(given, measured, files);
  write_files(given, files);
  const std::string quick = next_by_powers(measured, files.calibrated);
  if (given.running.prints_text()) print_measured(given, measured, files);
  const std::string next = given.next ? next_by_runs(given, measured) : quick;
  if (given.next && next.empty())
    return report_interrupted(given.running, "the measured values are written.");
  if (given.running.json) json_to_stdout(measured_json(measured, next));
  if (given.running.prints_text() && !next.empty()) to_stdout("\n" + next);
  return success;
}

observe::Estimate quantity_with_error(const std::string& text, std::string_view unit,
                                      std::string_view option) {
  std::size_t at = text.find("+-"), width = 2;
  if (at == std::string::npos) at = text.find("\u00b1");
  std::string value(trimmed(std::string_view(text).substr(0, at)));
  std::string error(at == std::string::npos ? std::string_view("0")
                                            : trimmed(std::string_view(text).substr(at + width)));
  const std::string written(number_text(error).rest), own(number_text(value).rest);
  if (own.empty()) value += " " + written;
  if (written.empty()) error += " " + own;
  try {
    const observe::Estimate made{parse_in(value, unit), parse_in(error, unit)};
    if (made.mean > 0 && made.ci95 >= 0 && made.ci95 < made.mean && made.mean < 1e9) return made;
  } catch (const UnitError&) {
  }
  throw InputError(Fault{
      fmt::format("{} {}", option, text), "this is no positive quantity with an error",
      fmt::format("write for instance {0} \"{1}\" or {0} \"{1} +- {2}\"", option, example_of(unit),
                  show_rounded(0.01 * parse_in(example_of(unit), unit), unit)),
      "bad-quantity"});
}

std::string measured_text(double value, const observe::Estimate& of, std::string_view unit) {
  int digits = 6;
  if (of.ci95 > 0 && of.mean != 0)
    digits = static_cast<int>(
        std::clamp(std::ceil(math::log10(std::abs(of.mean) / of.ci95)) + 2, 3.0, 12.0));
  return show_rounded(value, unit, digits);
}

void put_in_entry(const measure::Findings& found, std::string_view section,
                  const std::string& source, cases::CatalogueEntry& entry) {
  for (const measure::Finding& one : found.list) {
    if (!one.key.starts_with(section)) continue;
    const observe::Estimate& v = one.value;
    const bool positive = v.mean > 0;
    const double low = positive ? std::max(v.mean - v.ci95, 0.01 * v.mean) : v.mean - v.ci95;
    const double high = positive ? v.mean + v.ci95 : std::min(v.mean + v.ci95, 0.01 * v.mean);
    entry.values[one.key.substr(section.size())] = {
        .text = measured_text(v.mean, v, one.unit),
        .source = source,
        .range = {measured_text(low, v, one.unit), measured_text(high, v, one.unit)}};
  }
}

}  // namespace mahlwerk::commands
