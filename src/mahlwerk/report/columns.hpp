// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "mahlwerk/results/files/csv.hpp"

// Columns of tables, for plots.
namespace mahlwerk::report {

/// The numbers of the column `name`, divided by `factor`; empty if there is no such column.
std::vector<double> column(const results::Table& table, std::string_view name, double factor = 1);

/// The largest value, or 0 if none is positive.
double largest(const std::vector<double>& values);

}  // namespace mahlwerk::report
