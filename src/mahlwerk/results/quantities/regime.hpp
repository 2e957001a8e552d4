// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/results/quantities/measure.hpp"

// How the charge of a tumbling or planetary mill moves, by what was measured of it (obs.8).
namespace mahlwerk::results {

/// Flight share, toe and shoulder, spread, slip, pinning; none for other mills.
std::vector<Measure> regime_measures(const cases::Case& what);

/// "cascading", "cataracting", "centrifuging" (of a drum), "rolling" (of a planetary mill); empty
/// for other mills or before anything was seen.
std::string regime(const Outcome& outcome);

/// The numbers it rests on, in a sentence, where there is a regime.
std::string regime_reason(const Outcome& outcome);

}  // namespace mahlwerk::results
