// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Films on the bodies in the event engine: restitution by Stokes number (docs/theory/liquid.md).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "one_ball.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::wet_bounce_test {
namespace {

contact::Liquid oil_film() {
  contact::Liquid liquid;
  liquid.viscosity = 0.1;
  liquid.film = 50e-6;
  liquid.roughness = 2e-6;
  return liquid;
}

event::Rules wet_rules(double e, event::SustainedContactMode mode) {
  event::Rules rules;
  rules.bounce = {e, 0, 0.3};
  rules.sustained_mode = mode;
  rules.liquid = oil_film();
  return rules;
}

/// A ball thrown at the floor of a wide jar at rest, without gravity.
struct Thrown {
  scene::Ball after;
  scene::Collision record;
  scene::EnergyBalance energy_balance;
};
Thrown thrown(const event::Rules& rules, const Vec3& velocity) {
  const scene::Chamber still{geometry::Cylinder{2, 2}, kinematics::Still{}, {}, {}};
  const auto engine = event::one_ball(still, ball_a({0, 0, -1 + 0.004 + 1e-3}, velocity), rules);
  Recorder recorder;
  engine->advance(1.5e-3 / -velocity.z, recorder);
  EXPECT_EQ(recorder.all.size(), 1U);
  return {engine->balls().front(), recorder.all.empty() ? scene::Collision{} : recorder.all[0],
          engine->energy_balance()};
}

TEST(WetBounce, of_a_ball_on_the_wall_has_the_restitution_of_its_stokes_number) {
  const contact::Liquid film = oil_film();
  const double m = ball_a().mass(), critical = film.critical_speed(0.004, m);
  // The closed form once more: 6 pi eta R^2 / m times ln(2 film / roughness).
  states("critical speed [m/s]", critical,
         6 * std::numbers::pi * 0.1 * 0.004 * 0.004 / m * math::log(50.0), 1e-15, "(liq.4)");
  for (const double e : {1.0, 0.8, 0.3})
    for (const double ratio : {0.5, 1.01, 2.0, 10.0, 1000.0}) {
      const double speed = ratio * critical;
      const Thrown t = thrown(wet_rules(e, event::SustainedContactMode::none), {0, 0, -speed});
      const double expected = ratio > 1 ? e * (1 - 1 / ratio) : 0;
      states(fmt::format("e = {}, St = {} St_c: rebound over approach", e, ratio),
             t.after.velocity.z / speed, expected, 1e-12,
             "e_dry (1 - St_c/St), Davis et al. 1986 (liq.4)");
      const double touch = std::max(0.0, speed - critical);
      states("loss in the liquid [J]", t.energy_balance.lost_liquid,
             0.5 * m * (speed * speed - touch * touch), 1e-12 * m * speed * speed, "(liq.3)");
      states("approach recorded: at touch [m/s]", t.record.approach, touch, 1e-12 * speed,
             "(liq.3)");
      stays_below("energy balance [J]", std::abs(t.energy_balance.residual()),
                  1e-12 * m * speed * speed, "evt.8");
    }
}

TEST(WetBounce, has_the_friction_of_the_bodies_that_touch) {
  const contact::Liquid film = oil_film();
  const double m = ball_a().mass(), critical = film.critical_speed(0.004, m);
  const double speed = 3 * critical;
  const Thrown t =
      thrown(wet_rules(0.5, event::SustainedContactMode::none), {100 * speed, 0, -speed});
  states("tangential impulse over mass [m/s]", 100 * speed - t.after.velocity.x,
         0.3 * 1.5 * (speed - critical), 1e-11 * speed, "mu (1 + e) times the speed at touch");
}

TEST(WetBounce, of_two_balls_has_the_restitution_of_their_stokes_number) {
  const scene::Chamber still{geometry::Cylinder{2, 2}, kinematics::Still{}, {}, {}};
  const contact::Liquid film = oil_film();
  scene::Ball a{0.005, 7850, {-0.02, 0, 0}, {}, {}}, b{0.003, 7850, {0.02, 0, 0}, {}, {}};
  const double radius = a.radius * b.radius / (a.radius + b.radius);
  const double mass = a.mass() * b.mass() / (a.mass() + b.mass());
  const double critical = film.critical_speed(radius, mass);
  for (const auto mode : {event::SustainedContactMode::none, event::SustainedContactMode::tc})
    for (const double ratio : {1.5, 4.0, 100.0}) {
      const double speed = ratio * critical;
      a.velocity = {speed, 0, 0};
      const auto engine = event::many_balls(still, {a, b}, wet_rules(0.8, mode),
                                            {1, geometry::faces(*still.shape), {0.8, 0, 0.3}});
      Recorder recorder;
      engine->advance(0.06 / speed, recorder);
      ASSERT_EQ(recorder.all.size(), 1U);
      const auto after = engine->balls();
      states(fmt::format("St = {} St_c: e", ratio),
             (after[1].velocity.x - after[0].velocity.x) / speed, 0.8 * (1 - 1 / ratio), 1e-12,
             "e_dry (1 - St_c/St), Davis et al. 1986 (liq.4)");
      const scene::EnergyBalance e = engine->energy_balance();
      stays_below("energy balance over energy", std::abs(e.residual()) / e.initial_energy, 1e-12,
                  "evt.8");
    }
}

TEST(WetBounce, lets_a_ball_come_to_rest_that_rebounds_below_the_critical_speed) {
  const scene::Chamber still{
      geometry::Cylinder{0.1, 0.1}, kinematics::Still{}, {}, {0, 0, -gravity}};
  const auto engine = event::one_ball(still, ball_a({0, 0, -0.03}),
                                      wet_rules(0.9, event::SustainedContactMode::roll));
  Recorder recorder;
  engine->advance(5, recorder);
  const scene::EnergyBalance e = engine->energy_balance();
  EXPECT_GE(e.lasting_contacts, 1);
  states("height of the ball's bottom [m]", engine->balls()[0].position.z + 0.05 - 0.004, 0, 1e-9,
         "at rest");
  stays_below("energy balance over energy", std::abs(e.residual()) / e.lost(), 1e-9, "evt.8");
}

/// The small bounces of the TC rule stand for sustained contacts. If films stopped them, bounces
/// would collapse: balls at rest would collide at no speed without end.
TEST(WetBounce, leaves_the_bounces_of_sustained_contacts_alone) {
  const scene::Chamber still{
      geometry::Cylinder{0.03, 0.03}, kinematics::Still{}, {}, {0, 0, -gravity}};
  std::vector<scene::Ball> balls;
  for (int i = 0; i < 8; ++i)
    balls.push_back(
        {0.004,
         7850,
         {0.009 * (i % 2) - 0.0045, 0.009 * (i / 2 % 2) - 0.0045, 0.0095 * (i / 4) - 0.0045},
         {0.1 * (i - 3), 0.07 * i, 0},
         {}});
  const auto engine =
      event::many_balls(still, balls, wet_rules(0.8, event::SustainedContactMode::tc),
                        {1, geometry::faces(*still.shape), {0.8, 0, 0.3}});
  Recorder recorder;
  engine->advance(1, recorder);
  const scene::EnergyBalance e = engine->energy_balance();
  EXPECT_NEAR(e.time, 1, 1e-12);
  EXPECT_GT(e.lost_liquid, 0);
  stays_below("energy balance over energy lost", std::abs(e.residual()) / e.lost(), 1e-9, "evt.8");
}

}  // namespace
}  // namespace mahlwerk::tests::wet_bounce_test
