// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Rounded convex bodies: contacts by the nearest points of their cores.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bodies.hpp"
#include "mahlwerk/base/random.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::soft_rounded_bodies_test {
namespace {

using contact::HertzMindlin;
constexpr double density = 7800, side = 0.4, pi = std::numbers::pi;
constexpr contact::ElasticConstants soft_steel{1e9, 0.3};

/// J = (1 + e) v/(1/m + r x n . I^-1 r x n) at the lowest corner of a cube, the lowest rim point of
/// a cylinder, the lower end of a rod, on a smooth floor.
TEST(RoundedBodies, hit_on_a_floor_gives_the_impulse_of_rigid_bodies) {
  const double speed = 0.1;
  const scene::Solid rod = scene::rounded_rod(0.01, 0.05), cube = scene::rounded_cube(0.02, 0.002),
                     cylinder = scene::rounded_cylinder(0.02, 0.03, 0.002);
  struct Case {
    const char* name;
    const scene::Solid& solid;
  };
  for (const Case& of : {Case{"rod", rod}, Case{"cube", cube}, Case{"cylinder", cylinder}})
    for (const double e : {0.4, 0.9})
      for (const double angle : {0.3, 1.1}) {
        const Quaternion q = turned_about({0.6, 0.8, 0}, angle) * turned_about({0, 0, 1}, 0.3);
        const Rotation axes = rotation_of(q);
        scene::Ball before = body_of(of.solid, density, {}, q);
        before.velocity = {0, 0, -speed};
        const Vec3 down = axes.apply_inverse({0, 0, -1});
        const Vec3 arm = axes * of.solid.core.support(down);  // to the sphere that touches
        before.position.z = -0.5 * side + of.solid.rounding - arm.z + 1e-6;
        const contact::Pair pair = pair_of(soft_steel, soft_steel, e);
        const double dt = body_step({before}, of.solid, HertzMindlin{}, pair, speed, 400);
        const auto engine =
            body_engine(still_box(side), {before}, of.solid, of_law(HertzMindlin{}), pair, dt);
        Recorder hits;
        for (int k = 1; k < 400 && hits.all.empty(); ++k) engine->advance(20 * k * dt, hits);
        ASSERT_EQ(hits.all.size(), 1U) << of.name;
        const Vec3 moment = cross(arm, Vec3{0, 0, 1}), own = axes.apply_inverse(moment);
        const Vec3 i = inertia_of(of.solid, density);
        const Vec3 turn = axes * Vec3{own.x / i.x, own.y / i.y, own.z / i.z};
        const double m = density * of.solid.volume, mass = 1 / (1 / m + dot(moment, turn));
        const double impulse = (1 + e) * mass * speed;
        const scene::Ball after = engine->balls()[0];
        const std::string what = fmt::format("{}, e = {}, angle {}: ", of.name, e, angle);
        states(what + "v' [m/s]", after.velocity.z, -speed + impulse / m, 3e-3 * speed,
               "impulse of rigid bodies; the body turns by less than 5e-3 in the contact");
        stays_below(what + "change of spin",
                    norm(after.spin - impulse * turn) / norm(impulse * turn), 0.01, "likewise");
        states(what + "effective mass of the record [kg]", hits.all[0].mass, mass, 1e-3 * mass,
               "bod.12");
        stays_below(what + "balance",
                    std::abs(engine->energy_balance().residual()) / hits.all[0].energy_normal(),
                    1e-3, "dem.32");
      }
}

/// Two bodies that meet without friction.
struct Impact {
  std::vector<scene::Ball> before, after;
  std::vector<scene::Collision> hits;
  double residual = 0;
};
Impact collide(const scene::Solid& solid, const Quaternion& a, const Quaternion& b,
               const Vec3& offset, const Vec3& velocity, double e, double time) {
  Impact m;
  m.before = {body_of(solid, density, {}, a), body_of(solid, density, offset, b)};
  m.before[1].velocity = velocity;
  const contact::Pair pair = pair_of(soft_steel, soft_steel, e);
  const double dt = body_step(m.before, solid, HertzMindlin{}, pair, norm(velocity), 400);
  const auto engine =
      body_engine(still_box(side), m.before, solid, of_law(HertzMindlin{}), pair, dt);
  Recorder hits;
  engine->advance(time, hits);
  m.after = engine->balls(), m.hits = hits.all;
  m.residual = engine->energy_balance().residual();
  return m;
}

/// Two rods that cross near their ends: the impulse acts along the shortest line between their
/// axes, and both turn away.
TEST(RoundedBodies, rods_that_cross_give_the_impulse_of_rigid_bodies) {
  const scene::Solid rod = scene::rounded_rod(0.01, 0.05);
  const double m = density * rod.volume, i = inertia_of(rod, density).x, speed = 0.1;
  const Quaternion along_x = turned_about({0, 1, 0}, pi / 2),
                   along_y = turned_about({1, 0, 0}, pi / 2);
  for (const double e : {0.5, 1.0})
    for (const double at : {0.0, 0.012}) {  // from both middles
      const Impact hit =
          collide(rod, along_x, along_y, {at, at, 0.01 + 1e-5}, {0, 0, -speed}, e, 1e-3);
      ASSERT_EQ(hit.hits.size(), 1U);
      const double mass = 1 / (2 / m + 2 * at * at / i);
      const std::string what = fmt::format("e = {}, {} m from the middle: ", e, at);
      states(what + "impulse [N s]", hit.hits[0].impulse, (1 + e) * mass * speed,
             2e-3 * mass * speed, "(1 + e) m* v");
      states(what + "v' of the first [m/s]", hit.after[0].velocity.z, -(1 + e) * mass * speed / m,
             2e-3 * speed, "impulse over its mass");
      states(what + "spin of the first [rad/s]", hit.after[0].spin.y,
             (1 + e) * mass * speed * at / i, 1e-2 * mass * speed * at / i + 1e-9, "moment over I");
      stays_below(what + "balance over the energy",
                  std::abs(hit.residual) / (0.5 * m * speed * speed), 1e-4, "dem.32");
    }
}

/// Impacts of cubes and of cylinders in any orientation keep momentum and angular momentum, and
/// without losses the energy.
TEST(RoundedBodies, elastic_impacts_keep_momentum_angular_momentum_and_energy) {
  const scene::Solid cube = scene::rounded_cube(0.02, 0.002),
                     cylinder = scene::rounded_cylinder(0.02, 0.02, 0.002);
  Random random(3, 0);
  double momentum = 0, angular = 0, energy = 0;
  int met = 0;
  for (int n = 0; n < 40; ++n) {
    const scene::Solid& solid = n % 2 == 0 ? cube : cylinder;
    const Vec3 inertia = inertia_of(solid, density);
    const auto turn = [&] { return turned_about(random.direction(), random.uniform(0, 3)); };
    const Quaternion a = turn(), b = turn();
    const Vec3 offset = 0.038 * random.direction(), speed = -12.0 * offset;
    const Impact m = collide(solid, a, b, offset, speed, 1, 0.06);
    met += m.hits.empty() ? 0 : 1;
    const double mass = density * solid.volume;
    const auto sums = [&](const std::vector<scene::Ball>& all) {
      struct {
        Vec3 p, l;
        double e = 0;
      } s;
      for (const scene::Ball& ball : all) {
        s.p += mass * ball.velocity;
        s.l += mass * cross(ball.position, ball.velocity) + angular_momentum(ball, inertia);
        s.e += 0.5 * mass * squared(ball.velocity) + rotation_energy(ball, inertia);
      }
      return s;
    };
    const auto before = sums(m.before), after = sums(m.after);
    momentum = std::max(momentum, norm(after.p - before.p) / norm(before.p));
    angular = std::max(angular, norm(after.l - before.l) / (0.02 * norm(before.p)));
    energy = std::max(energy, std::abs(after.e / before.e - 1));
  }
  EXPECT_GT(met, 30);
  stays_below("change of the momentum", momentum, 1e-12, "rounding");
  stays_below(
      "change of the angular momentum over edge times momentum", angular, 2e-3,
      "forces act along the line between the nearest points; their points move by an overlap");
  stays_below("change of the energy", energy, 2e-3,
              "the contact is a potential: 400 steps in each");
}

/// A cylinder rolls down an incline: a = g sin/(1 + I/(m R^2)).
TEST(RoundedBodies, cylinder_rolls_down_as_its_inertia_demands) {
  const double radius = 0.01, angle = 0.2;
  const scene::Solid solid = scene::rounded_cylinder(2 * radius, 0.03, 0.002);
  const contact::Pair pair = pair_of(soft_steel, soft_steel, 0.3, 0.5);
  const Vec3 pull{gravity * std::sin(angle), 0, -gravity * std::cos(angle)};
  scene::Ball ball =
      body_of(solid, density, {-0.1, 0, -0.5 * side + radius}, turned_about({1, 0, 0}, pi / 2));
  const double dt = body_step({ball}, solid, HertzMindlin{}, pair, 1, 30);
  const auto engine =
      body_engine(still_box(side, pull), {ball}, solid, of_law(HertzMindlin{}), pair, dt);
  Recorder hits;
  engine->advance(0.1, hits);
  const double before = engine->balls()[0].velocity.x;
  engine->advance(0.3, hits);
  const scene::Ball after = engine->balls()[0];
  const double ratio = inertia_of(solid, density).z / (density * solid.volume * radius * radius);
  states("acceleration [m/s2]", (after.velocity.x - before) / 0.2,
         gravity * std::sin(angle) / (1 + ratio), 0.01, "1/(1 + I/(m R^2))");
  states("spin times radius over speed", after.spin.y * radius / after.velocity.x, 1, 2e-3,
         "rolls without sliding");
  stays_below("turned out of its way [rad]", std::abs(rotation_of(after.orientation).ez.x), 0.02,
              "its axis stays across");
}

/// A cube on an incline: rests below the angle of friction, slides with g (sin - mu cos) above.
TEST(RoundedBodies, cube_slides_above_the_angle_of_friction_only) {
  const scene::Solid cube = scene::rounded_cube(0.02, 0.002);
  const double mu = 0.3;
  const contact::Pair pair = pair_of(soft_steel, soft_steel, 0.3, mu);
  for (const double angle : {0.2, 0.4}) {
    const Vec3 pull{gravity * std::sin(angle), 0, -gravity * std::cos(angle)};
    const scene::Ball ball = body_of(cube, density, {-0.1, 0, -0.5 * side + 0.01});
    const double dt = body_step({ball}, cube, HertzMindlin{}, pair, 1, 30);
    const auto engine =
        body_engine(still_box(side, pull), {ball}, cube, of_law(HertzMindlin{}), pair, dt);
    Recorder hits;
    engine->advance(0.1, hits);
    const double before = engine->balls()[0].velocity.x;
    engine->advance(0.2, hits);
    const scene::Ball after = engine->balls()[0];
    const bool slides = std::tan(angle) > mu;
    states(fmt::format("acceleration at {} rad [m/s2]", angle), (after.velocity.x - before) / 0.1,
           slides ? gravity * (std::sin(angle) - mu * std::cos(angle)) : 0, 0.03,
           "Coulomb's law for a block");
    states("  height of its middle [m]", after.position.z + 0.5 * side, 0.01, 1e-4, "it lies flat");
    stays_below("  tilt", 1 - std::abs(rotation_of(after.orientation).ez.z), 1e-4, "likewise");
  }
}

/// Five cubes that fall on each other become a tower at rest. The contact of two faces leaps from
/// corner to corner, which feeds energy that vanishes with the step.
TEST(RoundedBodies, cubes_make_a_tower) {
  const scene::Solid cube = scene::rounded_cube(0.02, 0.002);
  const contact::Pair pair = pair_of(soft_steel, soft_steel, 0.2, 0.5);
  std::vector<scene::Ball> all;
  for (int k = 0; k < 5; ++k)
    all.push_back(body_of(cube, density, {2e-4 * k, 1e-4 * k, -0.5 * side + 0.01 + 0.0202 * k}));
  std::vector<double> fed;  // [W]
  for (const double steps : {30.0, 120.0}) {
    const double dt = body_step(all, cube, HertzMindlin{}, pair, 1, steps);
    const auto engine =
        body_engine(still_box(side, {0, 0, -gravity}), all, cube, of_law(HertzMindlin{}), pair, dt);
    Recorder hits;
    engine->advance(0.2, hits);
    const double before = engine->energy_balance().residual();
    engine->advance(0.4, hits);
    fed.push_back((engine->energy_balance().residual() - before) / 0.2);
    const auto balls = engine->balls();
    for (std::size_t k = 0; k < 5; ++k)
      states(fmt::format("height of cube {} [m]", k), balls[k].position.z + 0.5 * side,
             0.01 + 0.02 * static_cast<double>(k), 3e-4, "edges, less overlaps");
  }
  const double scale = 5 * density * cube.volume * gravity * std::sqrt(gravity * 0.02);
  stays_below("power that leaps feed over 5 m g sqrt(g a), 30 steps in a contact", fed[0] / scale,
              1 / (30.0 * 4), "impulse of a step on a corner of each cube (bod.21)");
  stays_below("  the same at 120 steps over that at 30", fed[1] / fed[0], 0.25,
              "it vanishes faster than the step");
}

/// Cubes and cylinders that are shaken in a jar with a fillet, in a capsule and in a sphere: their
/// corners and rims never leave it.
TEST(RoundedBodies, bodies_stay_within_their_jar) {
  const std::vector<geometry::AnyShape> jars{geometry::RoundedCylinder{0.06, 0.06, 0.01},
                                             geometry::Capsule{0.06, 0.03}, geometry::Sphere{0.07}};
  for (const geometry::AnyShape& jar : jars)
    for (const scene::Solid& solid :
         {scene::rounded_cube(0.012, 0.001), scene::rounded_cylinder(0.014, 0.01, 0.001)}) {
      const contact::Pair pair = pair_of(soft_steel, soft_steel, 0.6, 0.3);
      std::vector<scene::Ball> all;
      Random random(5, 0);
      for (const double x : {-0.011, 0.011})
        for (const double y : {-0.011, 0.011})
          for (const double z : {-0.011, 0.011}) {
            all.push_back(body_of(solid, density, {x, y, z},
                                  turned_about(random.direction(), random.uniform(0, 3))));
            all.back().velocity = 1.5 * random.direction();
          }
      const scene::Chamber chamber{jar, kinematics::Still{}, {}, {0, 0, -gravity}};
      const double dt = body_step(all, solid, HertzMindlin{}, pair, 1.5, 30);
      const auto engine = body_engine(chamber, all, solid, of_law(HertzMindlin{}), pair, dt);
      Recorder hits;
      double deepest = 0;
      for (int k = 1; k <= 40; ++k) {
        engine->advance(0.005 * k, hits);
        for (const scene::Ball& b : engine->balls()) {
          const Rotation axes = rotation_of(b.orientation);
          for (int n = 0; n < 200; ++n) {
            const Vec3 d = random.direction();
            const Vec3 at = b.position + axes * solid.core.support(d) + solid.rounding * (axes * d);
            deepest = std::max(deepest, -geometry::nearest_wall(jar, at, 1e-6));
          }
        }
      }
      EXPECT_GT(hits.all.size(), 50U);
      stays_below("deepest point outside the jar over the rounding", deepest / solid.rounding, 0.3,
                  "overlaps of impacts at 1.5 m/s");
    }
}

TEST(RoundedBodies, cores_that_meet_stop_the_run) {
  const scene::Solid cube = scene::rounded_cube(0.02, 1e-5);
  const contact::Pair pair = pair_of({1e5, 0.3}, {1e5, 0.3}, 1);
  std::vector<scene::Ball> all{body_of(cube, density, {0, 0, -0.05}),
                               body_of(cube, density, {0, 0, 0.05})};
  all[1].velocity = {0, 0, -20};
  const auto engine = body_engine(still_box(side), all, cube, of_law(HertzMindlin{}), pair, 1e-5);
  Recorder hits;
  EXPECT_THROW(engine->advance(0.1, hits), RunError);
}

}  // namespace
}  // namespace mahlwerk::tests::soft_rounded_bodies_test
