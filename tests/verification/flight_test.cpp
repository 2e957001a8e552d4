// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Free flights, and the search for the touch that ends them.
#include <gtest/gtest.h>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/event/search.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/scene/chamber.hpp"
#include "one_ball.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::flight_test {
namespace {

TEST(Flight, free_fall_is_a_parabola) {
  const scene::Chamber still{geometry::Cylinder{2, 2}, kinematics::Still{}, {}, {0, 0, -gravity}};
  const Vec3 start{0.1, -0.2, 0.5}, velocity{0.3, 0.1, 1.0};
  const auto engine = event::one_ball(still, ball_a(start, velocity), rules_a());
  Recorder recorder;
  double worst = 0;
  for (int i = 1; i <= 50; ++i) {
    const double t = 0.01 * i;
    engine->advance(t, recorder);
    const Vec3 expected = start + t * velocity + 0.5 * t * t * Vec3{0, 0, -gravity};
    worst = max_or_nan(worst, norm(engine->balls().front().position - expected));
  }
  stays_below("distance from the parabola [m]", worst, 1e-15, "evt.2");
  engine->advance(0.7, recorder);
  const double h = 0.5 + 1 - 0.004;  // down to the floor
  ASSERT_EQ(recorder.all.size(), 1U);
  states("time of the first touch [s]", recorder.all[0].time,
         (velocity.z + std::sqrt(velocity.z * velocity.z + 2 * gravity * h)) / gravity, 1e-13,
         "seed 0 eq. 6 with its guard; margin 1e-12 R over the speed");
}

TEST(Flight, bouncing_ball_rises_to_h_e_to_the_2n_and_stops_in_its_closed_form_time) {
  const scene::Chamber still{geometry::Cylinder{2, 2}, kinematics::Still{}, {}, {0, 0, -gravity}};
  const double e = 0.8, h = 0.5;
  const auto engine = event::one_ball(still, ball_a({0, 0, -1 + 0.004 + h}), rules_a(e));
  Recorder recorder;
  engine->advance(10, recorder);
  for (std::size_t n = 1; n <= 20; n += 5) {
    const double rise = std::pow(e * recorder.all[n - 1].approach, 2) / (2 * gravity);
    const double expected = h * std::pow(e, 2.0 * static_cast<double>(n));
    states("height after bounce " + std::to_string(n) + " [m]", rise, expected, 1e-11 * h,
           "h e^(2n), physics 7.2");
  }
  const scene::EnergyBalance energy_balance = engine->energy_balance();
  const double fall = std::sqrt(2 * h / gravity), all_over = fall * (1 + e) / (1 - e);
  // A sustained contact begins at a rebound below 0.1 mm/s. The remaining bounces would take at
  // most 2 w / (g (1 - e)).
  states("time to rest [s]", energy_balance.time - energy_balance.contact_time, all_over,
         2 * 1e-4 / (gravity * (1 - e)), "t_f (1+e)/(1-e)");
  EXPECT_EQ(energy_balance.lasting_contacts, 1);
  states("energy lost [J]", energy_balance.lost(), ball_a().mass() * gravity * h, 1e-15,
         "it came to rest");
}

/// Compares the search by conservative advancement with dense sampling of the gap: 1e5 flights over
/// the frequencies and vials of Chen et al. 2016.
TEST(Search, never_steps_over_a_contact_in_a_hundred_thousand_flights) {
  Random random(11, 0);
  double deepest = -1, furthest = 0;
  int touched = 0;
  constexpr int flights = 100000, looks = 400;
  for (int i = 0; i < flights; ++i) {
    const geometry::Capsule vial_i = vial(random.uniform(0.010, 0.014));
    const scene::Chamber mill{vial_i, shaken(random.uniform(10, 25), 0.025), {}, {0, 0, -gravity}};
    const event::TypedChamber jar(vial_i, std::get<kinematics::Vibration>(*mill.motion), mill);
    const event::TouchTolerance tolerance{0.004, 4e-15};
    Vec3 place;  // anywhere the ball fits; every third start is right at the wall
    do {
      const double r = 0.5 * vial_i.diameter;
      place = {random.uniform(-r, r), random.uniform(-r, r),
               random.uniform(-1, 1) * vial_i.reach()};
    } while (vial_i.gap(0, place).distance < 0.004 + 1e-6);
    if (i % 3 == 0) {
      const geometry::Gap gap = vial_i.gap(0, place);
      place -= (gap.distance - 0.004) * gap.inward;
    }
    Vec3 velocity = std::pow(10, random.uniform(-3, 0.9)) * random.direction();
    const Vec3 inward = vial_i.gap(0, place).inward;
    if (i % 3 == 0 && dot(velocity, inward) < 0) velocity -= 2 * dot(velocity, inward) * inward;
    event::Instant start{random.uniform(0, 0.1), {}, {place, velocity}};
    start.frame = jar.motion().frame_motion(start.time);
    const event::Flight flight{start.time, place + start.frame.centre,
                               velocity + start.frame.velocity};
    const event::Touch touch = event::next_touch(jar, flight, start, start.time + 10, tolerance);
    touched += touch.face == 0;
    const auto gap_at = [&](double t) {
      const event::BallState p = flight.ball_state(t, jar.gravity(), jar.motion().frame_motion(t));
      return vial_i.gap(0, p.position).distance - 0.004;
    };
    for (int k = 1; k < looks; ++k)
      deepest =
          max_or_nan(deepest, -gap_at(start.time + (touch.when.time - start.time) * k / looks));
    furthest = max_or_nan(furthest, std::abs(gap_at(touch.when.time)));
  }
  EXPECT_EQ(touched, flights);
  // The margin of the search, and the rounding of positions of 0.1 m.
  stays_below("deepest penetration before the touch found [m]", deepest, 1e-14,
              "dense sampling, 400 looks a flight");
  stays_below("largest gap at the touch [m]", furthest, 1e-14, "twice the margin");
}

/// A shaker far beyond any real one, a thousand seconds after its clock began. One step of the
/// clock is longer than the time to cross the margin. The run must still end, and its energy
/// balance close.
TEST(Search, ends_where_the_clock_can_tell_no_more) {
  const kinematics::ArcShaker shaker{.frequency = 1000, .arm = 0.15, .swing = 0.05};
  const scene::Chamber mill{
      geometry::Capsule{0.02, 0.025}, shaker, scene::mounted_along({1, 0, 0}), {0, 0, -gravity}};
  event::Rules rules = rules_a();
  rules.bounce = {0.9, 0, 0.3};
  const auto engine = event::one_ball(mill, ball_a({}, {0.05, 0.02, 0.03}), rules, 1000);
  Recorder recorder;
  engine->advance(0.3, recorder);
  EXPECT_GT(recorder.all.size(), 1000U);
  stays_below("worst collision's balance, relative", engine->energy_balance().worst_collision, 1e-9,
              "evt.8");
}

}  // namespace
}  // namespace mahlwerk::tests::flight_test
