// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/columns.hpp"

#include <algorithm>

namespace mahlwerk::report {

std::vector<double> column(const results::Table& table, std::string_view name, double factor) {
  const auto place = std::ranges::find(table.columns, name, &results::Column::name);
  std::vector<double> values;
  if (place == table.columns.end()) return values;
  const auto i = static_cast<std::size_t>(place - table.columns.begin());
  for (const auto& row : table.rows) values.push_back(row[i] / factor);
  return values;
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, v);
  return most;
}

}  // namespace mahlwerk::report
