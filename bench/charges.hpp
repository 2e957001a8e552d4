// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <utility>
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
    const Vec3 heading = random.direction();  // one draw a statement, for all compilers
    const Vec3 velocity = random.uniform(0, speed) * heading;
    mean += velocity / (n * n * n);
    balls.push_back({diameter / 2, density, place, velocity, {}});
  }
  for (scene::Ball& ball : balls) ball.velocity -= mean;
  return balls;
}

/// The middle, least and largest of several values.
struct Spread {
  double middle, least, most;
};
inline Spread spread(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {median(values), *least, *most};
}

/// Times an engine in turns: each advances it for some CPU time. The first, the warm-up, is made
/// by the constructor.
class EngineTurns {
 public:
  /// `step` [s] is simulated between two readings of the clock; a turn takes about `work` [s].
  EngineTurns(std::unique_ptr<scene::Engine> engine, double step, double work)
      : engine_(std::move(engine)), step_(step), work_(work) {
    collisions_per_second();
  }
  double collisions_per_second() {
    const std::int64_t before = counter_.count;
    const double start = cpu_seconds();
    do engine_->advance(time_ += step_, counter_);
    while (cpu_seconds() - start < work_);
    return static_cast<double>(counter_.count - before) / (cpu_seconds() - start);
  }

 private:
  std::unique_ptr<scene::Engine> engine_;
  Counter counter_;
  double step_, work_, time_ = 0;
};

/// The cases of these benchmarks: n^3 balls at a packing.
struct ChargeCase {
  int n;
  double packing;

  int balls() const { return n * n * n; }
  std::string name() const { return fmt::format("packing {:.2f}, {} balls", packing, balls()); }
};
inline constexpr std::array charge_cases{
    ChargeCase{10, 0.20}, ChargeCase{22, 0.20}, ChargeCase{46, 0.20},
    ChargeCase{10, 0.49}, ChargeCase{22, 0.49}, ChargeCase{46, 0.49},
};

}  // namespace mahlwerk::bench
