// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::results {

// Which there are depends on what the case asks for, not on what ran it.

/// What the mill draws and dissipates, and the time in lasting contact.
std::vector<Measure> power_measures();
/// Where the soft engine's power goes. Their sum is the dissipated power.
std::vector<Measure> loss_measures(const cases::Case& what);
/// How far an event run rests on the TC rule (man.8).
std::vector<Measure> contact_time_measures(const cases::Case& what);

}  // namespace mahlwerk::results
