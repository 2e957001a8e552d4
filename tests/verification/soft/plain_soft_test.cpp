// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The soft engine compared with the simple reference (PlainSoft), in the same frame and in others.
#include "plain_soft.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::plain_soft_test {
namespace {

using contact::HertzMindlin;
using contact::Rolling;

contact::Pair soft_pair(double e = 0.7, double mu = 0.3) {
  contact::Pair pair = pair_of({1e8, 0.3}, {1e8, 0.3}, e, mu);
  pair.rolling_friction = 0.02;
  return pair;
}

/// Largest difference of a position, over the radius.
double apart(const std::vector<scene::Ball>& a, const std::vector<scene::Ball>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    most = max_or_nan(most, norm(a[i].position - b[i].position) / a[i].radius);
  return most;
}

std::vector<scene::Ball> thrown(int count, double speed) {
  Random random(4, 0);
  std::vector<scene::Ball> balls;
  for (int i = 0; i < count; ++i) {
    const Vec3 cell{i % 3 - 1.0, i / 3 % 2 - 0.5, i / 6 - 0.5};
    const double radius = i % 2 == 0 ? 0.004 : 0.003;
    balls.push_back({radius, 7850, 0.0091 * cell, speed * random.direction(),
                     random.uniform(0, 100) * random.direction()});
  }
  return balls;
}

/// Both programs take the same steps, so they differ only by rounding errors, which grow in
/// collisions. A second run of the reference, with one ball displaced by 1e-14 radii, measures this
/// growth.
void same_as_plain(const std::string& what, int count, double time, std::size_t touches,
                   Rolling rolling = Rolling::cdt, std::size_t few = 32) {
  const scene::Chamber box = still_box(0.03, {0, 0, -gravity});
  const double dt = 2e-6;
  const std::vector<scene::Ball> balls = thrown(count, 1);
  std::vector<scene::Ball> nudged = balls;
  nudged[0].position.x += 1e-14 * balls[0].radius;
  const int steps = static_cast<int>(std::lround(time / dt));
  PlainSoft plain(laboratory(box), balls, soft_pair(), dt, rolling);
  PlainSoft other(laboratory(box), nudged, soft_pair(), dt, rolling);
  plain.advance(steps);
  other.advance(steps);
  ASSERT_GE(plain.touches().size(), touches);
  const int faces = geometry::faces(*box.shape);
  const auto engine =
      soft::make_engine(box, balls, {of_law(HertzMindlin{}, rolling), dt, false, few},
                        contact::PairTable(1, faces, soft_pair()), 0);
  Recorder recorder;
  engine->advance(steps * dt, recorder);
  const double growth = apart(plain.balls(), other.balls());
  std::printf("    %zu contacts; a nudge of 1e-14 radii has grown to %.2g\n",
              plain.touches().size(), growth);
  ASSERT_LT(growth, 1e-6) << "else nothing is compared";
  // Rounding displaces a ball by 1e-16 of the jar, five times a radius, at each of 1e4 steps.
  stays_below(what + ", places over radius", apart(engine->balls(), plain.balls()),
              std::max(1e-12, 20 * growth), "plain reference, the same steps");
}

TEST(PlainSoft, three_balls_in_a_still_box) {
  same_as_plain("3 balls", 3, 0.06, 8);
}
TEST(PlainSoft, twelve_balls_whose_forces_go_through_memory) {
  same_as_plain("12 balls", 12, 0.02, 20);
}
TEST(PlainSoft, rolling_resistance_against_the_spin_of_each_ball) {
  for (const std::size_t few : {std::size_t{32}, std::size_t{0}})
    same_as_plain(few > 0 ? "own-spin, few" : "own-spin, many", 12, 0.02, 20, Rolling::own_spin,
                  few);
}

/// Compares the engine in the jar frame with the reference in another frame. The difference falls
/// with the time step, in three halvings to an eighth at least. (The phase of a touch within a step
/// is random, which hides the order of a single halving.)
void tends_to(const std::string& what, const std::function<double(double dt)>& difference) {
  constexpr double longest = 4e-6, shortest = 5e-7;
  double first = 0, last = 0;
  for (double dt = longest; dt > 0.9 * shortest; dt /= 2) {
    last = difference(dt);
    if (dt == longest) first = last;
    std::printf("    %-58s step %.3g s: differ by %.3g radii\n", what.c_str(), dt, last);
  }
  stays_below(what + ", an eighth of the step over all of it", last / first, 1.0 / 8,
              "order 1 at least");
  const double contact =
      contact_time(of_law(HertzMindlin{}), {soft_pair(), 0.004, ball_a().mass()}, 1);
  stays_below(what + ", at the shortest step, over radius", last, std::pow(shortest / contact, 2),
              "(dt/t_c)^2, of a method of order 2");
}

TEST(Frames, a_vibration_mill_is_the_same_in_the_laboratory) {
  const scene::Chamber mill = mill_a(20, 0.01);
  tends_to("one ball in a shaken capsule", [&](double dt) {
    const scene::Ball ball = ball_a({0.0003, -0.0002, 0.004}, {0.3, 0.1, -0.4}, {10, -20, 30});
    const auto engine = soft_engine(mill, {ball}, of_law(HertzMindlin{}), soft_pair(), dt);
    scene::Ball lifted = ball;
    const auto frame_motion = [&](double t) {
      return std::get<kinematics::Vibration>(*mill.motion).frame_motion(t);
    };
    lifted.velocity += frame_motion(0).velocity;
    PlainSoft plain(laboratory(mill), {lifted}, soft_pair(), dt);
    const int steps = static_cast<int>(std::lround(0.05 / dt));
    plain.advance(steps);
    Recorder recorder;
    engine->advance(steps * dt, recorder);
    EXPECT_GE(recorder.all.size(), 3U);
    std::vector<scene::Ball> there = plain.balls();
    there[0].position -= frame_motion(plain.time()).centre;
    return apart(engine->balls(), there);
  });
}

/// In the jar's own rotating axes the walls are at rest. The balls are subject to the acceleration
/// of the orbit, the centrifugal and the Coriolis acceleration.
TEST(Frames, a_planetary_mill_is_the_same_as_seen_from_its_turning_jar) {
  const double orbit = 0.07, disc = 40, ratio = -2, jar = disc * (1 + ratio);
  const scene::Chamber mill{geometry::Cylinder{0.042, 0.03},
                            kinematics::Planetary{orbit, disc, ratio},
                            {},
                            {0, 0, -gravity}};
  const Vec3 w{0, 0, jar};
  PlainWorld turning_jar = laboratory({mill.shape, kinematics::Still{}, {}, {}});
  turning_jar.turning = w;
  turning_jar.field = [=](const Vec3& x, const Vec3& v, double t) {
    const double a = (disc - jar) * t, c = disc * disc * orbit;
    const Vec3 outward{c * std::cos(a), c * std::sin(a), -gravity};
    return outward - cross(w, cross(w, x)) - 2.0 * cross(w, v);
  };
  for (const double mu : {0.0, 0.3})
    tends_to("one ball in a planetary mill, mu " + std::to_string(mu).substr(0, 3), [&](double dt) {
      const scene::Ball ball{0.005, 7850, {0.01, 0.002, -0.001}, {0.2, 0.3, 0.1}, {}};
      const auto engine = soft_engine(mill, {ball}, of_law(HertzMindlin{}), soft_pair(0.7, mu), dt);
      scene::Ball carried = ball;
      carried.velocity -= cross(w, ball.position);
      carried.spin -= w;
      PlainSoft plain(turning_jar, {carried}, soft_pair(0.7, mu), dt);
      const int steps = static_cast<int>(std::lround(0.04 / dt));
      plain.advance(steps);
      EXPECT_GE(plain.touches().size(), 3U);
      Recorder recorder;
      engine->advance(steps * dt, recorder);
      std::vector<scene::Ball> own = engine->balls();
      own[0].position =
          rotation_about({0, 0, 1}, jar * plain.time()).apply_inverse(own[0].position);
      return apart(own, plain.balls());
    });
}

}  // namespace
}  // namespace mahlwerk::tests::plain_soft_test
