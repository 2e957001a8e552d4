// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Toe, shoulder and regime of charges made by hand.
#include "mahlwerk/results/quantities/regime.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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
  for (const Measure& m : regime_measures(outcome.mill_case))
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

TEST(Regime, is_named_by_the_rule) {
  const auto word = [](Outcome outcome, double contact, int count) {
    put(outcome, 100, count);
    touch(outcome, contact);
    return regime(outcome);
  };
  for (const bool flies : {false, true}) {
    const double contact = flies ? 0.79 : 0.81;
    EXPECT_EQ(word(drum(3), contact, 40), flies ? "cataracting" : "cascading");
    EXPECT_EQ(word(planetary(-2), contact, 40), flies ? "cataracting" : "cascading");
    EXPECT_EQ(word(drum(3), contact, Charge::angles), flies ? "cataracting" : "cascading");
  }
  EXPECT_EQ(word(drum(20), 0.99, Charge::angles), "centrifuging");
  EXPECT_EQ(word(planetary(-3), 0.99, Charge::angles), "rolling");
  EXPECT_EQ(word(drum(20), 0.97, Charge::angles), "cascading") << "3 % of flight";
  EXPECT_EQ(word(drum(20), 0.99, Charge::angles - 10), "cascading") << "a gap of 20 degrees";
  EXPECT_EQ(regime(of(kinematics::Still{})), "");
  EXPECT_EQ(regime(of(kinematics::Tumbling{0})), "") << "a drum at rest";
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

/// Contact shares and speeds of replicates of papers/planetary-mill/regimes.toml and friction.toml,
/// in the speed of the wall seen from the disc.
TEST(Regime, a_charge_that_the_wall_carries_round_is_not_cascading_although_some_balls_rattle) {
  const auto word = [](Outcome outcome, double contact, int count, double from_jar) {
    const bool turning = kinematics::as<kinematics::Tumbling>(*outcome.mill_case.mill.motion);
    const double wall = 3 * 0.1 * (turning ? 1 : 40);
    put(outcome, 0, count);
    touch(outcome, contact);
    moves(outcome, from_jar * wall, wall, 0);
    return regime(outcome);
  };
  const int round = Charge::angles;
  EXPECT_EQ(word(planetary(-3), 0.973, round, 0.071), "rolling") << "friction 0.5, k = -5";
  EXPECT_EQ(word(planetary(-3), 0.979, round, 0.106), "rolling") << "friction 0.2, k = -6";
  EXPECT_EQ(word(drum(3), 0.973, round, 0.071), "centrifuging");
  EXPECT_EQ(word(planetary(-3), 0.835, round, 0.361), "cascading") << "friction 0.2, k = -5";
  EXPECT_EQ(word(planetary(-3), 0.973, round / 2, 0.071), "cascading") << "on one side only";
  EXPECT_EQ(word(planetary(-3), 0.79, round, 0.071), "cataracting") << "21 % of flight";
}

TEST(Regime, a_charge_at_rest_under_which_the_wall_passes_is_sliding) {
  const auto word = [](double contact, double from_carrier, double slip) {
    Outcome outcome = planetary(-2);  // the wall passes at 2 * 40/s * 0.1 m
    put(outcome, 20, 40);
    touch(outcome, contact);
    moves(outcome, 8, from_carrier * 8, slip * 8);
    return regime(outcome);
  };
  EXPECT_EQ(word(1, 0.0023, 0.505), "sliding") << "replicate 1 of friction.toml";
  EXPECT_EQ(word(1, 0.0045, 0.40), "sliding") << "replicate 6";
  EXPECT_EQ(word(0.918, 0.307, 0.247), "cascading") << "replicate 2";
  EXPECT_EQ(word(1, 0.0023, 0), "cascading") << "balls that roll on the spot";
  EXPECT_EQ(word(0.97, 0.0023, 0.5), "cascading") << "3 % of flight";
}

TEST(Regime, is_named_for_each_replicate) {
  Outcome outcome = planetary(-2);
  outcome.replicates.push_back(outcome.replicates[0]);
  put(outcome, 20, 40);
  touch(outcome, 1);
  moves(outcome, 8, 0, 4);
  Replicate& other = outcome.replicates[1];
  other.charge.mass_by_angle = outcome.replicates[0].charge.mass_by_angle;
  other.energy_balance.contact_time = 20 * 0.7;
  EXPECT_EQ(regime(outcome.mill_case, outcome.replicates[0]), "sliding");
  EXPECT_EQ(regime(outcome.mill_case, other), "cataracting");
}

TEST(Regime, is_averaged_over_replicates) {
  Outcome outcome = drum(3);
  outcome.replicates.push_back(outcome.replicates[0]);
  for (Replicate& r : outcome.replicates) std::ranges::fill(r.charge.mass_by_angle, 1.0);
  outcome.replicates[0].energy_balance.contact_time = 20 * 0.9;
  outcome.replicates[1].energy_balance.contact_time = 20 * 0.6;
  EXPECT_EQ(regime(outcome), "cataracting") << "25 % of flight";
  outcome.replicates[1].energy_balance.contact_time = 20 * 0.8;
  EXPECT_EQ(regime(outcome), "cascading") << "15 % of flight";
  EXPECT_NE(regime_reason(outcome).find("fly 15 %"), std::string::npos) << regime_reason(outcome);
}

}  // namespace
}  // namespace mahlwerk::results::regime_test
