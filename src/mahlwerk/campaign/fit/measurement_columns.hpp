// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/campaign/fit/measurements.hpp"

// Columns of a table of measurements.
namespace mahlwerk::campaign {

/// What a column is.
enum class Role { time, size, measured, error, condition };

struct Column {
  Role role = Role::condition;
  std::string name;  ///< "D90", also of its errors; the key of a condition
  std::string unit;  ///< as written
  MeasuredQuantity what = MeasuredQuantity::quantile;  ///< of what is measured, and of its errors
  int percent = 0;                                     ///< of a quantile
  std::optional<std::size_t> error_in;  ///< of what is measured: its column of errors

  std::string_view stored_unit() const;  ///< the unit its numbers are kept in
};

/// The column of a heading: "D90 (um)", "D90 [um]", "D90_um" or "D90"; nothing if it is unknown.
std::optional<Column> column_of(const std::string& heading);

/// The heading that may have been meant; empty if none is near.
std::string heading_near(const std::string& heading);

/// The cells of a line; between quotes separators are text, and two quotes are one.
std::vector<std::string> cells_of(std::string_view line, char separator);

}  // namespace mahlwerk::campaign
