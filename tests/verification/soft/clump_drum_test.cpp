// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A drum of cylpebs, as clumps and as rounded convex bodies: energy balance, threads, checkpoints.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bodies.hpp"
#include "mahlwerk/base/random.hpp"
#include "same_bits.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::soft_clump_drum_test {
namespace {

using contact::HertzMindlin;
constexpr double density = 7800, size = 0.01;
constexpr contact::ElasticConstants soft_steel{2e8, 0.3};

scene::Chamber drum() {
  return {geometry::Cylinder{0.14, 0.1},
          kinematics::Tumbling{8},
          scene::mounted_along(kinematics::Tumbling::jar_axis),
          {0, 0, -gravity}};
}

/// Cylpebs on a lattice, turned at random; with spheres among them as balls of a second kind.
std::vector<scene::Ball> charge(const scene::Solid& solid, bool mixed) {
  std::vector<scene::Ball> all;
  Random random(7, 0);
  const double gap = 0.0152, across = 0.14 / 2 - 0.0085, along = 0.1 / 2 - 0.008;
  for (double x = -along; x <= along; x += gap)
    for (double y = -across; y <= across; y += gap)
      for (double z = -across; z <= across; z += gap) {
        if (std::hypot(y, z) > across) continue;
        const Rotation axes = drum().mount;
        const Vec3 position = axes * Vec3{y, z, x};
        const Vec3 axis = random.direction();
        scene::Ball ball =
            body_of(solid, density, position, turned_about(axis, random.uniform(0, 3)));
        if (mixed && all.size() % 3 == 0) ball = {0.006, density, position, {}, {}, 1};
        all.push_back(ball);
      }
  return all;
}

contact::Pair pair() {
  return pair_of(soft_steel, soft_steel, 0.6, 0.4);
}

std::unique_ptr<scene::Engine> drum_engine(const scene::Solid& solid, int threads,
                                           bool mixed = false) {
  soft::Settings settings{of_law(HertzMindlin{}, contact::Rolling::epsd), 0, false};
  settings.shapes = {solid.shape()};
  settings.threads = threads;
  const auto balls = charge(solid, mixed);
  settings.time_step = body_step(balls, solid, HertzMindlin{}, pair(), 2, 20);
  return soft::make_engine(drum(), balls, settings, contact::PairTable(mixed ? 2 : 1, 3, pair()));
}

struct Charge {
  scene::Solid solid;
  bool mixed;  // with balls
};
std::vector<Charge> charges(int spheres) {
  std::vector<Charge> all;
  for (const bool mixed : {false, true}) {
    all.push_back({scene::cylinder_of_spheres(size, size, spheres), mixed});
    all.push_back({scene::rounded_cylinder(size, size, 0.1 * size), mixed});
  }
  return all;
}

TEST(ClumpDrum, energy_balance_closes) {
  for (const auto& [solid, mixed] : charges(30)) {
    const auto engine = drum_engine(solid, 1, mixed);
    Recorder hits;
    engine->advance(0.15, hits);
    const scene::EnergyBalance a = engine->energy_balance();
    EXPECT_GT(hits.all.size(), 500U);
    stays_below("residual over the energy turned over",
                std::abs(a.residual()) / (a.lost() + a.wall_work), 2e-3, "dem.32");
    double recorded = 0;
    for (const scene::Collision& hit : hits.all) recorded += hit.lost();
    states("losses in records and open contacts over all",
           (recorded + a.lost_open) / (a.lost() - a.lost_rolling), 1, 0.05,
           "records, rolling aside");
    stays_below("contact time over that of all balls",
                a.contact_time / (a.time * static_cast<double>(engine->balls().size())), 1,
                "by body");
    for (const scene::Ball& b : engine->balls())
      EXPECT_LT(std::hypot(dot(b.position, drum().mount.ex), dot(b.position, drum().mount.ey)),
                0.07);
  }
}

TEST(ClumpDrum, same_bits_on_one_and_two_threads) {
  for (const auto& [solid, mixed] : charges(20)) {
    const auto one = drum_engine(solid, 1, mixed), two = drum_engine(solid, 2, mixed);
    Recorder a, b;
    one->advance(0.05, a);
    two->advance(0.05, b);
    expect_same(a, b);
    expect_same(*one, *two);
    for (std::size_t k = 0; k < one->balls().size(); ++k)
      EXPECT_EQ(one->balls()[k].orientation, two->balls()[k].orientation);
  }
}

TEST(ClumpDrum, same_bits_after_a_cut_by_a_checkpoint) {
  for (const auto& [solid, mixed] : charges(20)) {
    const auto whole = drum_engine(solid, 1, mixed), first = drum_engine(solid, 1, mixed),
               second = drum_engine(solid, 2, mixed);
    Recorder a, b;
    whole->advance(0.05, a);
    first->advance(0.0213, b);
    copy_state(*first, *second);
    second->advance(0.05, b);
    expect_same(a, b);
    expect_same(*whole, *second);
  }
}

}  // namespace
}  // namespace mahlwerk::tests::soft_clump_drum_test
