// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The event engine for many balls compared with the simple reference engine (PlainSwarm): the same
// collisions in the same order, as long as rounding errors allow the comparison.
#include "plain_swarm.hpp"

#include <gtest/gtest.h>

#include "mahlwerk/event/collision_prediction.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "many_balls.hpp"
#include "one_ball.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::plain_swarm_test {
namespace {

constexpr int wanted = 40;  // collisions

/// Balls of several sizes at random free positions, with random velocities and spins.
std::vector<scene::Ball> mixed(const scene::Chamber& chamber, int count, double size, double speed,
                               std::uint64_t seed) {
  Random random(seed, 0);
  std::vector<scene::Ball> balls;
  const double reach = geometry::reach(*chamber.shape);
  const Vec3 periods =
      std::visit([](const auto& s) { return geometry::periods_of(s); }, *chamber.shape);
  const Rotation turn = kinematics::rotation(*chamber.motion, 0) * chamber.mount;
  const auto fits = [&](const scene::Ball& b) {
    const Vec3 own = turn.apply_inverse(b.position);
    const Vec3 out = componentwise_abs(own) - 0.5 * periods;
    if (std::max({out.x, out.y, out.z}) > 0) return false;
    bool free = std::visit(
        [&](const auto& s) {
          for (int face = 0; face < s.faces; ++face)
            if (s.can_touch(face, b.radius) && s.gap(face, own).distance < 1.01 * b.radius)
              return false;
          return true;
        },
        *chamber.shape);
    for (const scene::Ball& other : balls) {
      Vec3 r = b.position - other.position;
      if (periods.x < geometry::never) r = event::nearest_image(r, periods);
      free = free && norm(r) > 1.01 * (b.radius + other.radius);
    }
    return free;
  };
  for (int tries = 0; tries < 1'000'000 && std::ssize(balls) < count; ++tries) {
    scene::Ball b{
        size * std::pow(2.0, static_cast<double>(balls.size() % 3)) / 4, 7850, {}, {}, {}};
    b.position = {random.uniform(-reach, reach), random.uniform(-reach, reach),
                  random.uniform(-reach, reach)};
    b.velocity = random.uniform(0, speed) * random.direction();
    b.spin = random.uniform(0, speed / b.radius) * random.direction();
    if (fits(b)) balls.push_back(b);
  }
  return balls;
}

void hold_side_by_side(const std::string& what, const scene::Chamber& chamber,
                       const std::vector<scene::Ball>& balls, const contact::BounceRule& rule,
                       int enough) {
  SCOPED_TRACE(what);
  const double size = geometry::reach(*chamber.shape);
  const int faces = geometry::faces(*chamber.shape);
  // Error of the engine's touches: the margin of its search (evt.5), or rounding of positions.
  const double noise = 1e-12 * balls.front().radius + 64 * 0x1p-52 * size;
  PlainSwarm plain(chamber, balls, rule);
  std::vector<PlainSwarm> noisy;
  for (std::uint64_t i = 1; i <= 4; ++i) noisy.emplace_back(chamber, balls, rule, noise, i);

  event::Rules rules;
  rules.sustained_mode = event::SustainedContactMode::none;
  const auto engine = event::many_balls(chamber, balls, rules, {1, faces, rule});
  Recorder seen;
  double late = 0, fast = 0, worst = 0;
  int k = 0;
  for (; k < wanted; ++k) {
    const PlainSwarm::Bounce expected = plain.next();
    bool same = true;
    for (PlainSwarm& p : noisy) {
      const PlainSwarm::Bounce b = p.next();
      same = same && b.ball == expected.ball && b.other == expected.other;
      late = max_or_nan(late, std::abs(b.time - expected.time));
      fast = max_or_nan(fast, std::abs(b.approach - expected.approach));
    }
    if (!same || late > 1e-6 * expected.time) break;  // chaos has amplified rounding too far
    for (int i = 0; std::ssize(seen.all) <= k && i < 60; ++i)
      engine->advance(expected.time + late * 100 + 1e-9 * std::pow(2, i), seen);
    ASSERT_GT(std::ssize(seen.all), k) << "collision " << k << " at " << expected.time;
    const scene::Collision& found = seen.all[static_cast<std::size_t>(k)];
    ASSERT_EQ(found.ball, expected.ball) << "collision " << k << " at " << expected.time;
    ASSERT_EQ(found.other, expected.other) << "collision " << k << " at " << expected.time;
    worst = std::max(
        {worst, std::abs(found.time - expected.time) / (late + 0x1p-52 * expected.time),
         std::abs(found.approach - expected.approach) / (fast + 1e-15 * expected.approach)});
  }
  EXPECT_GE(k, enough) << "too few to tell";
  // Four runs with noise estimate how errors grow. Another run may deviate some times more.
  stays_below(what + ": off by, over what noise does, of " + std::to_string(k), worst, 30,
              "plain engine with noise of the margin after each collision");
}

const contact::BounceRule rough{0.95, 0.3, 0.2};
const Vec3 down{0, 0, -gravity};

std::vector<std::pair<std::string, geometry::AnyShape>> shapes() {
  return {{"sphere", geometry::Sphere{0.05}},
          {"capsule", geometry::Capsule{0.04, 0.03}},
          {"cylinder", geometry::Cylinder{0.05, 0.04}},
          {"rounded cylinder", geometry::RoundedCylinder{0.05, 0.04, 0.012}},
          {"box", geometry::Box{0.04, 0.05, 0.06}}};
}

void in_all_shapes(const std::string& mill, const kinematics::AnyMotion& motion,
                   const Rotation& mount, double speed) {
  for (const auto& [name, shape] : shapes())
    for (const int count : {2, 7, 20}) {
      const scene::Chamber chamber{shape, motion, mount, down};
      const auto balls = mixed(chamber, count, count > 7 ? 0.006 : 0.01, speed, 5);
      ASSERT_EQ(std::ssize(balls), count);
      hold_side_by_side(name + ", " + mill + ", " + std::to_string(count), chamber, balls, rough,
                        30);
    }
}

TEST(PlainSwarm, and_engine_see_the_same_collisions_in_still_jars) {
  in_all_shapes("still", kinematics::Still{}, scene::mounted_along({0.6, 0, 0.8}), 2);
}
TEST(PlainSwarm, and_engine_see_the_same_collisions_in_shaken_jars) {
  in_all_shapes("shaken", shaken(20, 0.015), {}, 0.5);
}
TEST(PlainSwarm, and_engine_see_the_same_collisions_in_planetary_jars) {
  in_all_shapes("planetary", kinematics::Planetary{.orbit_radius = 0.07, .speed = 40, .ratio = -2},
                {}, 1);
}
TEST(PlainSwarm, and_engine_see_the_same_collisions_in_drums) {
  in_all_shapes("drum", kinematics::Tumbling{12}, scene::mounted_along({1, 0, 0}), 1);
}

/// Boxes so small that two balls collide from both sides of the box, and long thin boxes.
TEST(PlainSwarm, and_engine_see_the_same_collisions_in_periodic_boxes) {
  for (const Vec3& side : {Vec3{2.05, 2.05, 2.05}, Vec3{2.5, 2.9, 3.3}, Vec3{3.5, 4.5, 5.5},
                           Vec3{9, 9, 9}, Vec3{30, 2.1, 2.1}})
    for (const int count : {2, 4, 12}) {
      const scene::Chamber chamber{
          geometry::PeriodicBox{side.x, side.y, side.z}, kinematics::Still{}, {}, {}};
      const double size = side.x < 3 && count > 4 ? 0.5 : 1;  // the largest diameter
      const auto balls = mixed(chamber, count, size / 2, 1, 6);
      ASSERT_EQ(std::ssize(balls), count);
      hold_side_by_side("periodic " + std::to_string(side.x) + " x " + std::to_string(side.y) +
                            ", " + std::to_string(count),
                        chamber, balls, {1, 0, INFINITY}, 3);
    }
}

}  // namespace
}  // namespace mahlwerk::tests::plain_swarm_test
