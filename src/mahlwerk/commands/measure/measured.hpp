// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mahlwerk/cases/catalogue.hpp"
#include "mahlwerk/commands/arguments.hpp"
#include "mahlwerk/measure/finding.hpp"
#include "mahlwerk/results/files/json_value.hpp"

// What the commands `mahlwerk measure ...` share: their outputs.
namespace mahlwerk::commands {

/// Arguments that say where a measurement goes.
struct MeasureOutput {
  std::optional<std::filesystem::path> entry;  ///< file of a catalogue entry to write
  std::optional<std::filesystem::path> data;   ///< table for `mahlwerk fit`, which gets a row
  std::string case_target;                     ///< case to calibrate; empty: none
  std::vector<cases::Override> set;            ///< changes of it, and conditions of the row
  bool next = false;                           ///< run it to rank what is still assumed
  Running running;
};

Options entry_option(MeasureOutput& given);
Options data_options(MeasureOutput& given);
/// --case, --set, --next, --out, --force, --jobs, --quiet, --json.
Options case_options(MeasureOutput& given);

/// A measurement, ready to be written and printed.
struct Measured {
  std::string title;   ///< "Film track.csv, arc-shaker"
  std::string source;  ///< of the values, for entries and cases
  measure::Findings found;
  std::optional<cases::CatalogueEntry> entry = {};  ///< with the found values
  /// Columns of a row for `mahlwerk fit`: heading and cell.
  std::vector<std::pair<std::string, std::string>> row = {};
  std::string more = {};            ///< further lines for the terminal
  results::Json details = nullptr;  ///< further numbers for --json
};

/// Writes the files that are asked for, prints the numbers, and says what to measure next. Returns
/// the exit code. Throws InputError before anything is written.
int report_measured(const MeasureOutput& given, const Measured& measured);

/// Calls `analyse`; faults of it without a place get that of the file.
template <class F>
auto at_file(const std::string& file, const F& analyse) {
  try {
    return analyse();
  } catch (const InputError& e) {
    std::vector<Fault> faults = e.faults();
    for (Fault& fault : faults)
      if (fault.where.empty()) fault.where = file;
    throw InputError(std::move(faults));
  }
}

/// A length, mass or other quantity with its 95 % half-width: "80 mm +- 0.5 mm", "80 +- 0.5 mm" or,
/// exact, "80 mm". `option` is cited by faults. Throws InputError.
observe::Estimate quantity_with_error(const std::string& text, std::string_view unit,
                                      std::string_view option);

/// The value, as text with as many digits as its half-width deserves: "136.2 mm".
std::string measured_text(double value, const observe::Estimate& of, std::string_view unit);

/// Adds the values of the findings whose keys begin with `section` to an entry.
void put_in_entry(const measure::Findings& found, std::string_view section,
                  const std::string& source, cases::CatalogueEntry& entry);

}  // namespace mahlwerk::commands
