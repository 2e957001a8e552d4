// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::results {

/// [1] Overlaps above this share of a ball's radius are more than contact laws are meant for.
constexpr double soft_overlap = 0.01;

/// What the numbers of a run say of themselves: a run cut short or stopped, an energy balance that
/// does not close. Made from `outcome.summary` once, when the run ends, and kept in
/// `Outcome::notices`.
Notices warnings(const Outcome& outcome);

}  // namespace mahlwerk::results
