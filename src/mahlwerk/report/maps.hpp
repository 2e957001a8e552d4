// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/results/outcome.hpp"

// Spatial maps as <svg> elements, in the viridis colour scale (monotonic in print and for
// colour-blind readers).
namespace mahlwerk::report {

/// The jar's wall, unrolled, and its two ends, coloured by the power lost by impacts per area.
std::string wall_picture(const results::Outcome& outcome);

/// Mass and mean velocity of the charge in the plane of motion, in the frames of the carrier and of
/// the jar.
std::string field_picture(const results::Outcome& outcome);

/// Joint histogram of collisions by normal and tangential energy.
std::string normal_tangential_picture(const results::Outcome& outcome);

}  // namespace mahlwerk::report
