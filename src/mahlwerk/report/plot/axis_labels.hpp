// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/report/text/readable.hpp"

// Labels of axes in figures: name, symbol and unit (marks as in plot.hpp).
namespace mahlwerk::report {

/// Symbol of a quantity of summary.json, "$E_{n}$"; empty if it has none.
std::string symbol_of_quantity(std::string_view quantity);
/// Symbol of a key of a case, "$f$"; empty if it has none.
std::string symbol_of_key(std::string_view key);

/// "mean normal energy, $E_{n}$ (mJ)"; the unit of a number without unit is "–".
std::string quantity_axis(std::string_view quantity, const Multiple& multiple);
/// "vibration frequency, $f$ (Hz)". `unit`: that of all values of the key, or empty.
std::string key_axis(std::string_view key, std::string_view unit);

}  // namespace mahlwerk::report
