// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/results/outcome.hpp"

// The key quantities of a result, with what assumed values do to them.
namespace mahlwerk::report {

/// Label, value and interval of a key quantity in words: "time to a dose of 1 kJ/g", "99 ± 8 s",
/// "99 to 740 s".
std::string key_title(const results::Quantity& q, const cases::Case& mill_case);
std::string key_value(const results::Quantity& q);
std::string key_range(double low, double high, const std::string& unit);

/// The table of key quantities for the terminal, and the assumed values behind its ranges.
std::string key_table(const results::Outcome& outcome);

/// The same as parts of a page.
std::string key_section(const results::Outcome& outcome);

}  // namespace mahlwerk::report
