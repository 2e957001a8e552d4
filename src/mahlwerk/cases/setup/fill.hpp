// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/cases/setup/obstacles.hpp"
#include "mahlwerk/scene/balls.hpp"

namespace mahlwerk::cases {

/// All balls of a case, set by set, at rest; positions in the jar's own axes. Sets with given
/// positions keep them. All other balls get random positions without contact, largest first, by
/// rejection sampling (random sequential addition). If that fails, overlapping random balls are
/// pushed apart by energy minimisation. Throws InputError "too-many-balls" if both fail,
/// Interrupted once `*stop` is set. With `up`, a unit vector in the jar's own axes, the sets lie in
/// layers: the first set lowest, each in a part of the jar in proportion to its volume of balls.
std::vector<scene::Ball> fill(const geometry::AnyShape& shape, const std::vector<BallSet>& sets,
                              Random& random, const std::atomic<bool>* stop = nullptr,
                              const Vec3* up = nullptr, const Obstacles* obstacles = nullptr);

}  // namespace mahlwerk::cases
