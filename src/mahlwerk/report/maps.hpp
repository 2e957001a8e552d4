// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/results/outcome.hpp"

// Pictures of where: coloured maps as <svg> elements. Their colours are those of viridis, which
// keep their order in print and for the colour-blind.
namespace mahlwerk::report {

/// The jar's wall, unrolled, and its two ends, coloured by the power its hits lose per area.
std::string wall_picture(const results::Outcome& outcome);

/// Mass and mean velocity of the charge in the plane of motion, seen from the carrier and from the
/// jar.
std::string field_picture(const results::Outcome& outcome);

/// Collisions by normal and by tangential energy.
std::string normal_tangential_picture(const results::Outcome& outcome);

}  // namespace mahlwerk::report
