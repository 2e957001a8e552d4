// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The elastic periodic fluid that event-driven codes are measured by: equal smooth spheres, e = 1,
// no gravity, packing 0.20 and 0.49.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "benchmarks.hpp"
#include "mahlwerk/base/random.hpp"
#include "mahlwerk/event/engine.hpp"

namespace mahlwerk::bench {
namespace {

struct Counter final : scene::Observer {
  std::int64_t count = 0;
  void collisions(std::span<const scene::Collision> finished) override {
    count += std::ssize(finished);
  }
};

/// 4 n^3 or (simple lattice) n^3 balls of diameter 1 with random velocities.
std::unique_ptr<scene::Engine> fluid(int n, bool fcc, double packing) {
  const int count = n * n * n * (fcc ? 4 : 1);
  const double side = std::cbrt(count * std::numbers::pi / 6 / packing), step = side / n;
  Random random(1, 0);
  std::vector<scene::Ball> balls;
  const std::vector<Vec3> base =
      fcc ? std::vector<Vec3>{{0, 0, 0}, {.5, .5, 0}, {.5, 0, .5}, {0, .5, .5}}
          : std::vector<Vec3>{{0, 0, 0}};
  Vec3 mean{};
  for (int i = 0; i < n * n * n; ++i)
    for (const Vec3& b : base) {
      const Vec3 cell{static_cast<double>(i % n), static_cast<double>(i / n % n),
                      static_cast<double>(i / n / n)};
      Vec3 v;
      for (int k = 0; k < 6; ++k) v += random.direction();
      mean += v;
      balls.push_back({0.5,
                       6 / std::numbers::pi,
                       step * (cell + b) - 0.5 * side * Vec3{1, 1, 1} + 0.2 * step * Vec3{1, 1, 1},
                       v,
                       {}});
    }
  for (scene::Ball& b : balls) b.velocity -= mean / count;
  event::Rules rules;
  rules.lasting = event::Lasting::none;
  const scene::Chamber box{geometry::PeriodicBox{side, side, side}, kinematics::Still{}, {}, {}};
  return event::many_balls(box, balls, rules, {1, 0, {1, 1, INFINITY}});
}

double speed(scene::Engine& engine, double& time, double& guess) {
  // half a second or so of work
  Counter counter;
  const double start = cpu_seconds();
  do {
    time += guess;
    engine.advance(time, counter);
  } while (cpu_seconds() - start < 0.7);
  return static_cast<double>(counter.count) / (cpu_seconds() - start);
}

}  // namespace

std::vector<Row> fluid() {
  std::vector<Row> rows;
  for (const double packing : {0.20, 0.49})
    for (const int n : {10, 22, 46}) {
      const auto engine = fluid(n, false, packing);
      double time = 0, guess = 0.02;
      speed(*engine, time, guess);
      std::vector<double> found;
      for (int i = 0; i < 5; ++i) found.push_back(speed(*engine, time, guess));
      rows.push_back({"fluid", fmt::format("packing {}, {} balls", packing, n * n * n), "mahlwerk",
                      "collisions_per_cpu_second", median(found)});
    }
  return rows;
}

}  // namespace mahlwerk::bench
