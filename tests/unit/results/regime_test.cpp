// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Toe, shoulder and regime of charges made by hand.
#include "mahlwerk/results/quantities/regime.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/results/summary.hpp"
#include "statement.hpp"

namespace mahlwerk::results::regime_test {
namespace {

using observe::Charge;
using tests::states;

constexpr double slot = 360.0 / Charge::angles;  // [deg]

/// Ten seconds of two balls of 10 mm in a drum 200 mm wide, or a planetary mill.
Outcome of(const kinematics::AnyMotion& motion) {
  Outcome outcome;
  cases::Case& c = outcome.mill_case;
  c.mill.motion = motion;
  c.mill.jar_axis = std::visit([](const auto& m) -> Vec3 { return m.jar_axis; }, motion);
  c.jar.shape = geometry::Cylinder{0.2, 0.1};
  c.balls = {{2, 0.01, 7850, ""}};
  outcome.replicates.emplace_back(0.1, observe::BallKinds{},
                                  observe::WallGrid{.radius = 0.1, .bottom = -0.05, .top = 0.05});
  outcome.replicates[0].energy_balance.time = 10;
  outcome.replicates[0].charge = Charge(cases::chamber(c), 0.1);
  return outcome;
}
Outcome drum(double speed) {
  return of(kinematics::Tumbling{speed});
}
Outcome planetary(double ratio) {
  kinematics::Planetary mill;
  mill.orbit_radius = 0.3, mill.speed = 40, mill.ratio = ratio;
  return of(mill);
}

/// Gives `count` slots from `first` on equal mass. Slots are counted from the right of the plane.
void put(Outcome& outcome, int first, int count, double mass = 1) {
  for (int i = 0; i < count; ++i) {
    const int at = ((first + i) % Charge::angles + Charge::angles) % Charge::angles;
    outcome.replicates[0].charge.mass_by_angle[static_cast<std::size_t>(at)] = mass;
  }
}

double value(const Outcome& outcome, const std::string& name) {
  for (const Measure& m : applying(regime_measures(), outcome.mill_case))
    if (m.name == name) return m.compute(outcome.mill_case, outcome.replicates[0]);
  throw std::out_of_range(name);
}

/// The balls touch something for this share of their time.
void touch(Outcome& outcome, double share) {
  outcome.replicates[0].energy_balance.contact_time = share * 10 * 2;
}

/// Checks toe and shoulder of a wedge of `count` slots that begins `from` degrees after the
/// reference, in the sense of rotation.
void expect_ends(const Outcome& outcome, double from, int count, const std::string& name) {
  const double wide = count * slot, toe = std::remainder(from + 0.05 * wide, 360);
  const std::string why = "5 % and 95 % of an even wedge; rounding of a turn";
  states(name + ": toe [deg]", value(outcome, "toe_angle"), toe, 1e-9, why);
  states(name + ": shoulder [deg]", value(outcome, "shoulder_angle"), toe + 0.9 * wide, 1e-9, why);
}

/// The lowest point of the drum's plane is at 270 degrees. Seen from where its axis, y, points to,
/// z is up and x points left, so that it turns anticlockwise with a positive speed.
TEST(Regime, toe_and_shoulder_of_a_wedge_are_those_by_hand_in_both_senses_of_turning) {
  for (const int count : {1, 2, 7, 20, 45, 60, 89}) {
    const std::string name = "wedge of " + std::to_string(count) + " slots";
    for (const int begin : {-60, -37, -1, 0, 10, 25, 88}) {  // slots from the lowest point
      Outcome forwards = drum(3), backwards = drum(-3), outwards = planetary(0.5),
              inverse = planetary(-2);
      put(forwards, 135 + begin, count);
      put(backwards, 135 - begin - count, count);
      put(outwards, begin, count);
      put(inverse, -begin - count, count);
      expect_ends(forwards, begin * slot, count, name + ", drum");
      expect_ends(backwards, begin * slot, count, name + ", drum turning back");
      expect_ends(outwards, begin * slot, count, name + ", planetary");
      expect_ends(inverse, begin * slot, count, name + ", planetary, inverse");
    }
  }
}

/// 20 kg in ten slots: 5 % are 1 kg, 0.2 kg of the 1.2 kg of the third slot; 95 % end in the middle
/// of the last.
TEST(Regime, toe_and_shoulder_of_an_uneven_charge_are_quantiles_of_its_mass) {
  const std::vector<double> masses{0.4, 0.4, 1.2, 1, 2, 3, 4, 4, 2, 2};
  Outcome forwards = drum(3), backwards = drum(-3);
  for (int i = 0; i < std::ssize(masses); ++i) {
    put(forwards, 135 + 4 + i, 1, masses[static_cast<std::size_t>(i)]);
    put(backwards, 135 - 4 - 1 - i, 1, masses[static_cast<std::size_t>(i)]);
  }
  for (const Outcome* outcome : {&forwards, &backwards}) {
    states("toe [deg]", value(*outcome, "toe_angle"), (4 + 2 + 0.2 / 1.2) * slot, 1e-9, "by hand");
    states("shoulder [deg]", value(*outcome, "shoulder_angle"), (4 + 9.5) * slot, 1e-9, "by hand");
  }
}

TEST(Regime, a_few_strays_do_not_move_the_ends_of_a_charge) {
  Outcome clean = drum(3), dirty = drum(3);
  put(clean, 130, 40);
  put(dirty, 130, 40);
  put(dirty, 50, 4, 0.1);  // 1 % of the mass, near the top
  states("toe [deg]", value(dirty, "toe_angle"), value(clean, "toe_angle"), slot,
         "5 % are left out");
  states("shoulder [deg]", value(dirty, "shoulder_angle"), value(clean, "shoulder_angle"), slot,
         "5 % are left out");
}

TEST(Regime, the_emptiest_sector_is_the_emptiest) {
  Outcome even = drum(3), wedge = drum(3), hole = drum(3), dent = drum(3);
  put(even, 0, Charge::angles);
  put(wedge, 0, 90);
  put(hole, 0, Charge::angles);
  put(hole, 35, 5, 0);  // sector 7
  put(dent, 0, Charge::angles);
  put(dent, 175, 5, 0.5);  // the last sector
  states("even charge", value(even, "emptiest_sector"), 1, 1e-14, "all alike");
  states("half a turn", value(wedge, "emptiest_sector"), 0, 0, "nothing in the other half");
  states("a hole of 10 degrees", value(hole, "emptiest_sector"), 0, 0, "nothing in it");
  states("a dent of 10 degrees", value(dent, "emptiest_sector"), 0.5 * 36 / 35.5, 1e-14,
         "half there, over an even share of 35.5 sectors");
}

TEST(Regime, pinning_is_the_ratio_of_accelerations) {
  states("Froude number", value(drum(7), "froude_number"), 49 * (0.1 - 0.005) / 9.81, 1e-14,
         "w^2 (R - r)/g");
  states("pinning ratio", value(planetary(-2.5), "pinning_ratio"),
         60.0 * 60 * (0.1 - 0.005) / (40.0 * 40 * 0.3), 1e-13, "(1 + k)^2 (R - r)/R_p");
  Outcome mill = planetary(-2.5);
  mill.replicates[0].charge.mass_at_wall = 4;
  mill.replicates[0].charge.wall_slip = 6;
  states("slip over the wall's speed", value(mill, "wall_slip_ratio"), 1.5 / (60 * 0.1), 1e-14,
         "|1 + k| W R");
}

/// Both balls at 40 mm from the axis, at these speeds seen from the jar and from the carrier, and
/// this slip at the wall [m/s].
void moves(Outcome& outcome, double from_jar, double from_carrier, double slip) {
  Charge& charge = outcome.replicates[0].charge;
  charge.in_jar.add(0.04, 0, from_jar, 0, from_jar * from_jar, 1, 1);
  charge.in_carrier.add(0.04, 0, from_carrier, 0, from_carrier * from_carrier, 1, 1);
  charge.in_jar.add_time(1);
  charge.in_carrier.add_time(1);
  charge.mass_at_wall = 1;
  charge.wall_slip = slip;
}

TEST(Regime, of_a_jar_that_does_not_turn_on_its_disc_is_resting_once_the_balls_rest) {
  Outcome mill = planetary(0);
  put(mill, 0, 20);
  moves(mill, 0.001, 0.001, 0);
  EXPECT_EQ(regime(mill), "resting");
  Outcome moving = planetary(0);
  put(moving, 0, 20);
  moves(moving, 3, 3, 0);
  EXPECT_NE(regime(moving), "resting");
}

/// k^2 (R - r)/R_p with R - r = 95 mm and R_p = 300 mm: 0.079 and 0.114, the limit is 0.1.
TEST(Regime, of_a_planetary_jar_is_cataracting_only_where_it_turns_fast_enough_to_throw) {
  const auto word = [](double ratio) {
    Outcome mill = planetary(ratio);
    put(mill, 0, 20);
    const double wall = std::abs(ratio) * 40 * 0.1;  // [m/s]
    moves(mill, 0.8 * wall, 0.6 * wall, 0.2 * wall);
    mill.replicates[0].charge.mass_sought = 1, mill.replicates[0].charge.mass_outside = 0.2;
    touch(mill, 0.5);
    return regime(mill);
  };
  EXPECT_EQ(word(0.5), "cascading");
  EXPECT_EQ(word(0.6), "cataracting");
}

TEST(Regime, is_that_of_drums_and_planetary_mills_alone) {
  EXPECT_EQ(regime(of(kinematics::Still{})), "");
  EXPECT_EQ(regime(of(kinematics::Tumbling{0})), "") << "a drum at rest";
  Outcome end_over_end = drum(3);
  end_over_end.mill_case.mill.jar_axis = {0, 0, 1};
  EXPECT_EQ(regime(end_over_end), "") << "an end-over-end tumbler has no toe and no shoulder";
  EXPECT_TRUE(applying(regime_measures(), end_over_end.mill_case).empty());
}

/// The share of flight and the mass outside the bed are measured apart: a ball in flight has both.
TEST(Regime, balls_in_flight_are_outside_the_bed_and_touch_nothing) {
  Outcome mill = drum(3);
  Charge& charge = mill.replicates[0].charge;
  charge.mass_sought = 2, charge.mass_outside = 0.6;
  touch(mill, 0.6);
  states("outside the bed", value(mill, "airborne_share"), 0.3, 1e-14, "0.6 of 2 kg s");
  touch(mill, 0.9);
  states("few without contact", value(mill, "airborne_share"), 0.1, 1e-14, "1 - 0.9");
  touch(mill, 1 + 1e-13);
  EXPECT_EQ(value(mill, "flight_share"), 0) << "rounding of the contact time";
}

TEST(Regime, intermittency_is_one_for_steady_motion_and_two_for_motion_half_of_the_time) {
  const auto sampled = [](double first, double second) {
    Outcome mill = drum(3);
    Charge& charge = mill.replicates[0].charge;
    scene::Ball ball = cases::starting_balls(mill.mill_case, 0).front();
    for (const double v : {first, second}) {
      ball.velocity = v * charge.up() + cross(Vec3{0, 0, 0}, ball.position);
      const Vec3 spin = 3 * kinematics::Tumbling::jar_axis;
      ball.velocity += cross(spin, ball.position);  // seen from the jar: v
      charge.sample(0, {ball}, 1);
    }
    const double wall = 3 * mill.replicates[0].tally.wall_map.grid().radius;
    states("jar lag", value(mill, "jar_lag"),
           std::sqrt((first * first + second * second) / 2) / wall, 1e-12,
           "root mean square speed in the jar over that of the wall");
    return value(mill, "intermittency");
  };
  states("steady", sampled(0.3, 0.3), 1, 1e-12, "<v^4>/<v^2>^2");
  states("half of the time", sampled(0.3, 0), 2, 1e-12, "(1/2)/(1/2)^2");
}

TEST(Regime, is_named_for_each_replicate_and_for_their_mean) {
  Outcome outcome = drum(5);  // F = 0.24
  put(outcome, 120, 40);
  moves(outcome, 0.4, 0.33, 0.083);
  outcome.replicates[0].charge.mass_sought = 1;
  outcome.replicates.push_back(outcome.replicates[0]);
  outcome.replicates[1].charge.mass_outside = 0.5;
  touch(outcome, 0.4);
  outcome.replicates[1].energy_balance.contact_time =
      outcome.replicates[0].energy_balance.contact_time;
  EXPECT_EQ(regime(outcome.mill_case, outcome.replicates[0]), "cascading");
  EXPECT_EQ(regime(outcome.mill_case, outcome.replicates[1]), "cataracting");
  EXPECT_EQ(regime(outcome), "cataracting") << "a quarter of the mass outside the bed";
  EXPECT_NE(regime_reason(outcome).find("25 % of the mass"), std::string::npos)
      << regime_reason(outcome);
}

TEST(Regime, the_reason_has_the_numbers_of_the_word) {
  Outcome outcome = drum(5);
  put(outcome, 135 + 20, 20);  // 40 to 80 degrees from the lowest point
  moves(outcome, 0.4, 0.33, 0.083);
  Charge& charge = outcome.replicates[0].charge;
  charge.mass_sought = 2, charge.mass_outside = 0.3;
  charge.jar_speed_fourth = 1.5 * 0.4 * 0.4 * 0.4 * 0.4;
  touch(outcome, 0.4);
  EXPECT_EQ(regime_reason(outcome),
            "15 % of the mass fly outside the bed (balls touch nothing for 60 % of their time), "
            "the emptiest 10° about the axis hold 0 % of a uniform charge's share, the charge lies "
            "from 42° to 78° and moves at 0.8 of the wall's speed seen from the jar, 0.66 seen "
            "from its carrier, balls slip at 0.17 of it on the wall, intermittency 1.5, Froude "
            "number 0.24");
}

}  // namespace
}  // namespace mahlwerk::results::regime_test
