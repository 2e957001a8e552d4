// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// One ball in sustained contact with the wall: sliding, rolling, release; and inelastic collapse
// where sustained contacts are not modelled.
#include <gtest/gtest.h>

#include <string>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/scene/chamber.hpp"
#include "one_ball.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::lasting_test {
namespace {

using kinematics::Still;

constexpr double r = 0.004;

/// Rules with which a ball that falls by a micrometre enters a sustained contact at once.
event::Rules staying(double mu, double mu_r = 0) {
  event::Rules rules;
  rules.bounce = {0, 1, mu};
  rules.sustained_friction = mu;
  rules.rolling_friction = mu_r;
  return rules;
}

/// A ball a hair above the floor of a wide box at rest.
scene::Ball on_floor(const Vec3& velocity, const Vec3& spin = {}) {
  return ball_a({0, 0, -1 + r + 1e-12}, velocity, spin);
}
const scene::Chamber box{geometry::Cylinder{4, 2}, Still{}, {}, {0, 0, -gravity}};

TEST(Lasting, sliding_turns_into_rolling_at_five_sevenths) {
  const double mu = 0.2, u0 = 0.5, stops = 2 * u0 / (7 * mu * gravity);
  const auto engine = event::one_ball(box, on_floor({u0, 0, 0}), staying(mu));
  Recorder recorder;
  engine->advance(0.5 * stops, recorder);
  const scene::Ball half = engine->balls().front();
  const double t = engine->energy_balance().time;
  states("speed while sliding [m/s]", half.velocity.x, u0 - mu * gravity * t, 1e-6,
         "u0 - mu g t, physics 7.2; contact begins 5e-7 s late");
  states("spin while sliding [m/s]", r * half.spin.y, 2.5 * mu * gravity * t, 3e-6,
         "(5/2) mu g t, physics 7.2");
  engine->advance(2 * stops, recorder);
  const scene::Ball b = engine->balls().front();
  // Sliding ends when the slip is below 1e-4 m/s.
  states("speed in the end [m/s]", b.velocity.x, 5.0 / 7 * u0, 1e-4, "physics 7.2");
  states("it rolls: v - w R [m/s]", b.velocity.x - r * b.spin.y, 0, 1e-12, "no slip");
  const scene::EnergyBalance a = engine->energy_balance();
  states("energy lost by sliding [J]", a.lost(), 0.5 * ball_a().mass() * 2.0 / 7 * u0 * u0, 1e-9,
         "1/2 (2/7) m u0^2");
}

TEST(Lasting, time_in_contact_ends_at_the_time_asked_for) {
  // A ball falls by h and bounces at e until it rests, 3 t_0 after the start if e = 1/2 and
  // t_0 = sqrt(2 h/g). The rest of the second is one sustained contact, whose steps become long.
  const double h = 0.2, t0 = std::sqrt(2 * h / gravity);
  event::Rules rules;
  rules.bounce = {0.5, 1, 0.2};
  const auto engine = event::one_ball(box, ball_a({0, 0, -1 + r + h}), rules);
  Recorder recorder;
  for (const double time : {0.7, 0.9, 0.95, 1.0}) {
    engine->advance(time, recorder);
    states("time reached [s]", engine->energy_balance().time, time, 0, "as asked for");
    // The contact begins at the bounce slower than 0.1 mm/s, at most 4 w/g early.
    states("time in contact [s]", engine->energy_balance().contact_time, time - 3 * t0,
           4e-4 / gravity, "t - t_0 (1 + e)/(1 - e)");
  }
}

TEST(Lasting, a_ball_that_rolls_is_where_it_should_be_at_the_time_asked_for) {
  const double u0 = 0.3, mu_r = 0.02, deceleration = 5.0 / 7 * mu_r * gravity;
  const auto engine =
      event::one_ball(box, on_floor({u0, 0, 0}, {0, u0 / r, 0}), staying(0.5, mu_r));
  Recorder recorder;
  for (const double t : {0.1, 0.1234, 0.7}) {
    engine->advance(t, recorder);
    const scene::EnergyBalance a = engine->energy_balance();
    states("time [s]", a.time, t, 0, "as asked for");
    states("place [m]", engine->balls().front().position.x, u0 * t - 0.5 * deceleration * t * t,
           1e-6, "u t - a t^2/2, a = (5/7) mu_r g");
    states("loss [J]", a.lost(),
           mu_r * ball_a().mass() * gravity * (u0 * t - 0.5 * deceleration * t * t), 1e-9,
           "mu_r m g x");
    states("balance [J]", a.residual(), 0, 1e-12, "closed at any time");
  }
}

TEST(Lasting, rolling_resistance_slows_by_five_sevenths_mu_r_g) {
  const double mu_r = 0.02, u0 = 0.3;
  const auto engine =
      event::one_ball(box, on_floor({u0, 0, 0}, {0, u0 / r, 0}), staying(0.5, mu_r));
  Recorder recorder;
  engine->advance(0.5, recorder);
  const double t = engine->energy_balance().time;
  states("speed after a while [m/s]", engine->balls().front().velocity.x,
         u0 - 5.0 / 7 * mu_r * gravity * t, 1e-6,
         "a = (5/7) g (sin a - mu_r cos a) on the level, physics 7.2");
}

TEST(Lasting, a_ball_rolls_down_an_incline_at_five_sevenths_or_slips_when_it_is_steep) {
  for (const double angle : {0.3, 1.2}) {
    scene::Chamber incline = box;
    incline.gravity = gravity * Vec3{std::sin(angle), 0, -std::cos(angle)};
    const double mu = 0.2, t = 0.2;
    const auto engine = event::one_ball(incline, on_floor({}), staying(mu));
    Recorder recorder;
    engine->advance(t, recorder);
    const bool rolls = std::tan(angle) <= 3.5 * mu;
    const double a = rolls ? 5.0 / 7 * gravity * std::sin(angle)
                           : gravity * (std::sin(angle) - mu * std::cos(angle));
    states(rolls ? "rolling [m/s2]" : "slipping [m/s2]",
           engine->balls().front().velocity.x / engine->energy_balance().time, a, 1e-4 * a,
           "physics 7.2");
  }
}

TEST(Lasting, ball_in_a_still_cylinder_swings_like_a_rolling_pendulum) {
  const double big = 0.05, rho = big - r, angle = 0.02;
  const scene::Chamber trough{
      geometry::Cylinder{2 * big, 0.2}, Still{}, scene::mounted_along({1, 0, 0}), {0, 0, -gravity}};
  const Vec3 start = (rho - 1e-12) * Vec3{0, std::sin(angle), -std::cos(angle)};
  const auto engine = event::one_ball(trough, ball_a(start), staying(1));
  Recorder recorder;
  const double period = 2 * std::numbers::pi * std::sqrt(7 * rho / (5 * gravity));
  int passes = 0;
  double last = start.y, first_pass = 0, last_pass = 0;
  for (double t = 1e-4; t < 10.25 * period; t += 1e-4) {
    engine->advance(t, recorder);
    const scene::Ball b = engine->balls().front();
    if (b.position.y * last < 0) {
      const double now = engine->energy_balance().time, w = 2 * std::numbers::pi / period;
      // Time since the zero crossing of a sinusoidal swing.
      const double back = std::atan(w * b.position.y / b.velocity.y) / w;
      (passes++ == 0 ? first_pass : last_pass) = now - back;
    }
    last = b.position.y;
  }
  const double finite_swing = 1 + angle * angle / 16;
  states("period [s]", 2 * (last_pass - first_pass) / (passes - 1), period * finite_swing,
         1e-6 * period, "2 pi sqrt(7 rho / 5 g), amplitude 0.02 rad");
}

/// Release: a ball that rolls up the inside of a loop leaves the wall where the wall would have to
/// pull.
TEST(Lasting, a_ball_too_slow_for_the_loop_leaves_it_where_the_wall_would_have_to_pull) {
  const double big = 0.05, rho = big - r, v0 = std::sqrt(5.0 * gravity * rho / 2.0 * 1.2);
  const scene::Chamber loop{
      geometry::Cylinder{2 * big, 0.2}, Still{}, scene::mounted_along({1, 0, 0}), {0, 0, -gravity}};
  const auto engine =
      event::one_ball(loop, ball_a({0, 0, -rho + 1e-12}, {0, v0, 0}, {-v0 / r, 0, 0}), staying(20));
  Recorder recorder;
  double t = 0;
  while (engine->energy_balance().lasting_contacts == 0) engine->advance(t += 1e-6, recorder);
  const double before = t;
  while (engine->energy_balance().time - engine->energy_balance().contact_time < before + 1e-5)
    engine->advance(t += 1e-5, recorder);
  // v^2 = v0^2 - (10/7) g rho (1 - cos). Release at v^2 = -g rho cos:
  // cos = (10/7 - v0^2/(g rho)) / (17/7).
  const double cosine = (10.0 / 7 - v0 * v0 / (gravity * rho)) / (17.0 / 7);
  const scene::Ball b = engine->balls().front();
  states("height at which it lets go [m]", b.position.z, -rho * cosine, 2e-5,
         "energy and N = 0; looked at every 1e-5 s");
}

TEST(Lasting, ball_in_a_turning_drum_stays_at_the_bottom_and_turns_with_the_wall) {
  const double big = 0.05, speed = 5;
  const scene::Chamber drum{geometry::Cylinder{2 * big, 0.1},
                            kinematics::Tumbling{.speed = speed},
                            scene::mounted_along({1, 0, 0}),
                            {0, 0, -gravity}};
  event::Rules rules = staying(0.5);
  const double rho = big - r;
  const auto engine =
      event::one_ball(drum, ball_a({0, 0, -rho + 1e-12}, {}, {speed * big / r, 0, 0}), rules);
  Recorder recorder;
  engine->advance(2, recorder);
  const scene::Ball b = engine->balls().front();
  states("height [m]", b.position.z, -rho, 1e-9, "no rolling friction: at the bottom, physics 7.2");
  states("ball surface speed w_b R_b [m/s]", b.spin.x * r, speed * big, 1e-6,
         "= W R_v, physics 7.2");
}

TEST(Lasting, a_drum_beyond_its_critical_speed_carries_the_ball_round) {
  const double big = 0.05, rho = big - r, critical = std::sqrt(gravity / rho);
  for (const double share : {0.95, 1.05}) {
    const double speed = share * critical;
    const scene::Chamber drum{geometry::Cylinder{2 * big, 0.1},
                              kinematics::Tumbling{.speed = speed},
                              scene::mounted_along({1, 0, 0}),
                              {0, 0, -gravity}};
    // The ball moves with the wall without slip: v = W x r and w = W.
    const auto engine =
        event::one_ball(drum, ball_a({0, 0, -rho + 1e-12}, {0, speed * rho, 0}, {speed, 0, 0}),
                        staying(INFINITY, 3.0));
    Recorder recorder;
    engine->advance(0.5, recorder);  // more than a turn
    const scene::EnergyBalance a = engine->energy_balance();
    if (share > 1)
      stays_below("time off the wall above critical speed [s]", a.time - a.contact_time, 1e-5,
                  "W_c = sqrt(g/(R_v - R_b)), physics 1.6");
    else
      EXPECT_GT(a.time - a.contact_time, 0.01) << "below critical speed the ball must fall";
  }
}

/// The ball is pressed to the side of the drum and hardly to its end. It touches the end at ever
/// smaller speeds.
TEST(Collapse, a_ball_rolling_along_the_side_of_a_drum_settles_against_its_end) {
  const double critical = std::sqrt(gravity / (0.05 - r));
  for (const double share : {0.2, 0.5, 1.2})
    for (const double mu : {0.3, 1e5}) {
      const scene::Chamber drum{geometry::Cylinder{0.1, 0.05},
                                kinematics::Tumbling{.speed = share * critical},
                                scene::mounted_along({1, 0, 0}),
                                {0, 0, -gravity}};
      event::Rules rules;
      rules.bounce = {0.3, 0, mu};
      rules.sustained_friction = mu;
      const auto engine =
          event::one_ball(drum, ball_a({0.001, 0.002, -0.001}, {0.3, -0.02, 0.05}), rules);
      Recorder recorder;
      ASSERT_NO_THROW(engine->advance(5, recorder)) << share << " of critical, mu " << mu;
      const scene::EnergyBalance a = engine->energy_balance();
      stays_below("balance, relative to the energy turned over",
                  std::abs(a.residual()) / (a.initial_energy + std::abs(a.wall_work) + a.lost()),
                  1e-6, "evt.18");
    }
}

TEST(Collapse, a_ball_without_restitution_collides_once_and_skims_the_wall) {
  scene::Chamber weightless = box;
  weightless.gravity = {};
  std::int64_t most = 0;
  for (int i = 1; i <= 50; ++i) {
    event::Rules rules;
    rules.bounce = {0, 1, 0};
    const double up = 2.0 + 0.037 * i;  // the ends are reached within 1 s, the side is not
    const auto engine = event::one_ball(weightless, ball_a({}, {0.4, 0.0113 * i, up}), rules);
    Recorder recorder;
    engine->advance(2, recorder);
    most = max_or_nan(most, engine->energy_balance().collisions);
    states("height it skims at [m]", engine->balls().front().position.z, 1 - r, 1e-9 * r,
           "it keeps no normal speed, and no more than a thousand margins are given (evt.5)");
  }
  EXPECT_EQ(most, 1);
}

/// Three normal forces from three contact conditions: each is the component of gravity along its
/// normal. The ball can only spin, and rolling resistance and friction stop the spin.
TEST(Lasting, a_ball_in_the_corner_of_a_box_is_held_by_three_faces) {
  const double side = 0.05, g = gravity;
  const scene::Chamber corner{
      geometry::Box{side, side, side}, Still{}, {}, {-0.6 * g, -0.48 * g, -0.64 * g}};
  event::Rules rules;
  rules.bounce = {0.3, 0, 0.4};
  const auto engine =
      event::one_ball(corner, ball_a({0.002, 0.001, 0}, {0.1, 0.2, -0.1}, {20, 5, 3}), rules);
  Recorder recorder;
  engine->advance(3, recorder);
  const scene::Ball b = engine->balls().front();
  const double rest = -0.5 * side + r;
  states("distance from the corner's place [m]", norm(b.position - Vec3{rest, rest, rest}), 0,
         1e-9 * r, "touches three faces");
  states("speed [m/s]", norm(b.velocity), 0, 1e-12, "held by three faces");
  states("surface speed [m/s]", r * norm(b.spin), 0, 1e-5,
         "friction at three contacts leaves no spin; creeping at 1 mm/s dies out (evt.17)");
  const scene::EnergyBalance a = engine->energy_balance();
  EXPECT_GT(a.contact_time, 2);
  stays_below("balance, relative to the energy turned over",
              std::abs(a.residual()) / (std::abs(a.initial_energy) + a.lost()), 1e-6, "evt.18");
}

TEST(Lasting, a_ball_leaves_a_corner_when_a_face_would_have_to_pull) {
  const double side = 0.05, f = 2, amplitude = 0.1;  // w^2 A = 15.8 m/s2 > g
  const scene::Chamber shaker{
      geometry::Box{side, side, side}, shaken(f, amplitude), {}, {-1, -1, -gravity}};
  event::Rules rules;
  rules.bounce = {0, 0, 0};
  rules.sustained_friction = 0;
  const double rest = -0.5 * side + r;
  const auto engine =
      event::one_ball(shaker, ball_a({rest + 1e-12, rest + 1e-12, rest + 1e-12}), rules);
  Recorder recorder;
  const double w = 2 * std::numbers::pi * f;
  const double leaves = std::asin(gravity / (amplitude * w * w)) / w;  // A w^2 sin(w t) = g
  engine->advance(leaves - 1e-4, recorder);
  states("height while held [m]", engine->balls().front().position.z, rest, 1e-12, "N > 0");
  engine->advance(leaves + 0.02, recorder);
  const scene::Ball b = engine->balls().front();
  const double at = engine->energy_balance().time, s = at - leaves;
  const double rode = amplitude * std::sin(w * leaves);
  const double speed = amplitude * w * std::cos(w * leaves);
  states("height after it was let go [m]", b.position.z,
         rest + rode + speed * s - 0.5 * gravity * s * s - amplitude * std::sin(w * at), 1e-7,
         "free vertically from N = 0 on, held by the two sides still");
  states("distance from the two sides [m]", std::hypot(b.position.x - rest, b.position.y - rest), 0,
         1e-12, "they still press");
}

TEST(Collapse, without_a_remedy_the_guard_stops_the_run_and_says_why) {
  event::Rules rules = rules_a(0.5);
  rules.sustained_mode = event::SustainedContactMode::none;
  const auto engine = event::one_ball(box, ball_a({0, 0, -1 + r + 0.01}), rules);
  Recorder recorder;
  try {
    engine->advance(10, recorder);
    FAIL() << "the bounces of a ball on a still floor have a limit in time";
  } catch (const RunError& e) {
    EXPECT_NE(std::string(e.what()).find("lasting = \"none\". Leave it out: one ball then rolls"),
              std::string::npos)
        << e.what();
  }
  EXPECT_GT(recorder.all.size(), 1000U) << "what was computed is handed over";
}

TEST(Collapse, tc_rule_keeps_bouncing_without_loss) {
  event::Rules rules = rules_a(0.5);
  rules.sustained_mode = event::SustainedContactMode::tc;
  const auto engine = event::one_ball(box, ball_a({0, 0, -1 + r + 0.01}), rules);
  Recorder recorder;
  engine->advance(1, recorder);
  const scene::EnergyBalance a = engine->energy_balance();
  EXPECT_GT(a.tc_collisions, 1000);
  EXPECT_EQ(a.lasting_contacts, 0);
  states("balance [J]", a.residual(), 0,
         static_cast<double>(a.collisions) * 2.2e-16 * ball_a().mass() * gravity,
         "elastic bounces lose nothing; a rounding of m g (1 m) each");
}

/// Rates of collisions faster than 0.1 m/s, per second of free flight, hardly depend on the
/// treatment of inelastic collapse.
TEST(Collapse, rolling_and_the_tc_rule_agree_on_collisions_per_second_of_flight) {
  const auto rate = [](event::SustainedContactMode lasting) {
    double hits = 0, flight = 0;
    for (std::uint32_t i = 0; i < 4; ++i) {
      event::Rules rules = rules_a();
      rules.sustained_mode = lasting;
      const auto engine = event::one_ball(
          mill_a(), ball_a({0, 0, 0.003 * i}, {0.03, 0.02 * i, 0.05}, {0.05, 0, 0.01 * i}), rules);
      Recorder recorder;
      engine->advance(120, recorder);
      for (const auto& c : recorder.all) hits += c.approach > 0.1;
      flight += engine->energy_balance().time - engine->energy_balance().contact_time;
    }
    return hits / flight;
  };
  const double rolling = rate(event::SustainedContactMode::roll),
               tc = rate(event::SustainedContactMode::tc);
  // Replicates of 120 s scatter by about 1 %; there are four of each. 3 % is the agreement that the
  // peers report.
  states("rate above 0.1 m/s per second of flight [1/s]", rolling, tc, 0.03 * tc, "TC with 1e-4 s");
  states("the same with the TC rule [1/s]", tc, 159.2, 0.03 * 159.2, "physics 7.4: 159.2 +- 1");
}

}  // namespace
}  // namespace mahlwerk::tests::lasting_test
