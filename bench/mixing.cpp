// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Two layers of grains mix in a drum: case 2 of Dosta et al. 2024, which eight codes have run. The
// result is the number of small grains in a quarter of the drum, which falls and rises as the bed
// circulates.
#include <fmt/format.h>

#include <numbers>

#include "benchmarks.hpp"
#include "mahlwerk/base/random.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/soft/engine.hpp"

namespace mahlwerk::bench {
namespace {

constexpr double drum_radius = 0.1, drum_length = 0.06, drum_speed = 2;  // [m], [m], [rad/s]
/// Factor on every Young's modulus. Without it the run takes ten times as many steps.
constexpr double softening = 0.01;
constexpr double step = 1e-5;  // [s]: 0.12 of the Rayleigh time of the small grains
constexpr double settling = 0.4, mixing_time = 5, between = 0.1;  // [s]

enum Grain { small, large };

struct NullObserver final : scene::Observer {
  void collisions(std::span<const scene::Collision>) override {}
};

/// Adds a loose lattice of grains from `bottom` up, with small velocities that make the rows fall
/// apart. Returns the top of the layer.
double layer(std::vector<scene::Ball>& balls, int count, double radius, double density, int kind,
             double bottom) {
  Random random(1, static_cast<std::uint32_t>(kind));
  const double pitch = 2.05 * radius, room = drum_radius - 1.01 * radius;
  const double end = 0.5 * drum_length - 1.01 * radius;
  for (double z = bottom; count > 0; z += pitch) {
    const double across = room * room - z * z;
    bottom = z + pitch;
    if (across <= 0) continue;
    for (double y = -std::sqrt(across); y * y <= across && count > 0; y += pitch)
      for (double x = -end; x <= end && count > 0; x += pitch, --count)
        balls.push_back({radius, density, {x, y, z}, 0.1 * random.direction(), {}, kind});
  }
  return bottom;
}

std::unique_ptr<scene::Engine> engine(const std::vector<scene::Ball>& balls, double speed) {
  const auto pair = [](const contact::ElasticConstants& a, const contact::ElasticConstants& b,
                       double e, double mu) {
    return contact::Pair{.modulus = contact::effective_modulus(a, b),
                         .shear_modulus = contact::effective_shear_modulus(a, b),
                         .restitution = e,
                         .friction = mu,
                         .rolling_friction = 0};
  };
  const contact::ElasticConstants m1{softening * 1e9, 0.2}, m2{softening * 0.5e9, 0.2},
      steel{softening * 210e9, 0.2};
  contact::PairTable pairs(2, geometry::Cylinder::faces, pair(m1, m1, 0.5, 0.3));
  pairs.set_balls(small, large, pair(m1, m2, 0.45, 0.2));
  pairs.set_balls(large, large, pair(m2, m2, 0.4, 0.4));
  for (int face = 0; face < geometry::Cylinder::faces; ++face) {
    pairs.set_wall(small, face, pair(m1, steel, 0.4, 0.2));
    pairs.set_wall(large, face, pair(m2, steel, 0.4, 0.2));
  }
  soft::Settings rules;
  rules.model.rolling = contact::Rolling::none;
  rules.time_step = step;
  rules.max_initial_overlap = 0.1;
  rules.threads = 2;
  const scene::Chamber drum{geometry::Cylinder{2 * drum_radius, drum_length},
                            kinematics::Tumbling{speed},
                            scene::mounted_along({1, 0, 0}),
                            {0, 0, -9.81}};
  return soft::make_engine(drum, balls, rules, pairs, 0);
}

/// Number of small grains in the lower quarter on the side where the wall moves down.
double in_quarter(const scene::Engine& drum) {
  double count = 0;
  for (const scene::Ball& b : drum.balls())
    if (b.kind == small && b.position.y < 0 && b.position.z < 0) ++count;
  return count;
}

}  // namespace

std::vector<Row> mixing() {
  std::vector<scene::Ball> balls;
  const double top = layer(balls, 8000, 0.002, 2000, large, -drum_radius + 0.002);
  layer(balls, 30000, 0.001, 2500, small, top + 0.001);
  NullObserver observer;
  const auto rest = engine(balls, 0);
  rest->advance(settling, observer);
  const auto drum = engine(rest->balls(), drum_speed);
  std::vector<Row> rows;
  const double began = cpu_seconds();
  for (int k = 0; k * between < mixing_time + 0.5 * between; ++k) {
    drum->advance(k * between, observer);
    const double count = in_quarter(*drum);
    fmt::print(stderr, "mixing: {:.1f} s, {:.0f} small grains in the quarter\n", k * between,
               count);
    rows.push_back({"mixing", fmt::format("drum of Dosta et al. 2024, {:.1f} s", k * between),
                    "mahlwerk", "small_grains_in_quarter", count});
  }
  const scene::EnergyBalance a = drum->energy_balance();
  const std::string what = "drum of Dosta et al. 2024, whole run";
  rows.push_back({"mixing", what, "mahlwerk", "wall_work_J", a.wall_work});
  rows.push_back({"mixing", what, "mahlwerk", "lost_J", a.lost()});
  rows.push_back({"mixing", what, "mahlwerk", "residual_J", a.residual()});
  rows.push_back({"mixing", what, "mahlwerk", "cpu_s", cpu_seconds() - began});
  return rows;
}

}  // namespace mahlwerk::bench
