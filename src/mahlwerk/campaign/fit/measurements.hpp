// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "mahlwerk/cases/read.hpp"

// What was measured of powder that a mill has milled (docs/formats.md, "Measurements").
namespace mahlwerk::campaign {

enum class MeasuredQuantity {
  quantile,          ///< [m] size that a share of the mass is finer than
  passing,           ///< [1] of the mass, finer than a size
  specific_surface,  ///< [m2/kg]
  conversion         ///< [1]
};

/// "D90", "passing", "specific_surface" or "conversion"; the unit its value is kept in.
std::string name_of(MeasuredQuantity what, int percent);
std::string_view unit_of(MeasuredQuantity what);

struct Measurement {
  std::size_t condition = 0;
  double time = std::numeric_limits<double>::quiet_NaN();  ///< [s] of milling; NaN: as in the case
  MeasuredQuantity what = MeasuredQuantity::quantile;
  int percent = 0;  ///< of a quantile: 90 is D90
  double size = 0;  ///< [m] of what passes
  double value = 0;
  double error = std::numeric_limits<double>::quiet_NaN();  ///< standard deviation; NaN: not known
  int line = 0;                                             ///< of the file
};

struct Measurements {
  /// What the case is to be changed by; measurements share those that are equal.
  std::vector<std::vector<cases::Override>> conditions;
  std::vector<Measurement> values;  ///< at least one; errors of all are known, or of none

  bool errors_known() const;
};

/// Reads a table of measurements. Throws InputError with every fault found: line, what, remedy.
Measurements read_measurements(const std::filesystem::path& file);

/// The same from text; `file` is the name faults cite.
Measurements read_measurements_text(const std::string& text, const std::string& file);

}  // namespace mahlwerk::campaign
