// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::results {

/// What a reader must know before using the numbers: a run cut short or stopped, an energy balance
/// that does not close. Empty if all is well.
std::vector<std::string> warnings(const Outcome& outcome);

}  // namespace mahlwerk::results
