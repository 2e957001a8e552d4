// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <numbers>
#include <span>

#include "mahlwerk/geometry/cylinder.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/kinematics/planetary.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "peers_physics.hpp"

// Five steel balls of 15 mm in a planetary mill, for comparison with other open soft-sphere codes.
namespace mahlwerk::bench {

/// Parameters of every run and every code. The vial stands upright.
struct PlanetaryCase {
  kinematics::Planetary mill{0.07, 400.0 / 60 * 2 * std::numbers::pi, -2};
  geometry::Cylinder vial{0.042, 0.03248};
  double diameter = 0.015;         // [m] of a ball
  double density = 7700;           // [kg/m3]
  double youngs_modulus = 208e9;   // [Pa] of balls and vial
  double poissons_ratio = 0.3;     // [1]
  double restitution = 0.35;       // [1] ball on vial, ball on ball
  double friction = 0.5;           // [1]
  double rolling_friction = 0.05;  // [1]
  double gravity = 9.81;           // [m/s2] along -z
  double step = 1e-6;              // [s]
  double from = 0.1, to = 1.0;     // [s] the window of the physics
  double between_samples = 1e-5;   // [s]

  scene::Ball ball(const Vec3& position) const {
    return {diameter / 2, density, position, cross({0, 0, mill.jar_spin()}, position), {}, 0};
  }
};
inline constexpr PlanetaryCase planetary_case;

/// Initial state of the balls in the jar frame: at rest in the rotating vial, without spin.
using Start = std::array<scene::Ball, 5>;

/// Replicate 0 is the start of the case. In the others each ball is displaced by up to 0.1 mm.
Start start(int replicate);

/// Ball-steps per second of CPU time of Mahlwerk's soft engine on one core: replicates from the
/// given starts side by side, each over `steps` steps.
double mahlwerk_speed(std::span<const Start> starts, int steps);
Physics mahlwerk_physics(const Start& start);

}  // namespace mahlwerk::bench
