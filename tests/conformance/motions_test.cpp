// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Every motion in the register meets the requirements of kinematics/motion.hpp.
#include "mahlwerk/kinematics/motions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/kinematics/chosen_motion.hpp"
#include "register_types.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::motions_test {
namespace {

using namespace kinematics;

constexpr double pi = std::numbers::pi;

template <class M>
M sample();
template <>
Still sample() {
  return {};
}
template <>
Vibration sample() {
  Vibration v;
  v.frequency = 13, v.amplitude = 0.02, v.tilt = 0.7, v.heading = 1.1;
  return v;
}
template <>
Planetary sample() {
  return {.orbit_radius = 0.07, .speed = 42, .ratio = -2};
}
template <>
Tumbling sample() {
  return {.speed = 6};
}
template <>
ArcShaker sample() {
  return {.frequency = 30, .arm = 0.12, .swing = 0.09};
}
template <>
FigureEight sample() {
  return {.frequency = 17.5,
          .stroke_along = 0.03,
          .stroke_across = 0.012,
          .stroke_up = 0.004,
          .phase_across = 0.4,
          .phase_up = 1.0,
          .rock = 0.2,
          .phase_rock = -0.3,
          .pivot = 0.05};
}
template <>
Circular sample() {
  Circular c;
  c.radius = 0.017, c.speed = 209;
  return c;
}
template <>
Tabulated sample() {
  std::vector<Sample> samples;
  for (int i = 0; i <= 40; ++i) {
    const double u = i / 40.0, angle = 2 * pi * u;
    samples.push_back(
        {0.25 * (u + 0.002 * std::sin(3 * angle)),
         {0.01 * std::sin(angle), 0.02 * std::cos(2 * angle), 0.005 * std::sin(3 * angle)},
         angle});
  }
  samples.back().centre = samples.front().centre;
  return Tabulated(samples);
}

template <class M>
class Motions : public ::testing::Test {
 protected:
  M motion = sample<M>();
  Random random{3, 2};
  double some_time() { return random.uniform(0, 3); }
};
TYPED_TEST_SUITE(Motions, TypesOf<AnyMotion::Models>::type);

/// Central difference. Its error is h^2/6 of the third derivative plus rounding.
template <class F>
auto slope(const F& f, double t, double h) {
  return (f(t + h) - f(t - h)) / (2 * h);
}

bool same(const Vec3& a, const Vec3& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

TYPED_TEST(Motions, chosen_at_run_time_or_remembered_say_the_same_to_the_bit) {
  const auto& m = this->motion;
  const ChosenMotion chosen{AnyMotion(m)};
  const CachedMotion remembered{AnyMotion(m)};
  const auto agrees = [&](const auto& other, double t) {
    const FrameMotion r = m.frame_motion(t), o = other.frame_motion(t);
    return same(r.centre, o.centre) && same(r.velocity, o.velocity) &&
           same(r.acceleration, o.acceleration) && other.rotation(t) == m.rotation(t) &&
           same(other.spin(t), m.spin(t)) &&
           same(other.angular_acceleration(t), m.angular_acceleration(t));
  };
  double before = 0;
  int differ = 0;
  for (int i = 0; i < 1000; ++i) {  // every time is evaluated again after another one
    const double t = this->some_time();
    for (const double at : {t, before, t, t})
      if (!agrees(chosen, at) || !agrees(remembered, at)) ++differ;
    before = t;
  }
  EXPECT_EQ(differ, 0);
  EXPECT_EQ(chosen.period(), m.period());
  EXPECT_EQ(remembered.period(), m.period());
  EXPECT_TRUE(same(remembered.fixed_axis(), m.fixed_axis()));
}

// The requirements, at the times that `some_time()` draws.

template <class M, class Times>
void expect_derivatives_of_centre(const M& m, const Times& some_time, const char* source) {
  const Bounds b = m.bounds();
  double worst_v = 0, worst_a = 0;
  const double h = 1e-6;
  for (int i = 0; i < 2000; ++i) {
    const double t = some_time();
    const auto centre = [&](double s) { return m.frame_motion(s).centre; };
    const auto velocity = [&](double s) { return m.frame_motion(s).velocity; };
    worst_v = max_or_nan(worst_v, norm(slope(centre, t, h) - m.frame_motion(t).velocity));
    worst_a = max_or_nan(worst_a, norm(slope(velocity, t, h) - m.frame_motion(t).acceleration));
  }
  stays_below("velocity [m/s]", worst_v, h * h * b.jerk + 1e-9, source);
  // A spline's jerk may jump within h.
  stays_below("acceleration [m/s2]", worst_a, h * b.jerk + 1e-16 * b.speed / h + 1e-8, source);
}

template <class M, class Times>
void expect_rate_of_turn(const M& m, const Times& some_time, const char* source) {
  double worst = 0, worst_rate = 0;
  const double h = 1e-6;
  for (int i = 0; i < 2000; ++i) {
    const double t = some_time();
    for (const Vec3 e : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
      const auto turned = [&](double s) { return m.rotation(s) * e; };
      worst = max_or_nan(worst, norm(slope(turned, t, h) - cross(m.spin(t), m.rotation(t) * e)));
    }
    const auto spin = [&](double s) { return m.spin(s); };
    worst_rate = max_or_nan(worst_rate, norm(slope(spin, t, h) - m.angular_acceleration(t)));
  }
  const Bounds b = m.bounds();
  stays_below("spin [rad/s]", worst, 1e-9 * (1 + b.spin + b.angular_acceleration + b.spin * b.spin),
              source);
  stays_below("spin rate [rad/s2]", worst_rate, 1e-5 * (1 + b.angular_acceleration * (1 + b.spin)),
              source);
}

template <class M, class Times>
void expect_bounds(const M& m, const Times& some_time) {
  const Bounds b = m.bounds();
  for (int i = 0; i < 20000; ++i) {
    const double t = some_time(), h = 1e-5;
    const FrameMotion r = m.frame_motion(t);
    const double a_little = 1 + 1e-12;
    EXPECT_LE(norm(r.velocity), b.speed * a_little);
    EXPECT_LE(std::abs(r.acceleration.x), b.acceleration.x * a_little);
    EXPECT_LE(std::abs(r.acceleration.y), b.acceleration.y * a_little);
    EXPECT_LE(std::abs(r.acceleration.z), b.acceleration.z * a_little);
    EXPECT_LE(norm(m.frame_motion(t + h).acceleration - r.acceleration),
              h * b.jerk * (1 + 1e-6) + 1e-12);
    EXPECT_LE(norm(m.spin(t)), b.spin * a_little);
    EXPECT_LE(norm(m.angular_acceleration(t)), b.angular_acceleration * a_little);
  }
}

TYPED_TEST(Motions, velocity_and_acceleration_are_the_derivatives_of_the_centre) {
  expect_derivatives_of_centre(
      this->motion, [&] { return this->some_time(); }, "kin.1, central differences");
}

TYPED_TEST(Motions, spin_is_the_rate_of_turn) {
  const auto& m = this->motion;
  expect_rate_of_turn(
      m, [&] { return this->some_time(); }, "kin.1");
  const Vec3 axis = m.fixed_axis();
  for (int i = 0; i < 100 && norm(axis) > 0; ++i)
    EXPECT_NEAR(norm(cross(axis, m.spin(this->some_time()))), 0, 1e-12 * (1 + m.bounds().spin));
}

TYPED_TEST(Motions, bounds_are_never_exceeded) {
  expect_bounds(this->motion, [&] { return this->some_time(); });
}

TYPED_TEST(Motions, the_period_closes) {
  const auto& m = this->motion;
  if (!std::isfinite(m.period())) return;
  const Bounds b = m.bounds();
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const double t = this->some_time();
    const FrameMotion now = m.frame_motion(t), later = m.frame_motion(t + m.period());
    worst =
        std::max({worst, norm(now.centre - later.centre) * b.spin,
                  norm(now.velocity - later.velocity), norm(m.spin(t) - m.spin(t + m.period()))});
  }
  stays_below("change over a period [m/s, rad/s]", worst,
              1e-14 * (norm(b.acceleration) + b.angular_acceleration + 1),
              "a few roundings of the time");
}

TYPED_TEST(Motions, turning_begins_at_nothing) {
  if constexpr (std::is_same_v<TypeParam, FigureEight>) this->motion.phase_rock = 0;
  const Rotation r = this->motion.rotation(0);
  EXPECT_NEAR(norm(r.ex - Vec3{1, 0, 0}) + norm(r.ey - Vec3{0, 1, 0}), 0, 1e-15);
}

// kin.21

constexpr double ramp_time = 0.5;  // [s]
/// The motion of a mill that comes to its speed.
template <class M>
ChosenMotion speeding_up(const M& m) {
  return ChosenMotion(programmed(AnyMotion(m), SpeedProgram::ramp(ramp_time)));
}

TYPED_TEST(Motions, begin_at_rest_on_a_ramp_and_run_behind_it_as_half_of_it_earlier) {
  const auto& m = this->motion;
  const ChosenMotion slow = speeding_up(m);
  EXPECT_EQ(norm(slow.frame_motion(0).velocity) + norm(slow.spin(0)), 0);
  EXPECT_EQ(norm(slow.frame_motion(0).acceleration) + norm(slow.angular_acceleration(0)), 0);
  EXPECT_TRUE(same(slow.frame_motion(0).centre, m.frame_motion(0).centre));
  EXPECT_FALSE(std::isfinite(slow.period()));
  for (int i = 0; i < 1000; ++i) {
    const double t = ramp_time + this->some_time(), then = t - 0.5 * ramp_time;
    EXPECT_TRUE(same(slow.frame_motion(t).acceleration, m.frame_motion(then).acceleration));
    EXPECT_TRUE(same(slow.frame_motion(t).velocity, m.frame_motion(then).velocity));
    EXPECT_TRUE(same(slow.spin(t), m.spin(then)));
    EXPECT_TRUE(slow.rotation(t) == m.rotation(then));
  }
}

TYPED_TEST(Motions, have_their_derivatives_on_a_ramp_within_its_bounds) {
  const ChosenMotion m = speeding_up(this->motion);
  const auto some_time = [&] { return this->random.uniform(1e-5, 1.2 * ramp_time); };
  expect_derivatives_of_centre(m, some_time, "kin.21, central differences");
  expect_rate_of_turn(m, some_time, "kin.21");
  expect_bounds(m, some_time);
}

/// Comes to its speed, turns back, and begins anew every 1.3 s.
TYPED_TEST(Motions, have_their_derivatives_with_a_speed_over_time_within_its_bounds) {
  const SpeedProgram to_and_fro({{0, 0}, {0.3, 1}, {0.5, 1}, {0.8, -0.7}, {1.1, -0.7}, {1.3, 0}},
                                true);
  const ChosenMotion m{programmed(AnyMotion(this->motion), to_and_fro)};
  EXPECT_FALSE(std::isfinite(m.period()));
  const auto some_time = [&] { return this->random.uniform(1e-5, 4); };
  expect_derivatives_of_centre(m, some_time, "kin.27, central differences");
  expect_rate_of_turn(m, some_time, "kin.27");
  expect_bounds(m, some_time);
  for (int i = 0; i < 1000; ++i) {
    const double t = some_time();
    const Clock at = to_and_fro.clock(t);
    EXPECT_TRUE(same(m.frame_motion(t).centre, this->motion.frame_motion(at.time).centre));
    EXPECT_TRUE(same(m.spin(t), at.rate * this->motion.spin(at.time)));
    EXPECT_TRUE(m.rotation(t) == this->motion.rotation(at.time));
  }
}

TEST(Tabulated, reproduces_the_motion_its_samples_were_taken_from) {
  std::vector<Sample> samples;
  const double f = 10, a = 0.025;
  constexpr int n = 100;
  for (int i = 0; i <= n; ++i)
    samples.push_back({0.1 * i / n, {0, 0, i == n ? 0 : a * std::sin(2 * pi * i / n)}, 0});
  const Tabulated table(samples);
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const double t = 0.3 * i / 1000;
    worst =
        max_or_nan(worst, std::abs(table.frame_motion(t).centre.z - a * std::sin(2 * pi * f * t)));
  }
  // de Boor: 5/384 of the fourth derivative times the spacing to the fourth, doubled for safety.
  const double w = 2 * pi * f, h = 0.1 / n;
  stays_below("spline against sine [m]", worst, 2 * 5.0 / 384 * a * std::pow(w * h, 4), "de Boor");
}

TEST(Tabulated, refuses_samples_that_make_no_motion) {
  using Samples = std::vector<Sample>;
  EXPECT_THROW(Tabulated(Samples{}), std::invalid_argument);
  EXPECT_THROW(Tabulated(Samples(5)), std::invalid_argument);  // time does not advance
  Samples open{{0, {}, 0}, {1, {}, 0}, {2, {}, 0}, {3, {0.01, 0, 0}, 0}};
  EXPECT_THROW(Tabulated{open}, std::invalid_argument);  // the path is not closed
  open[3].centre = {NAN, 0, 0};
  EXPECT_THROW(Tabulated{open}, std::invalid_argument);
}

}  // namespace
}  // namespace mahlwerk::tests::motions_test
