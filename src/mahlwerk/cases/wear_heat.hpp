// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/contact/bounce.hpp"
#include "mahlwerk/powder/flash.hpp"
#include "mahlwerk/powder/heat.hpp"

// What a case says of wear and heat, in the terms of the physics. Grains of the powder are no
// balls.
namespace mahlwerk::cases {

/// [1] The friction at which losses count as slid (wea.3): the rule's own limit, or that of lasting
/// contacts where bounces have none. 0 where nothing rubs.
double sliding_friction(const Case& c, const contact::BounceRule& rule);

/// Two balls of these sets, of the mean size of each, or a ball at the flat wall (hea.7). Moduli as
/// they are, whatever the softening.
powder::FlashPair flash_pair(const Case& c, std::size_t set, std::size_t other);
powder::FlashPair flash_pair_with_jar(const Case& c, std::size_t set);

double balls_surface(const Case& c);  ///< [m2] of all balls
/// [kg] of the jar, `wall_area` [m2] times thickness times density.
double jar_mass(const Case& c, double wall_area);

/// Of a case with [heat] (hea.3). `wall_area` [m2] > 0 is that of the jar's inner wall.
powder::HeatNodes heat_nodes(const Case& c, double wall_area);
/// Of a case with [heat], which loses `power` [W] while it mills.
powder::MillCycles mill_cycles(const Case& c, double power);

}  // namespace mahlwerk::cases
