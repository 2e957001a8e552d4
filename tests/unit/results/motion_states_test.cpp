// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Quantities of the states of motion (obs.20) and their table (obs.21), of balls moved by hand.
#include "mahlwerk/results/quantities/motion_states.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "mahlwerk/results/quantities/regime.hpp"
#include "statement.hpp"
#include "unit/observe/moved_by_hand.hpp"

namespace mahlwerk::results::motion_states_test {
namespace {

using namespace observe::moved_by_hand;
using tests::states;

/// A case of the hand-moved mill, with a replicate for each of these motions.
Outcome outcome_of(const std::vector<observe::MotionStates>& motions) {
  Outcome outcome;
  cases::Case& c = outcome.mill_case;
  c.mill.motion = mill();
  c.mill.jar_axis = kinematics::lying;
  c.jar.shape = jar().shape;
  c.run.engine = cases::EngineName::event;
  c.balls = {{1, 0.01, 7850, ""}};
  for (const observe::MotionStates& motion : motions) {
    outcome.replicates.emplace_back(0.1);
    outcome.replicates.back().motion = motion;
    outcome.replicates.back().energy_balance.time = 10;
  }
  return outcome;
}

double value(const Outcome& outcome, const std::string& name) {
  return record_of(name)->compute(outcome.mill_case, outcome.replicates.front());
}

TEST(MotionStateQuantities, are_shares_of_the_balls_time_changes_turns_and_axial_travel) {
  MovedCharge charge(1);
  charge.go(30, {circles});
  charge.go(10, {bounces});
  charge.go(10, {keeps_to_the_jar});
  charge.go(10, {stays});
  charge.take({stays});
  const Outcome outcome = outcome_of({charge.states});
  const double one = 1.01 / 60;  // the period of a change may belong to either state
  states("circling_share", value(outcome, "circling_share"), 0.5, one, "30 of 60 periods");
  states("bouncing_share", value(outcome, "bouncing_share"), 1.0 / 6, one, "10 of 60 periods");
  states("pinned_share", value(outcome, "pinned_share"), 1.0 / 6, one, "10 of 60 periods");
  states("stationary_share", value(outcome, "stationary_share"), 1.0 / 6, one, "10 of 60 periods");
  states("state_changes [1/s]", value(outcome, "state_changes"), 3 / (60 / frequency), 0.02,
         "three changes in 60 periods");
  EXPECT_EQ(motion_word({&outcome.replicates.front()}),
            "circling and bouncing and pinned and stationary");
}

TEST(MotionStateQuantities, shares_add_up_to_one_while_a_change_does_not_count_yet) {
  MovedCharge charge(1);
  charge.go(8, {circles});
  charge.go(2, {bounces});
  charge.take({bounces});
  const Outcome outcome = outcome_of({charge.states});
  states("circling_share", value(outcome, "circling_share"), 0.8, 0.1 + 1e-12,
         "8 of 10 periods; that of the change may belong to either");
  double all = 0;
  for (const char* name : {"circling_share", "bouncing_share", "pinned_share", "stationary_share"})
    all += value(outcome, name);
  states("all shares", all, 1, 1e-12, "each period belongs to one state");
}

TEST(MotionStateQuantities, mean_turns_and_axial_travel_are_those_of_the_states_by_their_time) {
  MovedCharge charge(1);
  charge.go(20, {circles});
  charge.go(20, {keeps_to_the_jar});
  charge.take({keeps_to_the_jar});
  const Outcome outcome = outcome_of({charge.states});
  states("turns_per_cycle", value(outcome, "turns_per_cycle"), 0.75, 1.5 / 40,
         "half of the periods with 1.5 turns");
  states("axial_ratio", value(outcome, "axial_ratio"), 0.5, 1.5 / 40,
         "half with none, half with that of the jar");
}

TEST(MotionStateTable, has_ratios_of_sums_over_the_replicates) {
  MovedCharge one(1), other(1);
  one.go(40, {circles});
  other.go(10, {circles});
  other.go(30, {stays});
  one.take({circles});
  other.take({stays});
  Outcome outcome = outcome_of({one.states, other.states});
  const std::vector<MotionStateSummary> found = motion_states(outcome);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].name, "circling");
  EXPECT_EQ(found[0].replicates, 2);
  EXPECT_EQ(found[1].replicates, 1);
  states("circling, share of the time", found[0].share.mean, 0.625, 0.02, "(40 + 10)/80");
  states("power while it circles [W]", found[0].power.mean, 2 * frequency, 1e-9, "2 J in a period");
  states("its half-width [W]", found[0].power.ci95, 0, 1e-9, "the same in both replicates");
  states("hits while it circles [1/s]", found[0].hit_rate.mean, 3 * frequency, 1e-9,
         "three in a period");
  states("their energy [J]", found[0].hit_energy.mean, 0.1, 1e-12, "by hand");
}

}  // namespace
}  // namespace mahlwerk::results::motion_states_test
