// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Invariance of a run: computed in another frame, from another start of the clock, and in several
// portions.
#include <gtest/gtest.h>

#include <algorithm>

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/scene/chamber.hpp"
#include "one_ball.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::frames_test {
namespace {

const Vec3 start{0.0003, -0.0002, 0.004}, velocity{0.05, 0.03, -0.02}, spin{0.05, -0.02, 0.08};

/// Simple reference, kept permanently: laboratory axes with a moving vial, a test of the gap every
/// 2 us, and bisection.
std::vector<scene::Collision> in_laboratory_frame(int wanted) {
  const double f = 10, a = 0.025, w = 2 * std::numbers::pi * f, big = 0.006 - 0.004;
  const double h = 0.5 * vial(0.012).height;
  const auto wall_z = [&](double t) { return a * std::sin(w * t); };
  const auto wall_v = [&](double t) { return a * w * std::cos(w * t); };
  Vec3 r = start, v = velocity + Vec3{0, 0, wall_v(0)}, spin_now = spin;
  double t0 = 0;
  std::vector<scene::Collision> seen;
  const auto at = [&](double t) {
    const double s = t - t0;
    return r + s * v + 0.5 * s * s * Vec3{0, 0, -gravity};
  };
  const auto from_core = [&](double t) {
    const Vec3 p = at(t);
    const double z = p.z - wall_z(t);
    return Vec3{p.x, p.y, z - std::clamp(z, -h, h)};
  };
  const auto gap = [&](double t) { return big - norm(from_core(t)); };
  for (double t = 0; static_cast<int>(seen.size()) < wanted;) {
    const double step = 2e-6;
    if (gap(t + step) > 0) {
      t += step;
      continue;
    }
    double out = t, in = t + step;
    for (int i = 0; i < 60; ++i) (gap(0.5 * (out + in)) > 0 ? out : in) = 0.5 * (out + in);
    const Vec3 n = from_core(out) / norm(from_core(out)), r1 = at(out);
    const Vec3 v1 = v + (out - t0) * Vec3{0, 0, -gravity};
    const Vec3 u = v1 - Vec3{0, 0, wall_v(out)} + 0.004 * cross(spin_now, n);
    const double un = dot(u, n);
    if (un <= 0) {  // just bounced here
      t += step;
      continue;
    }
    const Vec3 ut = u - un * n;
    v = v1 - 1.9 * un * n - 2.0 / 7 * 0.1 * ut;
    spin_now -= 5.0 / 7 * 0.1 / 0.004 * cross(n, ut);
    r = r1, t0 = t = out;
    scene::Collision& c = seen.emplace_back();
    c.time = out, c.approach = un, c.slip = norm(ut);
  }
  return seen;
}

TEST(Frames, laboratory_frame_and_jar_frame_agree) {
  constexpr int wanted = 25;
  const auto reference = in_laboratory_frame(wanted);
  const auto engine = event::one_ball(mill_a(), ball_a(start, velocity, spin), rules_a());
  Recorder recorder;
  engine->advance(2, recorder);
  ASSERT_GE(recorder.all.size(), reference.size());
  // Both programs find a touch to 1e-15 s. These errors grow at every bounce off a curved wall, to
  // 1e-11 s at the twelfth. The comparison ends there.
  double worst_time = 0, worst_speed = 0;
  for (std::size_t i = 0; i < 12; ++i) {
    worst_time = max_or_nan(worst_time, std::abs(reference[i].time - recorder.all[i].time));
    worst_speed = std::max({worst_speed, std::abs(reference[i].approach - recorder.all[i].approach),
                            std::abs(reference[i].slip - recorder.all[i].slip)});
  }
  stays_below("times of 12 collisions [s]", worst_time, 1e-10, "plain reference, laboratory frame");
  stays_below("speeds of 12 collisions [m/s]", worst_speed, 1e-7,
              "plain reference, laboratory frame");
}

std::vector<scene::Collision> run(const scene::Chamber& mill, double begin, int portions,
                                  double time = 5) {
  const auto engine = event::one_ball(mill, ball_a(start, velocity, spin), rules_a(), begin);
  Recorder recorder;
  for (int i = 1; i <= portions; ++i) engine->advance(time * i / portions, recorder);
  return recorder.all;
}

bool same_bits(const std::vector<scene::Collision>& a, const std::vector<scene::Collision>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.approach == y.approach && x.slip == y.slip && x.where == y.where &&
           x.lost_normal == y.lost_normal;
  });
}

TEST(Frames, start_at_nought_and_after_a_period_give_the_same_trajectory) {
  const auto now = run(mill_a(), 0, 1), later = run(mill_a(), 0.1, 1);
  EXPECT_GT(now.size(), 300U);
  EXPECT_TRUE(same_bits(now, later)) << "seed 0, S0-2: the sine's argument is the absolute time";
}

TEST(Frames, how_a_run_is_cut_does_not_change_it) {
  EXPECT_TRUE(same_bits(run(mill_a(), 0, 1), run(mill_a(), 0, 777)));
  const scene::Chamber planetary{
      geometry::Cylinder{0.042, 0.0325},
      kinematics::Planetary{.orbit_radius = 0.07, .speed = 41.9, .ratio = -2},
      {},
      {0, 0, -gravity}};
  EXPECT_TRUE(same_bits(run(planetary, 0, 1, 1), run(planetary, 0, 313, 1)));
}

/// The search treats a jar that turns about its axis of symmetry as a jar at rest. A table of the
/// same motion gives no such hint beyond its axis. An upright mill is compared with the same mill
/// laid on its side in gravity turned by the same rotation.
TEST(Frames, a_turned_mill_in_turned_gravity_is_the_same_mill) {
  scene::Chamber upright = mill_a();
  scene::Chamber lying = upright;
  auto& motion = std::get<kinematics::Vibration>(*lying.motion);
  motion.tilt = std::numbers::pi / 2;
  lying.mount = scene::mounted_along({1, 0, 0});
  lying.gravity = {-gravity, 0, 0};
  const Rotation m = lying.mount;
  const auto a = event::one_ball(upright, ball_a(start, velocity, spin), rules_a());
  const auto b = event::one_ball(lying, ball_a(m * start, m * velocity, m * spin), rules_a());
  Recorder of_a, of_b;
  a->advance(1, of_a);
  b->advance(1, of_b);
  double worst = 0;
  for (std::size_t i = 0; i < 12; ++i)
    worst = max_or_nan(worst, std::abs(of_a.all[i].time - of_b.all[i].time));
  stays_below("times of 12 collisions [s]", worst, 1e-10, "rotation of everything");
}

}  // namespace
}  // namespace mahlwerk::tests::frames_test
