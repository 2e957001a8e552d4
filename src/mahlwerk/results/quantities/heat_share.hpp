// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::results {

/// [1] Share of the dissipated power that heats the balls first: [heat] share_in_balls, else by the
/// collisions of the replicate, all of what they lose between balls and half of the rest (hea.12).
double heat_share_in_balls(const cases::Case& c, const Replicate& r);

}  // namespace mahlwerk::results
