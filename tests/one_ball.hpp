// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/event/engine.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"

// Mills and balls shared by tests.
namespace mahlwerk::tests {

/// Keeps every collision.
struct Recorder final : scene::Observer {
  std::vector<scene::Collision> all;
  void collisions(std::span<const scene::Collision> finished) override {
    all.insert(all.end(), finished.begin(), finished.end());
  }
};

/// Gives an engine the state of another, of the same balls, by way of an archive.
inline void copy_state(scene::Engine& from, scene::Engine& to) {
  Archive out;
  from.serialize(out);
  Archive in(out.bytes());
  to.serialize(in);
  in.finish();
}

constexpr double gravity = 9.81;

/// The vial of Chen et al. 2016: 5 ml, capsule of diameter `dv` [m].
inline geometry::Capsule vial(double dv) {
  const double pi = std::numbers::pi;
  return {dv, (5e-6 - pi * dv * dv * dv / 6) / (pi * dv * dv / 4)};
}

/// The mill of Chen et al. 2016 with frequency `f` [Hz] and amplitude `a` [m].
inline kinematics::Vibration shaken(double f, double a) {
  kinematics::Vibration v;
  v.frequency = f;
  v.amplitude = a;
  return v;
}

inline scene::Chamber mill_a(double f = 10, double a = 0.025, double dv = 0.012) {
  return {vial(dv), shaken(f, a), {}, {0, 0, -gravity}};
}

/// The ball of Chen et al. 2016: 8 mm steel.
inline scene::Ball ball_a(const Vec3& position = {}, const Vec3& velocity = {},
                          const Vec3& spin = {}) {
  return {0.004, 7850, position, velocity, spin};
}

/// Constants of Chen et al. 2016: e_n = e_t = 0.9, no Coulomb limit in bounces.
inline event::Rules rules_a(double e = 0.9) {
  event::Rules rules;
  rules.bounce = {e, 0.9, INFINITY};
  rules.rolling_friction = 0.01;
  return rules;
}

}  // namespace mahlwerk::tests
