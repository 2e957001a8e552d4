// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/quantities/measure.hpp"

// The groups of quantities that measures.cpp lists (docs/formats.md). Which a case has depends on
// what it asks for, not on what ran it; those of powder and wear stand with their tables.
namespace mahlwerk::results {

// collisions.cpp
std::vector<Measure> collision_rates();
/// With each other and with the jar, where there are several balls.
std::vector<Measure> collision_rates_by_partner(const cases::Case& what);
/// Means over all collisions, and over those above the threshold.
std::vector<Measure> collision_means();

// power.cpp
/// What the mill draws and dissipates, and the time in lasting contact.
std::vector<Measure> power_measures();
/// Where the soft engine's power goes. Their sum is the dissipated power.
std::vector<Measure> loss_measures(const cases::Case& what);
/// How far an event run rests on the TC rule (man.8).
std::vector<Measure> contact_time_measures(const cases::Case& what);

// milling.cpp
/// Impacts per ball, power of all jars, torque.
std::vector<Measure> mill_measures(const cases::Case& what);
/// Dose and stress of the powder; none without [powder].
std::vector<Measure> dose_measures(const cases::Case& what);
/// Where the dissipated energy is: in finished collisions, in contacts that go on, in lasting ones.
std::vector<Measure> energy_balance_measures();

// motion.cpp
/// Occupied share of the jar's cross-section, of tumbling and planetary mills, and the balls'
/// speeds (obs.9).
std::vector<Measure> motion_measures(const cases::Case& what);
/// Energy of the motion across the normal, in a collision and in a second, and the share of grazing
/// impacts.
std::vector<Measure> tangential_measures();

// checks.cpp
/// Of powder as grains: the same in every replicate.
std::vector<Measure> grain_measures(const cases::Case& what);
/// What says how exact a run was.
std::vector<Measure> check_measures();

}  // namespace mahlwerk::results
