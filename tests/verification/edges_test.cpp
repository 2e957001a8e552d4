// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Edge cases of the event engine: elastic and perfectly inelastic collisions, 100 m/s, inelastic
// collapse without a treatment, runs that are stopped on request.
#include <atomic>
#include <string>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "many_balls.hpp"
#include "one_ball.hpp"
#include "statement.hpp"

namespace mahlwerk::edges_test {
namespace {

using namespace tests;

/// n^3 balls on a lattice, with random velocities. They fill about a tenth of the box.
std::vector<scene::Ball> charge(int n, double diameter, double speed, std::uint64_t seed) {
  Random random(seed, 0);
  std::vector<scene::Ball> balls = lattice(n, 0.1, false, seed);
  for (scene::Ball& b : balls)
    b = {diameter / 2,
         7850,
         diameter * b.position,
         random.uniform(0, speed) * random.direction(),
         {}};
  return balls;
}

geometry::Box box_of(int n, double diameter) {
  const double side = diameter * side_of(n, 0.1);
  return {side, side, side};
}

event::Rules rules_of(event::SustainedContactMode lasting, double contact_time = 1e-4) {
  event::Rules rules;
  rules.sustained_mode = lasting;
  rules.contact_time = contact_time;
  return rules;
}

TEST(Edges, elastic_balls_in_a_jar_at_rest_keep_their_energy_at_100_m_s) {
  const scene::Chamber jar{box_of(3, 0.005), kinematics::Still{}, {}, {}};
  for (const double friction : {0.0, 1e300}) {
    const contact::BounceRule rule{1, 1, friction};
    const auto run = event::many_balls(jar, charge(3, 0.005, 100, 1),
                                       rules_of(event::SustainedContactMode::tc), {1, 6, rule});
    Counter counter;
    const double before = run->energy_balance().kinetic;
    run->advance(0.02, counter);
    EXPECT_GT(counter.count, 1000);
    states("kinetic energy over that at the start", run->energy_balance().kinetic / before, 1,
           1e-15 * std::sqrt(static_cast<double>(counter.count)) * 10, "no force does work");
    states("dissipated over that at the start", run->energy_balance().lost() / before, 0,
           1e-15 * std::sqrt(static_cast<double>(counter.count)), "e = 1, no friction");
  }
}

TEST(Edges, inelastic_balls_in_a_jar_at_rest_only_lose_energy) {
  const scene::Chamber jar{box_of(3, 0.005), kinematics::Still{}, {}, {}};
  for (const double e : {0.0, 0.5, 0.9}) {
    const auto run =
        event::many_balls(jar, charge(3, 0.005, 100, 2), rules_of(event::SustainedContactMode::tc),
                          {1, 6, contact::BounceRule{e, 0, 0.3}});
    Counter counter;
    double before = run->energy_balance().kinetic;
    for (int i = 1; i <= 20; ++i) {
      run->advance(0.001 * i, counter);
      const double now = run->energy_balance().kinetic;
      EXPECT_LE(now, before) << "e = " << e << ", " << i << " ms";
      before = now;
    }
    stays_below("energy left over that lost, e = " + std::to_string(e),
                before / run->energy_balance().lost(), 1, "collisions dissipate");
  }
}

/// Results of a box that vibrates at 800 g, with the TC rule and `contact_time` [s].
struct FastMill {
  double power = 0;     ///< [W] dissipated
  double withheld = 0;  ///< [1] power that the TC rule withheld, over `power`
};
FastMill fast_mill(double contact_time) {
  kinematics::Vibration motion;
  motion.frequency = 100;
  motion.amplitude = 0.02;
  const scene::Chamber mill{box_of(4, 0.003), motion, {}, {0, 0, -gravity}};
  const auto run = event::many_balls(mill, charge(4, 0.003, 0.1, 3),
                                     rules_of(event::SustainedContactMode::tc, contact_time),
                                     {1, 6, contact::BounceRule{0.8, 0, 0.1}});
  Counter counter;
  run->advance(0.05, counter);
  const scene::EnergyBalance settled = run->energy_balance();
  run->advance(0.35, counter);
  const scene::EnergyBalance end = run->energy_balance();
  const double lost = end.lost() - settled.lost();
  return {lost / 0.3, (end.withheld - settled.withheld) / lost};
}

TEST(Edges, power_of_a_fast_mill_does_not_depend_on_the_contact_time) {
  // Two runs of 30 periods scatter by about 1 % each. Without a limit on the speed the TC rule gave
  // a quarter less at 0.1 ms than at 1 us.
  const FastMill by_default = fast_mill(1e-4 / std::sqrt(800)), shorter = fast_mill(1e-6);
  states("power at the default of t_c over that at 1 us", by_default.power / shorter.power, 1, 0.05,
         "man.4");
  stays_below("withheld share at the default", by_default.withheld, 0.02, "no doubt");
  // A t_c that is far too long for this mill shows in the withheld power.
  EXPECT_GT(fast_mill(1e-4).withheld, 0.02);
}

TEST(Edges, dead_balls_among_many_go_on) {
  // e = 0 with smooth, rough and sliding balls, in a mill that throws the balls and in a mill that
  // presses them to the wall.
  kinematics::Vibration shaken;
  shaken.frequency = 20;
  shaken.amplitude = 0.01;
  kinematics::Planetary planetary;
  planetary.orbit_radius = 0.07;
  planetary.speed = 15;
  planetary.ratio = 1;
  for (const kinematics::AnyMotion& motion :
       {kinematics::AnyMotion(shaken), kinematics::AnyMotion(planetary)})
    for (const contact::BounceRule& rule :
         {contact::BounceRule{0, 1, 0}, contact::BounceRule{0, 0, 0.3},
          contact::BounceRule{0, -1, INFINITY}}) {
      const scene::Chamber mill{box_of(3, 0.008), motion, {}, {0, 0, -gravity}};
      const auto run = event::many_balls(mill, charge(3, 0.008, 0.1, 4),
                                         rules_of(event::SustainedContactMode::tc), {1, 6, rule});
      Counter counter;
      ASSERT_NO_THROW(run->advance(0.2, counter))
          << "e_t = " << rule.tangential_restitution << ", mu = " << rule.friction;
      stays_below("deepest overlap over R", deepest_overlap(run->balls()), 1e-9, "hard spheres");
    }
}

TEST(Edges, collapse_without_a_remedy_is_found_and_the_message_names_another) {
  kinematics::Vibration motion;
  motion.frequency = 20;
  motion.amplitude = 0.01;
  const scene::Chamber mill{geometry::Cylinder{0.04, 0.04}, motion, {}, {0, 0, -gravity}};
  std::vector<scene::Ball> balls = charge(2, 0.008, 0.1, 5);
  balls.resize(5);
  const auto run = event::many_balls(mill, balls, rules_of(event::SustainedContactMode::none),
                                     {1, 3, contact::BounceRule{0, 0, 0.3}});
  Counter counter;
  try {
    run->advance(0.3, counter);
    FAIL() << "e = 0 without a treatment of sustained contacts collapses";
  } catch (const RunError& e) {
    const std::string text = e.what();
    EXPECT_NE(text.find("inelastic collapse"), std::string::npos) << text;
    EXPECT_NE(text.find("lasting = \"none\". Leave it out"), std::string::npos) << text;
  }
}

/// Requests the end of a run at its first collisions.
struct Impatient final : scene::Observer {
  std::atomic<bool> stop = false;
  void collisions(std::span<const scene::Collision>) override { stop = true; }
};

TEST(Edges, a_run_that_is_asked_to_end_ends_and_goes_on_with_the_same_bits) {
  kinematics::Vibration motion;
  motion.frequency = 20;
  motion.amplitude = 0.01;
  const scene::Chamber mill{box_of(3, 0.008), motion, {}, {0, 0, -gravity}};
  const auto make = [&] {
    return event::many_balls(mill, charge(3, 0.008, 0.1, 6),
                             rules_of(event::SustainedContactMode::tc),
                             {1, 6, contact::BounceRule{0.5, 0, 0.3}});
  };
  const auto whole = make(), ended = make();
  Impatient impatient;
  ended->stop_on(&impatient.stop);
  ended->advance(0.5, impatient);
  EXPECT_LT(ended->energy_balance().time, 0.5);
  EXPECT_GT(ended->energy_balance().time, 0);
  ended->stop_on(nullptr);
  ended->advance(0.5, impatient);
  Counter counter;
  whole->advance(0.5, counter);
  for (std::size_t i = 0; i < whole->balls().size(); ++i) {
    EXPECT_EQ(whole->balls()[i].position, ended->balls()[i].position);
    EXPECT_EQ(whole->balls()[i].spin, ended->balls()[i].spin);
  }
  EXPECT_EQ(whole->energy_balance().lost(), ended->energy_balance().lost());
}

}  // namespace
}  // namespace mahlwerk::edges_test
