// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "mahlwerk/event/rules.hpp"
#include "mahlwerk/scene/chamber.hpp"
#include "mahlwerk/scene/engine.hpp"

namespace mahlwerk::event {

/// The event engine for one ball in any registered jar on any registered motion. `start` [s] is the
/// mill's own time at which the run begins. The ball must lie inside the jar.
std::unique_ptr<scene::Engine> one_ball(const scene::Chamber& chamber, const scene::Ball& ball,
                                        const Rules& rules, double start = 0);

}  // namespace mahlwerk::event
