// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::results {

/// How often balls collide.
std::vector<Measure> collision_rates();
/// How often with each other and with the jar, where there are several.
std::vector<Measure> collision_rates_by_partner(const cases::Case& what);
/// How hard: means over all collisions, and over those above the threshold.
std::vector<Measure> collision_means();

}  // namespace mahlwerk::results
