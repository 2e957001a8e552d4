// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/quantities/measure.hpp"

// What a mill's user asks of a run: power of the whole mill, torque, dose, stress
// (docs/formats.md).
namespace mahlwerk::results {

/// Impacts per ball, power of all jars, torque.
std::vector<Measure> mill_measures(const cases::Case& what);
/// Dose and stress of the powder; none without [powder].
std::vector<Measure> dose_measures(const cases::Case& what);
/// Where the dissipated energy is: in finished collisions, in contacts that go on, in lasting ones.
std::vector<Measure> ledger_measures();

}  // namespace mahlwerk::results
