// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/contact/bounce.hpp"
#include "mahlwerk/powder/flash.hpp"
#include "mahlwerk/powder/heat.hpp"

// Converts the sections on wear and heat of a case to the types of the physical models. Grains of
// the powder do not count as balls.
namespace mahlwerk::cases {

/// [1] Friction coefficient that converts sliding losses to a sliding distance (wea.3): that of the
/// rule, or of sustained contacts if bounces have no Coulomb limit. 0 without friction.
double sliding_friction(const Case& c, const contact::BounceRule& rule);

/// Pair of two balls of these sets, each of the mean size of its set, or of a ball and the flat
/// wall (hea.7). The moduli are not softened.
powder::FlashPair flash_pair(const Case& c, std::size_t set, std::size_t other);
powder::FlashPair flash_pair_with_jar(const Case& c, std::size_t set);

double balls_surface(const Case& c);  ///< [m2] of all balls
/// [kg] Mass of the jar: `wall_area` [m2] times thickness times density.
double jar_mass(const Case& c, double wall_area);

/// Heat capacities and heat transfer of a case with [heat] (hea.3). `wall_area` [m2] > 0 is the
/// area of the jar's inner wall.
powder::HeatNodes heat_nodes(const Case& c, double wall_area);
/// Milling cycles of a case with [heat] that dissipates `power` [W] during milling, of which the
/// share `in_balls` heats the balls first.
powder::MillCycles mill_cycles(const Case& c, double power, double in_balls);

}  // namespace mahlwerk::cases
