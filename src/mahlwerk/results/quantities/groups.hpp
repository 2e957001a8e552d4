// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/quantities/measure.hpp"

// The groups of quantities that measures.cpp lists (docs/formats.md). The case decides which of
// them a result has. Quantities of powder and wear are declared beside their tables.
namespace mahlwerk::results {

// collisions.cpp
std::vector<Measure> collision_rates();
/// Collision rates between balls and with the jar; empty for a single ball.
std::vector<Measure> collision_rates_by_partner(const cases::Case& mill_case);
/// Means over all collisions, and over those above the threshold.
std::vector<Measure> collision_means();

// power.cpp
/// Drawn and dissipated power, and the time in sustained contact.
std::vector<Measure> power_measures();
/// Dissipated power by mechanism (soft engine). Normal, tangential and rolling power sum to the
/// dissipated power; sliding power is part of the tangential one.
std::vector<Measure> loss_measures(const cases::Case& mill_case);
/// Influence of the TC rule on an event run (man.8).
std::vector<Measure> contact_time_measures(const cases::Case& mill_case);

// milling.cpp
/// Impacts per ball, power of all jars, torque.
std::vector<Measure> mill_measures(const cases::Case& mill_case);
/// Dose and stress of the powder; empty without [powder].
std::vector<Measure> dose_measures(const cases::Case& mill_case);
/// Dissipated power of finished collisions, and of sustained and unfinished contacts (obs.3).
std::vector<Measure> energy_balance_measures();

// motion.cpp
/// Occupied share of the jar's cross-section (tumbling and planetary mills) and root mean square
/// speeds of the balls (obs.9).
std::vector<Measure> motion_measures(const cases::Case& mill_case);
/// Tangential impact energy per collision and per second, and the share of grazing impacts.
std::vector<Measure> tangential_measures();

// checks.cpp
/// Numbers of powder as grains, the same in every replicate.
std::vector<Measure> grain_measures(const cases::Case& mill_case);
/// Checks of a run's accuracy: energy residuals and the deepest overlap.
std::vector<Measure> check_measures();

}  // namespace mahlwerk::results
