// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/results/summary.hpp"

// The order in which quantities are shown.
namespace mahlwerk::results {

/// Names of the quantities that answer what a user asks first, as far as the list has them.
std::vector<std::string> key_quantities(const std::vector<Quantity>& list);

/// Names of the quantities that the tables of campaigns begin with, the powder first.
const std::vector<std::string>& usual_columns();

/// Quantities that are shown together under a heading.
struct QuantityGroup {
  std::string_view heading;
  std::vector<std::string> names;
};
/// All quantities of the list in its order, in groups.
std::vector<QuantityGroup> quantity_groups(const std::vector<Quantity>& list);

}  // namespace mahlwerk::results
