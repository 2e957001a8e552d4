// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/results/outcome.hpp"

// The key quantities of a result, with what assumed values do to them.
namespace mahlwerk::report {

/// The table of key quantities for the terminal, and the assumed values behind its ranges.
std::string key_table(const results::Outcome& outcome);

/// The same as parts of a page.
std::string key_section(const results::Outcome& outcome);

}  // namespace mahlwerk::report
