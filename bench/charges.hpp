// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "benchmarks.hpp"
#include "mahlwerk/base/random.hpp"
#include "mahlwerk/event/engine.hpp"

// Shared code of the benchmarks with many balls.
namespace mahlwerk::bench {

struct Counter final : scene::Observer {
  std::int64_t count = 0;
  void collisions(std::span<const scene::Collision> finished) override {
    count += std::ssize(finished);
  }
};

/// Side [m] of the cube that n^3 balls of `diameter` [m] fill to `packing`.
inline double side_of(int n, double packing, double diameter) {
  return n * diameter * std::cbrt(std::numbers::pi / 6 / packing);
}

/// n^3 balls on a simple lattice in that cube, with random velocities of mean 0 up to `speed`
/// [m/s].
inline std::vector<scene::Ball> lattice(int n, double packing, double diameter, double density,
                                        double speed) {
  const double side = side_of(n, packing, diameter), step = side / n;
  Random random(1, 0);
  std::vector<scene::Ball> balls;
  Vec3 mean{};
  for (int i = 0; i < n * n * n; ++i) {
    const Vec3 cell{static_cast<double>(i % n), static_cast<double>(i / n % n),
                    static_cast<double>(i / n / n)};
    const Vec3 place = step * (cell + Vec3{0.5, 0.5, 0.5}) - 0.5 * side * Vec3{1, 1, 1};
    const Vec3 velocity = random.uniform(0, speed) * random.direction();
    mean += velocity / (n * n * n);
    balls.push_back({diameter / 2, density, place, velocity, {}});
  }
  for (scene::Ball& ball : balls) ball.velocity -= mean;
  return balls;
}

/// Collisions of an engine per CPU second, after a warm-up of a second or so: the median of five
/// intervals of about `work` [s]. `step` [s] is simulated between two readings of the clock.
inline double collisions_per_second(scene::Engine& engine, double step, double work) {
  Counter counter;
  double time = 0;
  std::vector<double> found;
  for (int i = 0; i < 6; ++i) {
    const std::int64_t before = counter.count;
    const double start = cpu_seconds();
    do engine.advance(time += step, counter);
    while (cpu_seconds() - start < work);
    const double speed = static_cast<double>(counter.count - before) / (cpu_seconds() - start);
    if (i > 0) found.push_back(speed);
  }
  return median(found);
}

/// Results of the fastest programs for this problem on such a machine: the best of EDMD's three,
/// and DynamO (docs/performance.md), for a packing of 0.20 or 0.49 and n = 10, 22 or 46.
struct Peers {
  int n;
  double packing, edmd, dynamo;
};
inline constexpr Peers peers[] = {
    {10, 0.20, 774e3, 104e3},  {22, 0.20, 715e3, 95e3},  {46, 0.20, 229e3, 50e3},
    {10, 0.49, 1155e3, 119e3}, {22, 0.49, 1043e3, 99e3}, {46, 0.49, 340e3, 61e3},
};

}  // namespace mahlwerk::bench
