// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/results/outcome.hpp"

// States of a charge side by side: of its motion in a lying jar that is shaken, and of replicates
// that fall into two groups by their power. Empty where there is one state.
namespace mahlwerk::report {

std::string states_table(const results::Outcome& outcome);    ///< for the terminal
std::string states_section(const results::Outcome& outcome);  ///< for the page

}  // namespace mahlwerk::report
