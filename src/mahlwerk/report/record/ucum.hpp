// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace mahlwerk::report {

/// A unit of cases and results as a code of UCUM (Unified Code for Units of Measure): "/s" for
/// "1/s", "W/m2/K" for "W/(m2 K)", "Cel" for "degC", "1" for a pure number. Empty for a unit that
/// the program does not know.
std::string ucum(std::string_view unit);

}  // namespace mahlwerk::report
