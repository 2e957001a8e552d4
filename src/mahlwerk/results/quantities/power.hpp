// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::results {

/// What the mill draws and dissipates, and the time in lasting contact.
const std::vector<Measure>& power_measures();
/// Where the soft engine's power goes. Their sum is the dissipated power.
const std::vector<Measure>& loss_measures();
/// How far an event run rests on the TC rule (man.8).
const std::vector<Measure>& contact_time_measures();

}  // namespace mahlwerk::results
