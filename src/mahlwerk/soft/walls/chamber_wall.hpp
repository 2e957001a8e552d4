// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "mahlwerk/scene/chamber.hpp"
#include "mahlwerk/soft/walls/moving_wall.hpp"

namespace mahlwerk::soft {

/// The moving wall of a chamber of any shape and motion.
std::unique_ptr<const MovingWall> moving_wall(const scene::Chamber& chamber);

}  // namespace mahlwerk::soft
