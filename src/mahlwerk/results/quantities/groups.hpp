// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/quantities/measure.hpp"

// The groups of quantities that measures.cpp lists (docs/formats.md). The case decides which of
// them a result has. Quantities of powder and wear are declared beside their tables.
namespace mahlwerk::results {

// collisions.cpp
Measures collision_rates();
/// Collision rates between balls and with the jar, of several balls.
Measures collision_rates_by_partner();
/// Means over all collisions, and over those above the threshold.
Measures collision_means();

// power.cpp
/// Drawn and dissipated power, and the time in sustained contact.
Measures power_measures();
/// Dissipated power by mechanism (soft engine). Normal, tangential and rolling power sum to the
/// dissipated power; sliding power is part of the tangential one.
Measures loss_measures();
/// Influence of the TC rule on an event run (man.8).
Measures contact_time_measures();

// milling.cpp
/// Impacts per ball, power of all jars, torque.
Measures mill_measures();
/// Power of a tumbling mill per charge and length, and by the formulas of comminution
/// (mill_power.cpp).
Measures mill_power_measures();
/// Dose and stress of the powder.
Measures dose_measures();
/// Dissipated power of finished collisions, and of sustained and unfinished contacts (obs.3).
Measures energy_balance_measures();

// motion.cpp
/// Occupied share of the jar's cross-section (tumbling and planetary mills) and root mean square
/// speeds of the balls (obs.9).
Measures motion_measures();
/// Tangential impact energy per collision and per second, and the share of grazing impacts.
Measures tangential_measures();

// bodies.cpp
/// Hits of bodies that are no spheres by where on the body, and the order of their axes.
Measures body_measures();

// checks.cpp
/// Numbers of powder as grains, the same in every replicate.
Measures grain_measures();
/// Checks of a run's accuracy: energy residuals and the deepest overlap.
Measures check_measures();

}  // namespace mahlwerk::results
