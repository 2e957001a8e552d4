// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "mahlwerk/results/files/csv.hpp"

// Columns of tables, to be drawn.
namespace mahlwerk::report {

/// The numbers of the column of this name, in multiples of `factor`; none if there is no such
/// column.
std::vector<double> column(const results::Table& table, std::string_view name, double factor = 1);

/// The largest, or 0 where none is above it.
double largest(const std::vector<double>& values);

}  // namespace mahlwerk::report
