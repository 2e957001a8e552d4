// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "mahlwerk/contact/bounce_table.hpp"
#include "mahlwerk/event/rules.hpp"
#include "mahlwerk/scene/chamber.hpp"
#include "mahlwerk/scene/engine.hpp"

namespace mahlwerk::event {

/// Creates the event engine for one ball, for any registered jar shape and motion. `start` [s] is
/// the mill time at which the run begins. The ball must lie inside the jar. Throws InputError for a
/// shape without exact touch times.
std::unique_ptr<scene::Engine> one_ball(const scene::Chamber& chamber, const scene::Ball& ball,
                                        const Rules& rules, double start = 0);

/// Creates the event engine for any number of balls, which must lie inside the jar and must not
/// overlap. `bounces` holds the collision rules between ball kinds (`Ball::kind`) and of each kind
/// with each face of the jar. `rules` says how sustained contacts are treated: by the TC rule or
/// not at all. `start` [s] is the mill time at which the run begins. Throws InputError for a shape
/// without exact touch times, and for a periodic box too small for the balls.
std::unique_ptr<scene::Engine> many_balls(const scene::Chamber& chamber,
                                          const std::vector<scene::Ball>& balls, const Rules& rules,
                                          const contact::BounceTable& bounces, double start = 0);

}  // namespace mahlwerk::event
