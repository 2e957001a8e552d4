// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::report {

/// The parts of a report on the powder: what collisions catch, how fine it gets, what the dose
/// does. Empty for a case that asks for none of it.
std::string powder_sections(const results::Outcome& outcome);

}  // namespace mahlwerk::report
