// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/results/files/json_value.hpp"

// The units of a case file, as a table and as JSON.
namespace mahlwerk::commands {

/// The units that measure the same in one line, in the order of the table of units.
std::string unit_table();
results::Json units_as_json();

}  // namespace mahlwerk::commands
