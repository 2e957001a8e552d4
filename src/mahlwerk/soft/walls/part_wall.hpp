// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "mahlwerk/scene/chamber.hpp"
#include "mahlwerk/soft/walls/moving_wall.hpp"

namespace mahlwerk::soft {

/// The wall of a jar with the parts of a chamber: faces from first_part_face() on are those of the
/// parts, one part after the other. Throws std::invalid_argument for more than max_part_motions
/// different motions.
std::unique_ptr<const MovingWall> wall_with_parts(std::unique_ptr<const MovingWall> jar,
                                                  const scene::Chamber& chamber);

}  // namespace mahlwerk::soft
