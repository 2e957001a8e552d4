// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mahlwerk/report/plot/map.hpp"
#include "mahlwerk/results/outcome.hpp"

// Maps of one outcome; nullopt if there is nothing to show.
namespace mahlwerk::report {

/// The jar's wall, unrolled, and its two ends, coloured by the power lost by impacts per area.
std::optional<ColourMap> wall_power_map(const results::Outcome& outcome);

/// The parts in the jar that lose most power by impacts, seen along their own axes, coloured by it
/// per area: one map of each, at most `most`.
std::vector<ColourMap> part_power_maps(const results::Outcome& outcome, std::size_t most = 4);

/// Mass and mean velocity of the charge in the plane of motion, in the frames of the carrier and of
/// the jar.
std::optional<ColourMap> charge_map(const results::Outcome& outcome);

/// Joint histogram of collisions by normal and tangential energy.
std::optional<ColourMap> joint_energy_map(const results::Outcome& outcome);

}  // namespace mahlwerk::report
