// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "mahlwerk/event/moving_wall.hpp"
#include "mahlwerk/event/rules.hpp"
#include "mahlwerk/scene/chamber.hpp"
#include "mahlwerk/scene/engine.hpp"

namespace mahlwerk::event {

// Explicitly instantiated for each shape in a file of its own (engine_capsule.cpp and so on), so
// that the shapes compile in parallel.

template <class S>
std::unique_ptr<scene::Engine> one_ball_in(const S& shape, const scene::Chamber& chamber,
                                           const scene::Ball& ball, const Rules& rules,
                                           double start);
template <class S>
std::unique_ptr<const MovingWall> moving_wall_of(const S& shape, const scene::Chamber& chamber);

}  // namespace mahlwerk::event
