// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "meshes.hpp"
#include "soft.hpp"

// Balls in jars made of triangles, simulated by the soft engine.
namespace mahlwerk::tests {

inline const Vec3 down{0, 0, -gravity};
inline const Rotation lying = scene::mounted_along({1, 0, 0});

inline contact::Pair soft_pair(double e = 0.6, double mu = 0.3) {
  contact::Pair pair = pair_of({1e8, 0.3}, {1e8, 0.3}, e, mu);
  pair.rolling_friction = 0.02;
  return pair;
}

/// Balls at random positions in jar coordinates that touch neither the wall nor each other.
inline std::vector<scene::Ball> random_balls_in(const geometry::Mesh& mesh, int count,
                                                double radius, Random& random, double speed = 0.3) {
  std::vector<scene::Ball> balls;
  while (std::ssize(balls) < count) {
    const Vec3 p = random_point_in(mesh.extent(), random);
    bool free = true;
    mesh.near(p, 1.01 * radius, [&](int, const geometry::Gap&) { free = false; });
    for (const scene::Ball& b : balls) free = free && norm(b.position - p) > 2.01 * radius;
    if (free)
      balls.push_back({radius, 7850, p, speed * random.direction(), 10 * random.direction()});
  }
  return balls;
}

inline std::unique_ptr<scene::Engine> run_in(const geometry::AnyShape& shape,
                                             const kinematics::AnyMotion& motion,
                                             const Rotation& mount, std::vector<scene::Ball> balls,
                                             double step, std::size_t few = 32,
                                             const contact::Pair& pair = soft_pair()) {
  const scene::Chamber chamber{shape, motion, mount, down};
  for (scene::Ball& b : balls) b.position = mount * b.position;
  const int faces = geometry::faces(shape);
  soft::Settings rules{of_law(contact::HertzMindlin{}, contact::Rolling::cdt), step, false};
  rules.few_ball_limit = few;
  return soft::make_engine(chamber, balls, rules, contact::PairTable(1, faces, pair), 0);
}

}  // namespace mahlwerk::tests
