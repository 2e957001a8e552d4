// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/results/outcome.hpp"

// Two states of a mill side by side. Empty where the replicates show one.
namespace mahlwerk::report {

std::string states_table(const results::Outcome& outcome);    ///< for the terminal
std::string states_section(const results::Outcome& outcome);  ///< for the page

}  // namespace mahlwerk::report
