// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/admission.hpp"
#include "mahlwerk/campaign/fit/measurements.hpp"

// Columns of a table of measurements.
namespace mahlwerk::campaign {

/// Role of a column.
enum class Role { time, size, fall, measured, error, condition };

struct Column {
  Role role = Role::condition;
  std::string name;         ///< "D90", also for its errors; the key of a condition
  std::string unit;         ///< as written
  std::string stored_unit;  ///< in which its numbers are stored
  Range range;              ///< of its numbers, in that unit
  MeasuredQuantity what = MeasuredQuantity::quantile;  ///< for measured values and their errors
  int percent = 0;                                     ///< of a quantile
  RunQuantity quantity = {};                           ///< of a run
  std::optional<std::size_t> error_in;  ///< for measured values: the column of their errors
};

/// The column of a heading: "D90 (um)", "D90 [um]", "D90_um" or "D90"; empty if it is unknown.
std::optional<Column> column_of(const std::string& heading, const RunQuantities& known = {});

/// The nearest known heading; empty if none is near.
std::string heading_near(const std::string& heading, const RunQuantities& known = {});

/// The cells of a line. Between quotes separators are text, and two quotes stand for one.
std::vector<std::string> cells_of(std::string_view line, char separator);

}  // namespace mahlwerk::campaign
