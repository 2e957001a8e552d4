// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "mahlwerk/cases/read.hpp"

// Measurements of milled powder, or of a mill (docs/formats.md, "Measurements").
namespace mahlwerk::campaign {

enum class MeasuredQuantity {
  quantile,          ///< [m] size below which a share of the mass lies
  passing,           ///< [1] share of the mass finer than a size
  specific_surface,  ///< [m2/kg]
  conversion,        ///< [1]
  yield,             ///< [1] share of the first product
  second_yield,      ///< [1] share of the second product
  ignition_time,     ///< [s] milling time until a self-propagating reaction
  of_run,            ///< a quantity of summary.json
  rebound_height     ///< [m] to which a ball rebounds from the jar after a fall
};

/// A quantity of summary.json that a column may hold.
struct RunQuantity {
  std::string name, unit;
};
using RunQuantities = std::vector<RunQuantity>;
/// Those of a run of a case.
RunQuantities run_quantities(const cases::Case& mill_case);

/// Name ("D90", "passing", "specific_surface", "conversion", ...), and unit in which values are
/// stored.
std::string name_of(MeasuredQuantity what, int percent);
std::string_view unit_of(MeasuredQuantity what);
/// Whether the powder was measured, not the mill.
bool of_powder(MeasuredQuantity what);

struct Measurement {
  std::size_t condition = 0;
  double time = std::numeric_limits<double>::quiet_NaN();  ///< [s] of milling; NaN: as in the case
  MeasuredQuantity what = MeasuredQuantity::quantile;
  int percent = 0;            ///< of a quantile: 90 is D90
  double size = 0;            ///< [m] for passing
  double fall = 0;            ///< [m] for rebound_height: the height from which the ball falls
  RunQuantity quantity = {};  ///< for of_run
  double value = 0;
  double error = std::numeric_limits<double>::quiet_NaN();  ///< standard deviation; NaN: not known
  int line = 0;                                             ///< of the file

  std::string name() const;  ///< "D90", "drawn_power"
  std::string unit() const;  ///< in which `value` is stored; empty: none
};

struct Measurements {
  /// Overrides of the case, one set per condition; measurements with equal sets share a condition.
  std::vector<std::vector<cases::Override>> conditions;
  std::vector<Measurement> values;  ///< at least one; errors are known for all, or for none

  bool errors_known() const;
};

/// "mill.speed = 300 rpm, ..."; empty without overrides.
std::string condition_label(const std::vector<cases::Override>& condition);

/// Reads a table of measurements, with columns of powder and of `known` quantities. Throws
/// InputError with all faults found: line, what, remedy.
Measurements read_measurements(const std::filesystem::path& file, const RunQuantities& known = {});

/// The same from text; `file` is the name that faults cite.
Measurements read_measurements_text(const std::string& text, const std::string& file,
                                    const RunQuantities& known = {});

}  // namespace mahlwerk::campaign
