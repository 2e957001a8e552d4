// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Closed forms for the motion of one or two balls: bouncing, sliding, rolling down a slope, and the
// conserved quantities of a collision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::closed_forms_test {
namespace {

using contact::HertzMindlin;
using contact::LinearSpring;
using contact::Rolling;

constexpr contact::ElasticConstants soft_steel{1e9, 0.3};

/// A ball on the floor of a box, at the overlap that its load [N] gives.
struct Resting {
  scene::Ball ball{0.005, 7850, {}, {}, {}};
  contact::Pair pair;
  double side = 10, depth = 0, step = 0;

  Resting(double load_acceleration, double mu, double rolling = 0)
      : pair(pair_of(soft_steel, rigid, 0.5, mu)) {
    pair.rolling_friction = rolling;
    const contact::EffectivePair t = touching(pair, ball);
    depth = std::pow(ball.mass() * load_acceleration / contact::hertz_stiffness(t), 2.0 / 3);
    ball.position = {0, 0, -0.5 * side + ball.radius - depth};
    // A ball at rest oscillates on its contact with omega^2 = 1.5 g / depth.
    step = 0.02 / std::sqrt(1.5 * load_acceleration / depth);
  }
  std::unique_ptr<scene::Engine> engine(const Vec3& pull, Rolling rolls = Rolling::none) const {
    return soft_engine(still_box(side, pull), {ball}, of_law(HertzMindlin{}, rolls), pair, step);
  }
};

TEST(ClosedForms, heights_of_a_bouncing_ball_fall_by_e_squared) {
  const double e = 0.8, height = 0.05, side = 0.2;
  const contact::Pair pair = pair_of({70e9, 0.3}, rigid, e);
  scene::Ball ball{0.005, 7850, {}, {}, {}};
  ball.position.z = -0.5 * side + ball.radius + height;
  const double speed = std::sqrt(2 * gravity * height);
  const auto law = of_law(HertzMindlin{});
  const double contact = contact_time(law, touching(pair, ball), speed);
  const auto engine =
      soft_engine(still_box(side, {0, 0, -gravity}), {ball}, law, pair, contact / 200, true);
  Recorder recorder;
  engine->advance(speed / gravity * (1 + e) / (1 - e), recorder);
  ASSERT_GE(recorder.all.size(), 8U);
  double touch = speed / gravity;
  for (int n = 0; n < 8; ++n) {
    const scene::Collision& c = recorder.all[static_cast<std::size_t>(n)];
    const double wanted = height * std::pow(e, 2 * n);
    // At this step and e, each bounce has an error of 2e-4 in e. Slow bounces last longer, and the
    // weight changes their e by g t_c / v.
    const double off = 2 * n * (2e-4 / e + gravity * contact / c.approach);
    states("height before bounce " + std::to_string(n + 1) + " [m]",
           c.approach * c.approach / (2 * gravity), wanted, (off + 1e-4) * wanted, "h e^(2n)");
    states("time of bounce " + std::to_string(n + 1) + " [s]", c.time, touch,
           (off + 1e-4) * touch + 2 * n * contact, "sum of flights");
    touch += 2 * std::pow(e, n + 1) * speed / gravity;
  }
}

TEST(ClosedForms, a_sliding_ball_comes_to_roll_at_five_sevenths_of_its_speed) {
  const double mu = 0.3, u0 = 0.5, until_rolling = 2 * u0 / (7 * mu * gravity);
  Resting r(gravity, mu);
  r.ball.velocity.x = u0;
  const auto engine = r.engine({0, 0, -gravity});
  Recorder none;
  const double shorter = r.depth / r.ball.radius, stiffness_correction = 4 * r.step / until_rolling;
  for (const double part : {0.25, 0.5, 0.9}) {
    engine->advance(part * until_rolling, none);
    const double t = engine->energy_balance().time;
    const scene::Ball b = engine->balls()[0];
    const std::string at = " at " + std::to_string(part).substr(0, 4) + " of the time to roll";
    states("speed [m/s]" + at, b.velocity.x, u0 - mu * gravity * t, 1e-3 * u0, "u0 - mu g t");
    states("w R [m/s]" + at, b.spin.y * b.radius, 2.5 * mu * gravity * t,
           (shorter + stiffness_correction + 1e-3) * u0, "(5/2) mu g t");
  }
  engine->advance(2 * until_rolling, none);
  const scene::Ball b = engine->balls()[0];
  states("speed of rolling [m/s]", b.velocity.x, 5.0 / 7 * u0, (shorter + 1e-4) * u0, "(5/7) u0");
  states("w R of rolling [m/s]", b.spin.y * b.radius, 5.0 / 7 * u0, (shorter + 1e-4) * u0,
         "(5/7) u0");
}

/// Acceleration down a slope of angle `a`, once the contact has settled.
double down_the_slope(double a, double mu, double rolling, Rolling rule,
                      double* spin_up = nullptr) {
  const Resting r(gravity * std::cos(a), mu, rolling);
  const auto engine = r.engine({gravity * std::sin(a), 0, -gravity * std::cos(a)}, rule);
  Recorder none;
  engine->advance(0.05, none);
  const scene::Ball from = engine->balls()[0];
  const double t = engine->energy_balance().time;
  engine->advance(0.3, none);
  const scene::Ball to = engine->balls()[0];
  const double time = engine->energy_balance().time - t;
  if (spin_up != nullptr) *spin_up = (to.spin.y - from.spin.y) / time;
  return (to.velocity.x - from.velocity.x) / time;
}

TEST(ClosedForms, a_ball_rolls_or_slides_down_a_slope) {
  for (const double a : {0.1, 0.3, 0.6}) {
    const std::string at = ", slope " + std::to_string(a).substr(0, 3);
    // The lever is shorter by 3e-5 of the radius, and the tangential spring of a rolling ball still
    // oscillates.
    const double rolls = 5.0 / 7 * gravity * std::sin(a);
    states("rolling [m/s2]" + at, down_the_slope(a, 0.5, 0, Rolling::none), rolls, 1e-3 * rolls,
           "(5/7) g sin a, tan a < (7/2) mu");
    const double mu = 0.02, slides = gravity * (std::sin(a) - mu * std::cos(a));
    double spin_up = 0;
    states("sliding [m/s2]" + at, down_the_slope(a, mu, 0, Rolling::none, &spin_up), slides,
           1e-3 * slides, "g (sin a - mu cos a), tan a > (7/2) mu");
    const double turns = 2.5 * mu * gravity * std::cos(a) / 0.005;
    states("spinning up [rad/s2]" + at, spin_up, turns, 1e-3 * turns, "(5/2) mu g cos a / R");
    const double mu_r = 0.05, braked = 5.0 / 7 * gravity * (std::sin(a) - mu_r * std::cos(a));
    states("rolling against cdt [m/s2]" + at, down_the_slope(a, 0.5, mu_r, Rolling::cdt), braked,
           1e-3 * braked, "(5/7) g (sin a - mu_r cos a)");
  }
}

TEST(ClosedForms, a_ball_stays_on_a_slope_that_rolling_friction_holds) {
  const double a = 0.1, mu_r = 0.2;
  for (const Rolling rule : {Rolling::cdt, Rolling::epsd}) {
    const Resting r(gravity * std::cos(a), 0.5, mu_r);
    const auto engine = r.engine({gravity * std::sin(a), 0, -gravity * std::cos(a)}, rule);
    Recorder none;
    engine->advance(0.2, none);
    const scene::Ball settled = engine->balls()[0];
    engine->advance(1.2, none);
    const scene::Ball later = engine->balls()[0];
    const double moved = norm(later.position - settled.position);
    if (rule == Rolling::cdt)
      // The torque is I w/(16 dt) at most and holds m g R sin a, so R w = 40 g sin a dt. One step
      // of the sampling time is added.
      stays_below("creep in 1 s, cdt [m]", moved, 1.001 * 40 * gravity * std::sin(a) * r.step,
                  "40 g sin a dt, mu_r > tan a (dem.22)");
    else
      stays_below("moved in 1 s, epsd [m]", moved, 1e-9, "at rest, mu_r > tan a");
  }
}

std::vector<scene::Ball> unequal() {
  return {{0.004, 7850, {}, {2.0, 1.0, -0.5}, {100, -50, 30}},
          {0.007, 2500, {}, {-1.5, 0.3, 0.4}, {-20, 60, 10}}};
}

TEST(ClosedForms, an_oblique_collision_keeps_momentum_and_angular_momentum) {
  for (const Rolling rule : {Rolling::none, Rolling::cdt, Rolling::viscous, Rolling::epsd}) {
    contact::Pair pair = pair_of({1e9, 0.3}, {70e9, 0.2}, 0.6, 0.3);
    pair.rolling_friction = 0.05;
    const Impact i = impact(unequal(), pair, of_law(HertzMindlin{}, rule), 1.0 / 200);
    ASSERT_EQ(i.energy_balance.collisions, 1);
    Vec3 momentum{}, angular{};
    double size = 0, turning = 0;
    const auto add = [&](const std::vector<scene::Ball>& balls, double sign) {
      for (const scene::Ball& b : balls) {
        const Vec3 p = b.mass() * b.velocity, l = cross(b.position, p) + b.inertia() * b.spin;
        momentum += sign * p;
        angular += sign * l;
        size += 0.5 * norm(p), turning += 0.5 * norm(l);
      }
    };
    add(i.before, -1);
    add(i.after, 1);
    const std::string with = ", rolling rule " + std::to_string(static_cast<int>(rule));
    stays_below("momentum, relative" + with, norm(momentum) / size, 1e-12, "Newton's third law");
    stays_below("angular momentum, relative" + with, norm(angular) / turning, 1e-12,
                "one lever for both");
  }
}

/// Relative gain of kinetic energy in a collision: e = 1 along the normal, no slip and no damping
/// across it.
double gained(const contact::ContactModel& law, double spin) {
  std::vector<scene::Ball> balls = unequal();
  balls[0].spin = {0, spin, -spin};
  const Impact i = impact(balls, pair_of({70e9, 0.3}, {70e9, 0.3}, 1, INFINITY), law, 1.0 / 1000);
  const auto kinetic = [](const std::vector<scene::Ball>& all) {
    double sum = 0;
    for (const scene::Ball& b : all)
      sum += 0.5 * (b.mass() * squared(b.velocity) + b.inertia() * squared(b.spin));
    return sum;
  };
  return kinetic(i.after) / kinetic(i.before) - 1;
}

/// Tangential springs of constant stiffness conserve energy. The stiffness of Mindlin's spring
/// falls with the normal load, regardless of the energy stored in it. The test prints the resulting
/// loss.
TEST(ClosedForms, an_elastic_oblique_collision_without_slip_makes_no_energy) {
  double linear = 0, plain = 0, rescaled = 0, min_plain = 0, min_rescaled = 0;
  for (const double spin : {-400.0, -100.0, 0.0, 150.0, 500.0}) {
    contact::ContactModel law = of_law(LinearSpring{});
    linear = max_or_nan(linear, std::abs(gained(law, spin)));
    law = of_law(HertzMindlin{});
    plain = max_or_nan(plain, gained(law, spin));
    min_plain = std::min(min_plain, gained(law, spin));
    law.rescaled_unloading = true;
    rescaled = max_or_nan(rescaled, gained(law, spin));
    min_rescaled = std::min(min_rescaled, gained(law, spin));
  }
  stays_below("energy changed, linear-spring, relative", linear, 1e-3, "e = 1, mu infinite");
  stays_below("energy gained, hertz-mindlin, relative", plain, 1e-3, "e = 1, mu infinite");
  stays_below("energy gained, rescaled_unloading, relative", rescaled, 1e-3, "e = 1, mu infinite");
  std::printf("    lost at most: hertz-mindlin %.2g, with rescaled_unloading %.2g\n", -min_plain,
              -min_rescaled);
}

/// The same collision in the middle of a periodic box and across its edges.
TEST(ClosedForms, balls_collide_across_the_edges_of_a_periodic_box_as_in_its_middle) {
  const contact::Pair pair = pair_of({1e9, 0.3}, {1e9, 0.3}, 0.7, 0.3);
  const double side = 0.06;
  const scene::Chamber box{geometry::PeriodicBox{side, side, side}, kinematics::Still{}, {}, {}};
  const auto after = [&](const Vec3& place) {
    std::vector<scene::Ball> balls = unequal();
    const Vec3 apart{0.009, 0.005, -0.005};
    balls[0].position = place - 0.5 * apart;
    balls[1].position = place + 0.5 * apart;
    const auto engine = soft_engine(box, balls, of_law(HertzMindlin{}), pair, 1e-7);
    Recorder recorder;
    engine->advance(0.005, recorder);
    EXPECT_EQ(recorder.all.size(), 1U);
    return engine->balls();
  };
  const auto middle = after({});
  for (const Vec3& place : {Vec3{0.5 * side, 0, 0}, Vec3{0, -0.5 * side, 0.5 * side},
                            Vec3{0.5 * side, 0.5 * side, 0.5 * side}}) {
    const auto edge = after(place);
    double worst = 0;
    for (std::size_t b = 0; b < 2; ++b)
      worst = std::max({worst, norm(edge[b].velocity - middle[b].velocity),
                        1e-2 * norm(edge[b].spin - middle[b].spin)});
    // Rounding of positions: 1e-17 m over overlaps of 1e-5 m, and speeds of 1 m/s.
    stays_below("speeds after, across an edge [m/s]", worst, 1e-10, "it repeats itself");
  }
}

}  // namespace
}  // namespace mahlwerk::tests::closed_forms_test
