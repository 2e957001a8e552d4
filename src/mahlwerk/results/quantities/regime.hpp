// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/results/quantities/measure.hpp"

// Regime of motion of the charge of a tumbling or planetary mill, by measured quantities (obs.8).
namespace mahlwerk::results {

/// Flight share, airborne share, toe and shoulder angles, emptiest sector, slip, lag,
/// intermittency, pinning; empty for other mills.
Measures regime_measures();
/// Whether the mill is one with regimes: a drum that turns under gravity, or a planetary mill.
bool has_regime(const cases::Case& mill_case);

/// "cascading", "cataracting", "slumping", "sliding", "surging", "rigid", "resting", "rolling on
/// the wall", "centrifuging" (of a drum), "rolling" (of a planetary mill), by the means over the
/// averaged replicates (regime_rule.hpp); of a lying jar that is shaken its states of motion
/// (motion_states.hpp); empty for other mills or without a counted time.
std::string regime(const Outcome& outcome);
/// The same for one replicate: modes of motion differ between replicates.
std::string regime(const cases::Case& mill_case, const Replicate& replicate);

/// [m/s] Root mean square speed of a field, weighted by mass; undefined without mass.
double root_mean_square_speed(const observe::PlaneField& field);
/// [m/s] That of a replicate's charge in the frame of the jar, and in that of its carrier.
double speed_in_jar(const Replicate& r);
double speed_in_carrier(const Replicate& r);

/// The quantities that decide the regime, in a sentence. Call only where there is a regime.
std::string regime_reason(const Outcome& outcome);

}  // namespace mahlwerk::results
