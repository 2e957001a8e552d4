// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/wear_heat.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace mahlwerk::cases {
namespace {

/// A body of a colliding pair; a wall has infinite mass and radius.
struct Partner {
  double radius, mass, effusivity;
  contact::ElasticConstants elastic;
};

double effusivity_of(const Substance& s, double density) {
  return powder::effusivity(s.conductivity, density, s.heat_capacity);
}

Partner ball_of(const BallSet& set) {
  return {0.5 * set.diameter, set.mass(), effusivity_of(set.substance, set.surface_density()),
          set.elastic};
}

powder::FlashPair pair_of(const Partner& one, const Partner& other) {
  return {.radius = 1 / (1 / one.radius + 1 / other.radius),
          .mass = 1 / (1 / one.mass + 1 / other.mass),
          .modulus = contact::effective_modulus(one.elastic, other.elastic),
          .effusivity = one.effusivity,
          .other_effusivity = other.effusivity};
}

}  // namespace

double sliding_friction(const Case& c, const contact::BounceRule& rule) {
  return std::isfinite(rule.friction) ? rule.friction : c.contact.lasting_friction;
}

powder::FlashPair flash_pair(const Case& c, std::size_t set, std::size_t other) {
  return pair_of(ball_of(c.balls[set]), ball_of(c.balls[other]));
}

powder::FlashPair flash_pair_with_jar(const Case& c, std::size_t set) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  return pair_of(ball_of(c.balls[set]),
                 {endless, endless, effusivity_of(c.jar.substance, c.jar.density), c.jar.elastic});
}

double balls_surface(const Case& c) {
  double area = 0;
  for (const BallSet& set : c.balls) {
    if (set.grains) continue;
    for (const SizeClass& size : set.sizes())
      area += static_cast<double>(size.count) * std::numbers::pi * size.diameter * size.diameter;
  }
  return area;
}

double jar_mass(const Case& c, double wall_area) {
  return wall_area * c.jar.wall * c.jar.density;
}

powder::HeatNodes heat_nodes(const Case& c, double wall_area) {
  double balls = 0;
  for (const BallSet& set : c.balls)
    if (!set.grains)
      balls += static_cast<double>(set.count) * set.mass() * set.substance.heat_capacity;
  return {.balls_capacity = balls,
          .jar_capacity = jar_mass(c, wall_area) * c.jar.substance.heat_capacity,
          .exchange = c.heat->ball_exchange * balls_surface(c),
          .cooling = c.heat->cooling * wall_area};
}

powder::MillCycles mill_cycles(const Case& c, double power, double in_balls) {
  return {.power = power,
          .share = in_balls,
          .ambient = c.heat->ambient,
          .milling = c.heat->milling,
          .pause = c.heat->pause,
          .cycles = c.heat->cycles};
}

}  // namespace mahlwerk::cases
