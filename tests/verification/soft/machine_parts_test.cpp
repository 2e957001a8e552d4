// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Parts of the mill in the jar: where they are, what they do to balls, and what they bear (kin.22,
// obs.22).
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>

#include "crowd.hpp"
#include "mahlwerk/geometry/prism.hpp"
#include "mahlwerk/geometry/solids.hpp"
#include "mahlwerk/soft/walls/chamber_wall.hpp"
#include "mahlwerk/soft/walls/moving_wall.hpp"
#include "one_ball.hpp"
#include "same_bits.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::machine_parts_test {
namespace {

using contact::HertzMindlin;
using contact::Rolling;
using geometry::BladeSolid;
using geometry::CylinderSolid;
using geometry::PlaneSolid;
using kinematics::PartMotion;

constexpr double pi = std::numbers::pi;

scene::MachinePart part_of(geometry::AnySolid solid, const Vec3& position, const PartMotion& motion,
                           bool in_laboratory = false) {
  scene::MachinePart part;
  part.solid = std::move(solid);
  part.position = position;
  part.motion = motion;
  part.in_laboratory = in_laboratory;
  return part;
}

PartMotion turning(double speed, const Vec3& axis = {0, 0, 1}, const Vec3& pivot = {}) {
  PartMotion m;
  m.kind = PartMotion::Kind::turning;
  m.speed = speed, m.axis = axis, m.pivot = pivot;
  return m;
}
PartMotion oscillating(double amplitude, double frequency, const Vec3& along) {
  PartMotion m;
  m.kind = PartMotion::Kind::oscillating;
  m.amplitude = amplitude, m.frequency = frequency, m.axis = along;
  return m;
}

/// A stirred vessel that stands still: a shaft with two blades.
scene::Chamber stirred(double speed) {
  scene::Chamber mill{geometry::Cylinder{0.06, 0.05}, kinematics::Still{}, {}, {0, 0, -gravity}};
  CylinderSolid shaft;
  shaft.diameter = 0.008, shaft.length = 0.04;
  mill.parts.push_back(part_of(shaft, {0, 0, 0.005}, turning(speed)));
  mill.parts.push_back(part_of(BladeSolid{0.045, 0.003, 0.01}, {0, 0, -0.015}, turning(speed)));
  mill.parts.push_back(part_of(BladeSolid{0.003, 0.045, 0.01}, {0, 0, 0.001}, turning(speed)));
  return mill;
}

std::unique_ptr<scene::Engine> engine_of(const scene::Chamber& mill,
                                         const std::vector<scene::Ball>& balls, std::size_t few,
                                         int threads = 1, const contact::Pair& pair = some_pair(),
                                         Rolling rolling = Rolling::cdt) {
  const auto wall = soft::moving_wall(mill);
  soft::Settings settings{of_law(HertzMindlin{}, rolling), 2e-6, true};
  settings.few_ball_limit = few;
  settings.threads = threads;
  return soft::make_engine(mill, balls, settings, contact::PairTable(1, wall->faces(), pair), 0);
}

/// Balls of 3 mm between the blades.
std::vector<scene::Ball> balls_between(int count) {
  std::vector<scene::Ball> all;
  for (const scene::Ball& b : lattice_of(1000, 0.0034, {0.0015}, 0.1)) {
    const Vec3& p = b.position;
    const double r = std::hypot(p.x, p.y);
    const bool blade = std::abs(p.y) < 0.0032 || std::abs(p.x) < 0.0032;
    if (static_cast<int>(all.size()) < count && r < 0.025 && r > 0.007 && !blade &&
        std::abs(p.z) < 0.02)
      all.push_back(b);
  }
  return all;
}

TEST(MachineParts, move_the_points_of_their_faces_with_their_material) {
  PartMotion swing;
  swing.kind = PartMotion::Kind::swinging;
  swing.axis = Vec3{1, 2, 2} / 3.0, swing.pivot = {0.01, 0.002, -0.003};
  swing.frequency = 7, swing.swing = 0.4, swing.phase = 0.3;
  const kinematics::Planetary planet{0.07, 40, -2};
  for (const bool laboratory : {false, true})
    for (const PartMotion& motion : {turning(30, Vec3{2, -1, 2} / 3.0, {0.002, 0, 0.001}), swing,
                                     oscillating(0.003, 11, Vec3{0, 0.6, 0.8})}) {
      const scene::Chamber mill{geometry::Cylinder{0.06, 0.05}, planet, {}, {}};
      constexpr double t = 0.0123, h = 1e-7;
      const auto pose = [&](double at) {
        return scene::part_pose(motion, laboratory, *mill.motion, mill.mount, at);
      };
      const Vec3 x{0.013, -0.004, 0.006};  // in the frame, before the motion
      const auto place = [&](double at) { return pose(at).origin + pose(at).axes * x; };
      const Vec3 measured = (place(t + h) - place(t - h)) / (2 * h);
      const Vec3 stated = pose(t).velocity_at(place(t));
      // Third derivatives of some 1e5 m/s3 times h^2/6, and rounding 1e-17 m / h.
      stays_below("velocity [m/s]", norm(measured - stated), 1e-8, "difference quotient");
    }
}

TEST(MachineParts, that_are_a_floor_are_hit_as_the_floor_of_the_jar_is) {
  const Vec3 down{0, 0, -gravity};
  const scene::Chamber plain{geometry::Box{0.03, 0.03, 0.03}, kinematics::Still{}, {}, down};
  scene::Chamber with_floor{geometry::Box{0.03, 0.03, 0.05}, kinematics::Still{}, {}, down};
  with_floor.parts.push_back(part_of(PlaneSolid{}, {0, 0, -0.015}, {}));
  const std::vector<scene::Ball> balls{{0.003, 7850, {0.001, 0, 0}, {0.2, 0.1, 0}, {10, 5, 3}},
                                       {0.003, 7850, {-0.006, 0, 0.002}, {0.1, 0.1, 0}, {}}};
  for (const std::size_t few : {32, 0}) {
    const auto one = engine_of(plain, balls, few), other = engine_of(with_floor, balls, few);
    Recorder a, b;
    one->advance(0.1, a);
    other->advance(0.1, b);
    ASSERT_EQ(a.all.size(), b.all.size());
    for (std::size_t i = 0; i < a.all.size(); ++i) {
      // The floor is at another distance from the origin: positions round otherwise.
      states("approach [m/s]", b.all[i].approach, a.all[i].approach, 1e-9, "the jar's own floor");
      states("impulse [N s]", b.all[i].impulse, a.all[i].impulse, 1e-9 * a.all[i].impulse,
             "the jar's own floor");
      EXPECT_TRUE(a.all[i].other != ~4 || b.all[i].other == ~6);
    }
  }
}

TEST(MachineParts, that_rise_and_fall_do_to_balls_what_a_shaken_box_does) {
  // In a box that is shaken along z, floor and lid move alike; parts move so in a still box.
  constexpr double amplitude = 0.002, frequency = 30;
  const kinematics::Vibration shake = shaken(frequency, amplitude);
  const scene::Chamber shaken_box{geometry::Box{0.03, 0.03, 0.03}, shake, {}, {0, 0, -gravity}};
  scene::Chamber still{geometry::Box{0.03, 0.03, 0.06}, kinematics::Still{}, {}, {0, 0, -gravity}};
  PartMotion motion = oscillating(amplitude, frequency, {0, 0, 1});
  // The same phase as the box: compared at two instants.
  const double z0 = kinematics::frame_motion(*shaken_box.motion, 0).centre.z;
  motion.phase = std::asin(std::clamp(z0 / amplitude, -1.0, 1.0));
  if (kinematics::frame_motion(*shaken_box.motion, 0).velocity.z < 0)
    motion.phase = pi - motion.phase;
  still.parts.push_back(part_of(PlaneSolid{}, {0, 0, -0.015}, motion));
  scene::MachinePart lid = part_of(PlaneSolid{}, {0, 0, 0.015}, motion);
  lid.axes = scene::mounted_along({0, 0, -1});
  still.parts.push_back(lid);
  const kinematics::FrameMotion at_start = kinematics::frame_motion(*shaken_box.motion, 0);
  contact::Pair smooth = some_pair();
  smooth.friction = 0, smooth.rolling_friction = 0;
  const scene::Ball in_box{0.003, 7850, {0, 0, -0.01}, {0, 0, 0.1}, {}};
  scene::Ball in_laboratory = in_box;
  in_laboratory.position += at_start.centre;
  in_laboratory.velocity += at_start.velocity;
  for (const std::size_t few : {32, 0}) {
    const auto one = engine_of(shaken_box, {in_box}, few, 1, smooth, Rolling::none),
               other = engine_of(still, {in_laboratory}, few, 1, smooth, Rolling::none);
    Recorder a, b;
    one->advance(0.3, a);
    other->advance(0.3, b);
    ASSERT_GE(a.all.size(), 3U);
    ASSERT_EQ(a.all.size(), b.all.size());
    // Both schemes are of second order in the step of 2e-6 s; the first hits are not yet chaotic.
    for (std::size_t i = 0; i < 3; ++i)
      states("speed of hit " + std::to_string(i), b.all[i].approach, a.all[i].approach, 1e-5,
             "the shaken box");
  }
}

TEST(MachineParts, and_the_jar_together_change_the_momentum_of_the_charge) {
  for (const std::size_t few : {128, 0}) {
    const scene::Chamber mill = stirred(40);
    const auto engine = engine_of(mill, balls_between(60), few);
    Recorder none;
    const auto momentum = [&] {
      Vec3 linear;
      double angular = 0;
      for (const scene::Ball& b : engine->balls()) {
        linear += b.mass() * b.velocity;
        angular += b.mass() * cross(b.position, b.velocity).z +
                   b.inertia_ratio * b.mass() * b.radius * b.radius * b.spin.z;
      }
      return std::pair(linear, angular);
    };
    double mass = 0;
    for (const scene::Ball& b : engine->balls()) mass += b.mass();
    const auto [linear, angular] = momentum();
    constexpr double time = 0.1;
    engine->advance(time, none);
    const auto [later, angular_later] = momentum();
    Vec3 impulse;
    double turn = 0, work = 0;
    for (const scene::WallLoad& load : engine->wall_loads()) {
      impulse += load.impulse;  // all axes are those of the laboratory: blades turn about z
      turn += load.angular_impulse;
      work += load.work;
    }
    const std::vector<scene::WallLoad> loads = engine->wall_loads();
    ASSERT_EQ(loads.size(), 4U);
    // Impulses of blades are in axes that turn with them: only that along z is the laboratory's.
    states("impulse along z [N s]", impulse.z, (later - linear).z + mass * gravity * time,
           1e-4 * mass * gravity * time, "momentum of the balls");
    states("angular impulse [N m s]", turn, angular_later - angular,
           1e-3 * std::abs(angular_later - angular) + 1e-9, "angular momentum of the balls");
    states("work [J]", work, engine->energy_balance().wall_work, 1e-12 * std::abs(work),
           "energy balance");
    for (std::size_t k = 1; k < loads.size(); ++k)
      states("work of part " + std::to_string(k), loads[k].work, 40 * loads[k].angular_impulse,
             1e-9 * std::abs(work), "torque times speed");
  }
}

TEST(MachineParts, that_are_a_floor_bear_the_weight_of_the_charge) {
  scene::Chamber mill{
      geometry::Box{0.0195, 0.0195, 0.08}, kinematics::Still{}, {}, {0, 0, -gravity}};
  mill.parts.push_back(part_of(PlaneSolid{}, {0, 0, -0.02}, {}));
  contact::Pair smooth = some_pair();  // so that the walls bear nothing
  smooth.friction = 0, smooth.rolling_friction = 0, smooth.restitution = 0.2;
  for (const std::size_t few : {128, 0}) {
    std::vector<scene::Ball> balls;
    for (const scene::Ball& b : lattice_of(26, 0.0062, {0.003}, 0.0)) balls.push_back(b);
    const auto engine = engine_of(mill, balls, few, 1, smooth, Rolling::none);
    Recorder none;
    engine->advance(0.6, none);
    const double before = engine->wall_loads()[1].impulse.z;
    const double weight =
        gravity * std::accumulate(balls.begin(), balls.end(), 0.0,
                                  [](double m, const auto& b) { return m + b.mass(); });
    double momentum = 0, later = 0;
    for (const scene::Ball& b : engine->balls()) momentum += b.mass() * b.velocity.z;
    engine->advance(0.8, none);
    for (const scene::Ball& b : engine->balls()) later += b.mass() * b.velocity.z;
    const double force = (engine->wall_loads()[1].impulse.z - before - (later - momentum)) / 0.2;
    states("force on the floor [N]", force, weight, 1e-4 * weight, "weight of the charge");
  }
}

TEST(MachineParts, give_the_same_bits_on_any_number_of_threads_and_any_cut) {
  const scene::Chamber mill = stirred(60);
  const std::vector<scene::Ball> balls = balls_between(300);
  ASSERT_GT(balls.size(), 200U);
  const auto whole = engine_of(mill, balls, 0);
  Recorder all;
  whole->advance(0.03, all);
  const auto threads = engine_of(mill, balls, 0, 2);
  Recorder none;
  for (int i = 1; i <= 7; ++i) threads->advance(0.03 * i / 7, none);
  const auto resumed = engine_of(mill, balls, 0);
  const auto first = engine_of(mill, balls, 0);
  first->advance(0.011, none);
  copy_state(*first, *resumed);
  resumed->advance(0.03, none);
  for (const auto* other : {threads.get(), resumed.get()}) {
    const auto a = whole->balls(), b = other->balls();
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].position, b[i].position);
      EXPECT_EQ(a[i].spin, b[i].spin);
    }
    EXPECT_EQ(whole->energy_balance().wall_work, other->energy_balance().wall_work);
    const auto la = whole->wall_loads(), lb = other->wall_loads();
    for (std::size_t k = 0; k < la.size(); ++k) {
      EXPECT_EQ(la[k].angular_impulse, lb[k].angular_impulse);
      EXPECT_EQ(la[k].work, lb[k].work);
    }
  }
}

TEST(MachineParts, in_a_turning_jar_that_are_fixed_to_it_are_its_wall) {
  // A blade along the shell of a drum turns with it: the torque on the jar and that on the blade
  // are the drum's together, and its work is theirs.
  scene::Chamber drum{geometry::Cylinder{0.05, 0.03},
                      kinematics::Tumbling{10},
                      scene::mounted_along({1, 0, 0}),
                      {0, 0, -gravity}};
  drum.parts.push_back(part_of(BladeSolid{0.008, 0.002, 0.03}, {0.021, 0, 0}, {}));
  for (const std::size_t few : {128, 0}) {
    const auto engine = engine_of(drum, lattice_of(40, 0.0048, {0.002}, 0.1), few);
    Recorder none;
    engine->advance(0.2, none);
    const auto loads = engine->wall_loads();
    states("work of the jar [J]", loads[0].work, 10 * loads[0].angular_impulse,
           1e-9 * std::abs(loads[0].work), "torque times speed");
    states("work of both [J]", loads[0].work + loads[1].work, engine->energy_balance().wall_work,
           1e-12 * std::abs(loads[0].work), "energy balance");
    EXPECT_NE(loads[1].work, 0);
    EXPECT_LT(std::abs(engine->energy_balance().residual()),
              1e-3 * std::abs(engine->energy_balance().wall_work) + 1e-7);
  }
}

TEST(MachineParts, with_an_opening_let_small_balls_pass_and_bear_large_ones) {
  scene::Chamber mill{geometry::Box{0.03, 0.03, 0.06}, kinematics::Still{}, {}, {0, 0, -gravity}};
  scene::MachinePart grate = part_of(BladeSolid{0.04, 0.04, 0.002}, {}, {});
  grate.opening = 0.005;
  mill.parts.push_back(grate);
  const std::vector<scene::Ball> balls{{0.003, 7850, {-0.006, 0, 0.01}, {}, {}},
                                       {0.002, 7850, {0.006, 0, 0.01}, {}, {}}};
  for (const std::size_t few : {32, 0}) {
    const auto engine = engine_of(mill, balls, few);
    Recorder none;
    engine->advance(0.3, none);
    EXPECT_GT(engine->balls()[0].position.z, 0.001);
    EXPECT_LT(engine->balls()[1].position.z, -0.02);
  }
}

/// Near the edge of a mesh one of its faces is listed, but has no point that the ball can touch.
TEST(MachineParts, a_ball_beside_an_edge_of_a_mesh_in_a_periodic_jar_flies_on) {
  scene::Chamber mill{geometry::PeriodicCylinder{0.06, 0.02}, kinematics::Still{}, {}, {}};
  const geometry::Section bar{{0.02, -0.004}, {0.032, -0.004}, {0.032, 0.004}, {0.02, 0.004}};
  mill.parts.push_back(part_of(
      geometry::MeshSolid(geometry::weld(geometry::prism(bar, 0.03, 1)), 0.5), {}, PartMotion{}));
  scene::Ball ball = lattice_of(1, 0.0034, {0.003}, 0.1).front();
  ball.position = {0.0201, 0.00701, 0}, ball.velocity = {0, 0, 0.5}, ball.spin = {};
  for (const std::size_t few : {0U, 128U}) {
    const auto engine = engine_of(mill, {ball}, few);
    struct : scene::Observer {
      void collisions(std::span<const scene::Collision> finished) override {
        hits += finished.size();
      }
      std::size_t hits = 0;
    } observer;
    engine->advance(0.1, observer);
    EXPECT_EQ(observer.hits, 0U);
    states("speed along the axis [m/s]", engine->balls().front().velocity.z, 0.5, 1e-12,
           "0.01 mm beside the flank: nothing touches the ball");
  }
}

}  // namespace
}  // namespace mahlwerk::tests::machine_parts_test
