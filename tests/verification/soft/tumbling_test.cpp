// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Free rotation of a body with three different moments of inertia: Euler's equations.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "bodies.hpp"
#include "mahlwerk/soft/kernel/rigid_body.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::soft_tumbling_test {
namespace {

using contact::HertzMindlin;
constexpr double density = 2500;
constexpr contact::ElasticConstants glass{1e8, 0.25};

/// Four spheres of 5 mm, as an L with one beside it.
scene::Solid crooked() {
  constexpr double d = 0.006;
  const std::array<geometry::MemberSphere, 4> all{
      {{{0, 0, 0}, 0.005}, {{d, 0, 0}, 0.005}, {{2 * d, 0, 0}, 0.005}, {{0, d, 0}, 0.005}}};
  return scene::clump(all);
}

/// The arithmetic-geometric mean.
double mean_of(double a, double b) {
  for (int k = 0; k < 40; ++k) {
    const double next = 0.5 * (a + b);
    b = std::sqrt(a * b), a = next;
  }
  return a;
}

/// [s] Period of the spin along the principal axes (Landau and Lifshitz, Mechanics, section 37).
double jacobi_period(std::array<double, 3> inertia, double energy, double momentum) {
  std::ranges::sort(inertia);
  auto [a, b, c] = inertia;
  const double squared = momentum * momentum;
  if (squared < 2 * energy * b) std::swap(a, c);
  const double m = (b - a) * (2 * energy * c - squared) / ((c - b) * (squared - 2 * energy * a));
  const double quarter = 0.5 * std::numbers::pi / mean_of(1, std::sqrt(1 - m));  // K(m)
  return 4 * quarter / std::sqrt((c - b) * (squared - 2 * energy * a) / (a * b * c));
}

TEST(Tumbling, asymmetric_body_keeps_energy_and_angular_momentum_over_a_million_steps) {
  const scene::Solid solid = crooked();
  scene::Ball ball = body_of(solid, density);
  const Vec3 inertia = inertia_of(solid, density);
  ball.spin = {20, 150, 30};
  const double dt = 1e-5;  // 4000 steps a turn
  const auto engine = body_engine(still_box(1), {ball}, solid, of_law(HertzMindlin{}),
                                  pair_of(glass, glass, 0.9), dt);
  const double energy = rotation_energy(ball, inertia);
  const Vec3 momentum = angular_momentum(ball, inertia);
  Recorder none;
  double swing = 0, turned = 0, unit = 0;
  for (int k = 1; k <= 1000; ++k) {
    engine->advance(1000 * k * dt, none);
    const scene::Ball now = engine->balls()[0];
    swing = max_or_nan(swing, std::abs(rotation_energy(now, inertia) / energy - 1));
    turned = max_or_nan(turned, norm(angular_momentum(now, inertia) - momentum) / norm(momentum));
    unit = max_or_nan(unit, std::abs(squared(now.orientation) - 1));
  }
  // The energy swings with (w dt)^2/12 = 2e-7 and does not drift.
  stays_below("energy over 1e6 steps, relative", swing, 5e-7, "(w dt)^2/12, bod.10");
  stays_below("angular momentum over 1e6 steps, relative", turned, 1e-12, "rounding, bod.10");
  stays_below("|q|^2 - 1", unit, 1e-15, "normalised in each step");
  stays_below("energy balance over the energy",
              std::abs(engine->energy_balance().residual()) / energy, 5e-7, "energy balance");
}

TEST(Tumbling, spin_has_the_period_of_jacobis_elliptic_functions) {
  const scene::Solid solid = crooked();
  const Vec3 inertia = inertia_of(solid, density);
  const Vec3 inverse{1 / inertia.x, 1 / inertia.y, 1 / inertia.z};
  for (const Vec3& spin : {Vec3{150, 40, 30}, Vec3{30, 40, 150}, Vec3{5, 150, 3}}) {
    Quaternion q;
    const Vec3 momentum{inertia.x * spin.x, inertia.y * spin.y, inertia.z * spin.z};
    const double energy = 0.5 * dot(momentum, spin);
    const double period = jacobi_period({inertia.x, inertia.y, inertia.z}, energy, norm(momentum));
    constexpr int steps = 20000, turns = 20;
    for (int k = 0; k < turns * steps; ++k)
      q = soft::after_free_rotation(q, momentum, inverse, period / steps);
    const Vec3 found = soft::scaled_along_axes(rotation_of(q), inverse, momentum);
    const Vec3 along = rotation_of(q).apply_inverse(found);
    states(fmt::format("spin ({}, {}, {}) after 20 periods, error over the spin", spin.x, spin.y,
                       spin.z),
           norm(along - spin) / norm(spin), 0, 1e-4, "Jacobi");
  }
}

TEST(Tumbling, error_of_the_orientation_falls_with_the_square_of_the_step) {
  const scene::Solid solid = crooked();
  const Vec3 inertia = inertia_of(solid, density);
  const Vec3 inverse{1 / inertia.x, 1 / inertia.y, 1 / inertia.z};
  const Vec3 momentum{40 * inertia.x, 90 * inertia.y, 60 * inertia.z};
  const auto after = [&](int steps) {
    Quaternion q;
    for (int k = 0; k < steps; ++k)
      q = soft::after_free_rotation(q, momentum, inverse, 0.1 / steps);
    return q;
  };
  const Quaternion exact = after(1 << 20);
  const auto error = [&](int steps) {
    const Quaternion q = after(steps);
    return std::sqrt(
        squared(Quaternion{q.w - exact.w, q.x - exact.x, q.y - exact.y, q.z - exact.z}));
  };
  for (const int steps : {100, 200, 400, 800})
    states(fmt::format("error in {} steps over that in twice as many", steps),
           error(steps) / error(2 * steps), 4, 0.1, "second order");
}

}  // namespace
}  // namespace mahlwerk::tests::soft_tumbling_test
