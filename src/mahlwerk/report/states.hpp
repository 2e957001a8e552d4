// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/results/outcome.hpp"

// Bistable mills: the two states side by side. Empty if the replicates show one state.
namespace mahlwerk::report {

std::string states_table(const results::Outcome& outcome);    ///< for the terminal
std::string states_section(const results::Outcome& outcome);  ///< for the page

}  // namespace mahlwerk::report
