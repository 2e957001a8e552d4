// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// States of motion in a lying, shaken jar (obs.20), of balls that are moved by hand.
#include "mahlwerk/observe/motion_states.hpp"

#include <gtest/gtest.h>

#include <string>

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "statement.hpp"
#include "unit/observe/moved_by_hand.hpp"

namespace mahlwerk::observe::motion_states_test {
namespace {

using namespace moved_by_hand;

using tests::states;

TEST(MotionStates, are_told_apart_by_what_the_balls_do) {
  const std::pair<Way, MotionState> all[] = {{circles, MotionState::circling},
                                             {bounces, MotionState::bouncing},
                                             {keeps_to_the_jar, MotionState::pinned},
                                             {stays, MotionState::stationary}};
  for (const auto& [way, state] : all) {
    MovedCharge charge(1);
    charge.go(10, {way});
    charge.take({way});  // ends the tenth period
    states(std::string(name_of(state)) + " [s]", charge.states.in(state).time, 10 / frequency,
           1e-12, "obs.20: ten periods");
    EXPECT_EQ(charge.states.visits(state), 1);
    states("energy lost in it [J]", charge.states.in(state).lost, 20, 1e-12, "by hand");
    states("hits in it", charge.states.in(state).hits, 30, 1e-12, "by hand");
  }
}

TEST(MotionStates, give_turns_per_cycle_and_axial_travel_over_that_of_the_jar) {
  MovedCharge charge(1);
  charge.go(10, {circles});
  charge.take({circles});
  const MotionTotals& in = charge.states.in(MotionState::circling);
  states("turns per cycle", in.turned / in.time, 1.5, 1e-9,
         "by hand; the arc turns the jar by 4 deg");
  states("axial ratio while it circles", in.axial_ratio / in.time, 0, 1e-12, "by hand");
  MovedCharge other(1);
  other.go(10, {keeps_to_the_jar});
  other.take({keeps_to_the_jar});
  const MotionTotals& pinned = other.states.in(MotionState::pinned);
  states("axial ratio of a ball that moves with the jar", pinned.axial_ratio / pinned.time, 1, 1e-9,
         "by hand");
}

TEST(MotionStates, change_once_a_change_has_lasted_three_periods) {
  MovedCharge charge(1);
  charge.go(20, {circles});
  charge.go(2, {bounces});  // too short
  charge.go(20, {circles});
  charge.go(5, {bounces});
  charge.take({bounces});
  EXPECT_EQ(charge.states.visits(MotionState::circling), 1);
  EXPECT_EQ(charge.states.visits(MotionState::bouncing), 1);
  states("circling, with the short visit to the other [s]",
         charge.states.in(MotionState::circling).time, 42 / frequency, 1.01 / frequency,
         "by hand; the period of a change may belong to either");
  states("bouncing [s]", charge.states.in(MotionState::bouncing).time, 5 / frequency,
         1.01 / frequency, "by hand");
  states("both [s]", charge.states.time(), 47 / frequency, 1e-9, "no period is lost");
}

TEST(MotionStates, of_several_balls_belong_to_more_than_half_of_them) {
  MovedCharge charge(3);
  charge.go(10, {circles, circles, stays});
  charge.go(10, {circles, bounces, stays});
  charge.take({circles, bounces, stays});
  states("circling [s]", charge.states.in(MotionState::circling).time, 10 / frequency,
         1.01 / frequency, "two of three balls");
  states("irregular [s]", charge.states.in(MotionState::irregular).time, 10 / frequency,
         1.01 / frequency, "three balls in three states");
  states("time of balls that circle [s]", charge.states.time_of_balls(MotionState::circling),
         (10 * 2.0 / 3 + 10 / 3.0) / frequency, 1.01 / frequency, "by hand");
}

TEST(MotionStates, go_on_after_they_were_saved) {
  MovedCharge whole(1), cut(1);
  for (MovedCharge* one : {&whole, &cut}) {
    one->go(7, {circles});
    one->go(1, {bounces});
  }
  Archive saved;
  cut.states.serialize(saved);
  MotionStates read(jar());
  Archive from(saved.bytes());
  read.serialize(from);
  cut.states = read;
  for (MovedCharge* one : {&whole, &cut}) one->go(9, {bounces});
  Archive a, b;
  whole.states.serialize(a);
  cut.states.serialize(b);
  EXPECT_EQ(a.bytes(), b.bytes());
}

TEST(MotionStates, exist_in_lying_jars_that_are_shaken_only) {
  const geometry::AnyShape round = *jar().shape, box = geometry::Box{0.1, 0.1, 0.1};
  const kinematics::AnyMotion shaken = mill(), drum = kinematics::Tumbling{6};
  EXPECT_TRUE(has_motion_states(shaken, round, kinematics::lying));
  EXPECT_FALSE(has_motion_states(shaken, round, kinematics::upright));
  EXPECT_FALSE(has_motion_states(shaken, box, kinematics::lying));
  EXPECT_FALSE(has_motion_states(drum, round, kinematics::lying));
}

}  // namespace
}  // namespace mahlwerk::observe::motion_states_test
