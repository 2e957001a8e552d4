// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/contact/bounce.hpp"
#include "mahlwerk/event/rules.hpp"

namespace mahlwerk::event {

/// The Zeno guard's message: at `time` [s] since the start `events` took place within `within` [s].
/// Its remedy is one that `lasting`, the treatment in force, does not contain.
RunError zeno_error(double time, double within, std::int64_t events, SustainedContactMode lasting);

/// Throws RunError if a collision gained energy, which no rule of the engine does: an error of the
/// program. `mass` [kg], `approach` and `slip` [m/s] of the collision, `time` [s] since the start.
void reject_energy_gain(const contact::Loss& loss, double mass, double approach, double slip,
                        double time);

}  // namespace mahlwerk::event
