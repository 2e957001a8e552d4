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

/// The event engine for one ball in any registered jar on any registered motion. `start` [s] is the
/// mill's own time at which the run begins. The ball must lie inside the jar.
std::unique_ptr<scene::Engine> one_ball(const scene::Chamber& chamber, const scene::Ball& ball,
                                        const Rules& rules, double start = 0);

/// The event engine for any number of balls, which must lie inside the jar and apart. `bounces`
/// tells how balls of every kind (`Ball::kind`) meet each other and the jar's faces; `rules` how
/// lasting contacts are treated: by the TC rule or not at all.
std::unique_ptr<scene::Engine> many_balls(const scene::Chamber& chamber,
                                          const std::vector<scene::Ball>& balls, const Rules& rules,
                                          const contact::BounceTable& bounces, double start = 0);

}  // namespace mahlwerk::event
