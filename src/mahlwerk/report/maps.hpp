// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "mahlwerk/report/plot/map.hpp"
#include "mahlwerk/results/outcome.hpp"

// Maps of one outcome; nullopt if there is nothing to show.
namespace mahlwerk::report {

/// The jar's wall, unrolled, and its two ends, coloured by the power lost by impacts per area.
std::optional<ColourMap> wall_power_map(const results::Outcome& outcome);

/// Mass and mean velocity of the charge in the plane of motion, in the frames of the carrier and of
/// the jar.
std::optional<ColourMap> charge_map(const results::Outcome& outcome);

/// Joint histogram of collisions by normal and tangential energy.
std::optional<ColourMap> joint_energy_map(const results::Outcome& outcome);

}  // namespace mahlwerk::report
