// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "mahlwerk/scene/body_shape.hpp"
#include "soft.hpp"

// Bodies that are no spheres, shared by the tests of the soft engine.
namespace mahlwerk::tests {

/// A body of `solid` at rest.
inline scene::Ball body_of(const scene::Solid& solid, double density, const Vec3& position = {},
                           const Quaternion& orientation = {}) {
  scene::Ball ball{solid.equivalent_radius(), density, position, {}, {}};
  ball.inertia_ratio = solid.shape().mean_inertia_ratio();
  ball.orientation = orientation;
  return ball;
}

/// [kg m2] Principal moments of inertia.
inline Vec3 inertia_of(const scene::Solid& solid, double density) {
  return density * solid.inertia;
}

/// A turn by `angle` [rad] about the unit vector `axis`.
inline Quaternion turned_about(const Vec3& axis, double angle) {
  const double s = std::sin(0.5 * angle);
  return {std::cos(0.5 * angle), s * axis.x, s * axis.y, s * axis.z};
}

/// [kg m2/s] Angular momentum about the centre of mass, in laboratory axes.
inline Vec3 angular_momentum(const scene::Ball& b, const Vec3& inertia) {
  const Rotation axes = rotation_of(b.orientation);
  const Vec3 w = axes.apply_inverse(b.spin);
  return axes * Vec3{inertia.x * w.x, inertia.y * w.y, inertia.z * w.z};
}
/// [J] Energy of the rotation.
inline double rotation_energy(const scene::Ball& b, const Vec3& inertia) {
  return 0.5 * dot(b.spin, angular_momentum(b, inertia));
}

/// An engine whose balls have the shape of `solid`; all contacts have the parameters `pair`.
inline std::unique_ptr<scene::Engine> body_engine(
    const scene::Chamber& chamber, const std::vector<scene::Ball>& balls, const scene::Solid& solid,
    const contact::ContactModel& model, const contact::Pair& pair, double step, int threads = 1) {
  soft::Settings settings{model, step, false};
  settings.shapes = {solid.shape()};
  settings.threads = threads;
  const int faces = geometry::faces(*chamber.shape);
  return soft::make_engine(chamber, balls, settings, contact::PairTable(1, faces, pair));
}

/// [s] The recommended step for collisions at `speed` [m/s].
inline double body_step(const std::vector<scene::Ball>& balls, const scene::Solid& solid,
                        const contact::AnyLaw& law, const contact::Pair& pair, double speed,
                        double steps = 50) {
  return soft::time_steps(balls, law, contact::PairTable(2, 6, pair), speed, std::nullopt,
                          {solid.shape()})
      .recommended(0.25, steps);
}

}  // namespace mahlwerk::tests
