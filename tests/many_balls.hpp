// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/event/engine.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "statement.hpp"

// Charges shared by the tests of many balls.
namespace mahlwerk::tests {

/// Counts collisions without storing them.
struct Counter final : scene::Observer {
  std::int64_t count = 0;
  void collisions(std::span<const scene::Collision> finished) override {
    count += std::ssize(finished);
  }
};

/// n^3 smooth balls of diameter and mass 1 on a lattice in a periodic box, with random velocities
/// of mean 0 and rms speed 1. If `rough`, the balls have random spins of matching magnitude.
inline std::vector<scene::Ball> lattice(int n, double packing, bool rough = false,
                                        std::uint64_t seed = 1) {
  const int count = n * n * n;
  const double side = std::cbrt(count * std::numbers::pi / 6 / packing), step = side / n;
  Random random(seed, 0);
  std::vector<scene::Ball> balls;
  Vec3 mean{};
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const Vec3 cell{static_cast<double>(i % n), static_cast<double>(i / n % n),
                    static_cast<double>(i / n / n)};
    const Vec3 place = step * (cell + Vec3{0.5, 0.5, 0.5}) - 0.5 * side * Vec3{1, 1, 1};
    // One draw a statement: compilers evaluate the operands of a product in different orders.
    const Vec3 heading = random.direction();
    const Vec3 velocity = random.uniform(0, 2) * heading;
    const Vec3 axis = rough ? random.direction() : Vec3{};
    const Vec3 spin = rough ? random.uniform(0, 4) * axis : Vec3{};
    balls.push_back({0.5, 6 / std::numbers::pi, place, velocity, spin});
    mean += velocity / count;
  }
  for (scene::Ball& b : balls) {
    b.velocity -= mean;
    sum += squared(b.velocity) / count;
  }
  for (scene::Ball& b : balls) b.velocity *= 1 / std::sqrt(sum);
  return balls;
}

inline double side_of(int n, double packing) {
  return std::cbrt(n * n * n * std::numbers::pi / 6 / packing);
}

inline std::unique_ptr<scene::Engine> gas(const std::vector<scene::Ball>& balls, double side,
                                          const contact::BounceRule& rule) {
  event::Rules rules;
  rules.sustained_mode = event::SustainedContactMode::none;
  const scene::Chamber box{geometry::PeriodicBox{side, side, side}, kinematics::Still{}, {}, {}};
  return event::many_balls(box, balls, rules, {1, 0, rule});
}

/// Largest overlap of two balls over the radius of the smaller one. `side` is the edge of a
/// periodic box, infinite without one.
inline double deepest_overlap(const std::vector<scene::Ball>& balls, double side = INFINITY) {
  double deepest = -INFINITY;
  const auto fold = [&](double x) {
    return std::isfinite(side) ? x - side * std::rint(x / side) : x;
  };
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t j = i + 1; j < balls.size(); ++j) {
      const Vec3 r = balls[i].position - balls[j].position;
      const double gap =
          norm(Vec3{fold(r.x), fold(r.y), fold(r.z)}) - balls[i].radius - balls[j].radius;
      deepest = max_or_nan(deepest, -gap / std::min(balls[i].radius, balls[j].radius));
    }
  return deepest;
}

}  // namespace mahlwerk::tests
