// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Impacts of bodies that are no spheres: impulses of rigid bodies.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "bodies.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::soft_body_impact_test {
namespace {

using contact::HertzMindlin;
constexpr double density = 7800, side = 0.4;
constexpr contact::ElasticConstants soft_steel{1e9, 0.3};

struct Hit {
  scene::Ball before, after;
  scene::Collision record;
  scene::EnergyBalance energy;
  std::size_t records = 0;
};

/// A body falls on the floor at `speed`, without gravity.
Hit fall(const scene::Solid& solid, const Quaternion& orientation, double speed,
         const contact::Pair& pair, const Vec3& across = {}) {
  Hit hit;
  hit.before = body_of(solid, density, {}, orientation);
  hit.before.velocity = across - Vec3{0, 0, speed};
  const scene::BodyShape shape = solid.shape();
  double lowest = 0;
  for (const geometry::MemberSphere& s : shape.spheres)
    lowest = std::min(lowest, (rotation_of(orientation) * s.centre).z - s.radius);
  hit.before.position.z = -0.5 * side - lowest * hit.before.radius + 1e-5;
  const double dt = body_step({hit.before}, solid, HertzMindlin{}, pair, speed, 400);
  const auto engine =
      body_engine(still_box(side), {hit.before}, solid, of_law(HertzMindlin{}), pair, dt);
  Recorder recorder;
  for (int k = 1; k < 400 && recorder.all.empty(); ++k) engine->advance(20 * k * dt, recorder);
  hit.after = engine->balls()[0];
  hit.energy = engine->energy_balance();
  hit.records = recorder.all.size();
  if (!recorder.all.empty()) hit.record = recorder.all.front();
  return hit;
}

/// The end of a rod hits a smooth floor at the distance x from the centre of mass along the floor:
/// J = (1 + e) v/(1/m + x^2/I), v' = -v + J/m, w' = J x/I.
TEST(BodyImpact, end_of_a_rod_on_a_floor_gives_the_impulse_of_rigid_bodies) {
  const double diameter = 0.01, length = 0.05, speed = 0.1;
  const scene::Solid rod = scene::rod_of_spheres(diameter, length, 9);
  const double m = density * rod.volume, inertia = inertia_of(rod, density).x;
  for (const double e : {0.3, 0.6, 0.9})
    for (const double angle : {0.3, 0.8, 1.3}) {  // between the rod and the vertical
      const Hit hit =
          fall(rod, turned_about({0, 1, 0}, angle), speed, pair_of(soft_steel, soft_steel, e));
      const double x = 0.5 * (length - diameter) * std::sin(angle);
      const double mass = 1 / (1 / m + x * x / inertia), impulse = (1 + e) * mass * speed;
      const std::string what = fmt::format("e = {}, angle {}: ", e, angle);
      // In the contact, of 0.3 ms, the rod turns by 5e-3 rad.
      states(what + "v' [m/s]", hit.after.velocity.z, -speed + impulse / m, 3e-3 * speed,
             "impulse");
      states(what + "w' [rad/s]", std::abs(hit.after.spin.y), impulse * x / inertia,
             5e-3 * impulse * x / inertia, "impulse");
      states(what + "effective mass of the record [kg]", hit.record.mass, mass, 1e-3 * mass,
             "bod.12");
      states(what + "lost over (1 - e^2) m* v^2/2",
             hit.record.lost_normal / ((1 - e * e) * hit.record.energy_normal()), 1, 0.01,
             "dem.39");
      stays_below(what + "balance", std::abs(hit.energy.residual()) / hit.record.energy_normal(),
                  1e-3, "dem.32");
    }
}

/// A rough floor: the end of the rod sticks in the impact, so the impulse across follows from the
/// velocity of the contact point. With e_t of an elastic spring unknown, what holds is the angular
/// momentum about the contact point.
TEST(BodyImpact, rod_keeps_its_angular_momentum_about_the_point_of_contact) {
  const double diameter = 0.01, length = 0.05, speed = 0.1;
  const scene::Solid rod = scene::rod_of_spheres(diameter, length, 9);
  const double m = density * rod.volume;
  const Vec3 inertia = inertia_of(rod, density);
  for (const double across : {0.02, 0.2}) {
    const Hit hit = fall(rod, turned_about({0, 1, 0}, 0.7), speed,
                         pair_of(soft_steel, soft_steel, 0.7, 0.3), {across, 0.5 * across, 0});
    const Rotation axes = rotation_of(hit.before.orientation);
    // The lower end: the rod's axis is its z axis.
    const Vec3 end = -0.5 * (length - diameter) * axes.ez;
    const Vec3 arm = end + Vec3{0, 0, -0.5 * diameter};
    const Vec3 impulse = m * (hit.after.velocity - hit.before.velocity);
    const Vec3 change =
        angular_momentum(hit.after, inertia) - angular_momentum(hit.before, inertia);
    stays_below(fmt::format("L - r x J over it, {} m/s across", across),
                norm(change - cross(arm, impulse)) / norm(change), 0.01, "angular momentum");
    stays_below("  balance over m v^2/2",
                std::abs(hit.energy.residual()) / (0.5 * m * speed * speed), 2e-3, "dem.32");
  }
}

/// Two spheres of a rod hit the floor at once: each is a contact of its own with the effective mass
/// at its point, but together they carry the whole rod (bod.14).
TEST(BodyImpact, flat_hit_of_two_spheres_has_the_restitution_of_both_contacts) {
  const scene::Solid rod = scene::rod_of_spheres(0.01, 0.03, 2);
  const double e = 0.7;
  const Hit hit = fall(rod, turned_about({0, 1, 0}, 0.5 * std::numbers::pi), 0.1,
                       pair_of(soft_steel, soft_steel, e));
  const double found = hit.after.velocity.z / 0.1;
  EXPECT_EQ(hit.records, 2U);
  // A contact of mass m* has the ratio of damping b(e). Two of them at once carry m: the spring has
  // twice the stiffness and the damper twice the strength, sqrt(2 m*/m) of b.
  const double m = density * rod.volume, mass = hit.record.mass;
  const double ln = std::log(e), b = -ln / std::sqrt(ln * ln + std::numbers::pi * std::numbers::pi);
  const double both = b * std::sqrt(2 * mass / m);
  const double expected = std::exp(-std::numbers::pi * both / std::sqrt(1 - both * both));
  states("restitution of the flat hit", found, expected, 0.01, "bod.14");
}

/// Where bodies that fall on a floor are hit: by their orientation. A flat one has a record of each
/// sphere that touches, all of the face or side.
TEST(BodyImpact, record_tells_face_edge_corner_side_or_cap) {
  using scene::BodyFeature;
  constexpr double quarter = 0.5 * std::numbers::pi;
  const scene::Solid cylinder = scene::cylinder_of_spheres(0.01, 0.012, 47),
                     cube = scene::cube_of_spheres(0.01, 0.002, 60),
                     rod = scene::rod_of_spheres(0.01, 0.03, 5);
  const Quaternion on_edge = turned_about({1, 0, 0}, 0.5 * quarter);
  const double to_corner = std::acos(1 / std::sqrt(3.0));
  const struct {
    std::string what;
    const scene::Solid& solid;
    Quaternion orientation;
    BodyFeature feature;
  } falls[]{{"cylinder on its end", cylinder, {}, BodyFeature::face},
            {"cylinder on its side", cylinder, turned_about({1, 0, 0}, quarter), BodyFeature::side},
            {"cylinder on its rim", cylinder, on_edge, BodyFeature::edge},
            {"cube on its face", cube, turned_about({0, 1, 0}, quarter), BodyFeature::face},
            {"cube on its edge", cube, on_edge, BodyFeature::edge},
            {"cube on its corner", cube,
             turned_about({std::sqrt(0.5), -std::sqrt(0.5), 0}, to_corner), BodyFeature::corner},
            {"rod on its end", rod, {}, BodyFeature::cap},
            {"rod on its side", rod, turned_about({0, 1, 0}, quarter), BodyFeature::side}};
  for (const auto& one : falls) {
    const Hit hit = fall(one.solid, one.orientation, 0.1, pair_of(soft_steel, soft_steel, 0.6));
    ASSERT_GT(hit.records, 0U) << one.what;
    EXPECT_EQ(name_of(hit.record.feature), name_of(one.feature)) << one.what;
    EXPECT_EQ(hit.record.other_feature, BodyFeature::none) << "the floor";
  }
}

/// A rod falls with its end on the side of another one, which lies across.
TEST(BodyImpact, record_of_two_bodies_tells_where_each_is_hit) {
  const scene::Solid rod = scene::rod_of_spheres(0.01, 0.03, 5);
  scene::Ball upright = body_of(rod, density, {0, 0, 0.021}),
              across = body_of(rod, density, {}, turned_about({0, 1, 0}, 0.5 * std::numbers::pi));
  upright.velocity = {0, 0, -0.5};
  const contact::Pair pair = pair_of(soft_steel, soft_steel, 0.6);
  const double dt = body_step({upright, across}, rod, HertzMindlin{}, pair, 0.5, 50);
  const auto engine =
      body_engine(still_box(side), {upright, across}, rod, of_law(HertzMindlin{}), pair, dt);
  Recorder recorder;
  engine->advance(0.02, recorder);
  ASSERT_EQ(recorder.all.size(), 1U);
  const scene::Collision& hit = recorder.all.front();
  EXPECT_EQ(name_of(hit.ball == 0 ? hit.feature : hit.other_feature), "cap");
  EXPECT_EQ(name_of(hit.ball == 0 ? hit.other_feature : hit.feature), "side");
}

/// A clump of a single sphere, and a convex body whose core is a point, move as the sphere does.
TEST(BodyImpact, body_that_is_a_sphere_moves_as_the_sphere) {
  scene::Solid clump_of_one{{{{}, 0.005}}, 4.0 / 3 * std::numbers::pi * 1.25e-7, {}};
  const double i = 0.4 * clump_of_one.volume * 2.5e-5;
  clump_of_one.inertia = {i, i, i};
  scene::Solid point = clump_of_one;
  point.core.corners = {Vec3{}}, point.rounding = 0.005;
  const contact::Pair pair = pair_of(soft_steel, soft_steel, 0.7, 0.3);
  scene::Ball ball = body_of(clump_of_one, density, {0, 0, -0.19});
  ball.velocity = {0.3, 0.1, -0.2}, ball.spin = {10, -20, 5};
  scene::Ball other = ball;
  other.position = {0.03, 0.01, -0.19}, other.velocity = {-0.2, 0, 0.1};
  const Vec3 pull{0, 0, -gravity};
  const double dt = body_step({ball}, clump_of_one, HertzMindlin{}, pair, 1, 25);
  soft::Settings settings{of_law(HertzMindlin{}), dt, false, 0};
  const auto sphere = soft::make_engine(still_box(side, pull), {ball, other}, settings,
                                        contact::PairTable(1, 6, pair));
  Recorder a;
  sphere->advance(0.3, a);
  EXPECT_GT(a.all.size(), 3U);
  for (const scene::Solid& solid : {clump_of_one, point}) {
    const auto body =
        body_engine(still_box(side, pull), {ball, other}, solid, of_law(HertzMindlin{}), pair, dt);
    Recorder b;
    body->advance(0.3, b);
    ASSERT_EQ(a.all.size(), b.all.size());
    for (std::size_t k = 0; k < 2; ++k) {
      const scene::Ball x = body->balls()[k], y = sphere->balls()[k];
      stays_below("positions [m]", norm(x.position - y.position), 1e-11, "rounding");
      stays_below("velocities [m/s]", norm(x.velocity - y.velocity), 1e-9, "rounding");
      stays_below("spins [rad/s]", norm(x.spin - y.spin), 1e-6, "rounding");
    }
  }
}

/// A row of spheres rolls down a slope about its own axis.
TEST(BodyImpact, rod_rolls_down_a_slope_at_g_sin_over_one_plus_k) {
  const double slope = 0.2, diameter = 0.01;
  const scene::Solid rod = scene::rod_of_spheres(diameter, 0.03, 5);
  const Vec3 pull{gravity * std::sin(slope), 0, -gravity * std::cos(slope)};
  const contact::Pair pair = pair_of(soft_steel, soft_steel, 0.5, 0.5);
  // The rod's axis, z, lies along y.
  const scene::Ball ball = body_of(rod, density, {-0.15, 0, -0.5 * side + 0.5 * diameter},
                                   turned_about({1, 0, 0}, 0.5 * std::numbers::pi));
  const double dt = body_step({ball}, rod, HertzMindlin{}, pair, 0.5, 50);
  const auto engine =
      body_engine(still_box(side, pull), {ball}, rod, of_law(HertzMindlin{}), pair, dt);
  Recorder none;
  engine->advance(0.1, none);
  const double from = engine->balls()[0].velocity.x, t = engine->energy_balance().time;
  engine->advance(0.3, none);
  const scene::Ball now = engine->balls()[0];
  const double a = (now.velocity.x - from) / (engine->energy_balance().time - t);
  const double k = rod.inertia.z / (rod.volume * 0.25 * diameter * diameter);
  const double expected = gravity * std::sin(slope) / (1 + k);
  states("acceleration [m/s2]", a, expected, 2e-3 * expected, "g sin(a)/(1 + I/(m R^2))");
  states("w R over v", now.spin.y * 0.5 * diameter / now.velocity.x, 1, 2e-3, "no slip");
}

}  // namespace
}  // namespace mahlwerk::tests::soft_body_impact_test
