// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The words of the rule for the regime, by its signs alone.
#include "mahlwerk/results/quantities/regime_rule.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace mahlwerk::results::regime_rule_test {
namespace {

/// Signs of a bed that flows on one side of a drum, as in most mills.
RegimeSigns flowing() {
  return {.froude = 0.3,
          .flight_share = 0.2,
          .airborne_share = 0.01,
          .emptiest_sector = 0,
          .jar_lag = 0.8,
          .carrier_motion = 0.6,
          .wall_slip = 0.2,
          .wall_share = 0.3,
          .intermittency = 1.1};
}

/// The word for the flowing bed with some of its signs changed.
std::string word_with(const std::function<void(RegimeSigns&)>& change, bool drum = true) {
  RegimeSigns signs = flowing();
  change(signs);
  return std::string(regime_word(signs, drum));
}

TEST(Regime, of_balls_that_rattle_in_a_bed_is_cascading_and_of_balls_outside_it_cataracting) {
  EXPECT_EQ(word_with([](RegimeSigns&) {}), "cascading");
  EXPECT_EQ(word_with([](RegimeSigns& s) { s.flight_share = 0.5; }), "cascading") << "in the bed";
  EXPECT_EQ(word_with([](RegimeSigns& s) { s.airborne_share = 0.2; }), "cataracting");
  EXPECT_EQ(word_with([](RegimeSigns& s) { s.airborne_share = 0.2, s.froude = 0.05; }), "cascading")
      << "too slow to throw a ball";
  const auto few_fly = [](RegimeSigns& s) { s.airborne_share = 0.11; };
  EXPECT_EQ(word_with(few_fly), "cataracting") << "in a drum";
  EXPECT_EQ(word_with(few_fly, false), "cascading") << "in a planetary mill, friction 0.2, k = -3";
}

TEST(Regime, of_a_bed_that_turns_with_the_drum_is_rigid_and_all_round_centrifuging) {
  EXPECT_EQ(word_with([](RegimeSigns& s) { s.jar_lag = 0.1, s.flight_share = 0; }), "rigid");
  const auto round = [](RegimeSigns& s) {
    s.emptiest_sector = 0.9, s.jar_lag = 0.07, s.flight_share = 0.03;
  };
  EXPECT_EQ(word_with(round), "centrifuging");
  EXPECT_EQ(word_with(round, false), "rolling") << "in a planetary mill";
  const auto falling = [](RegimeSigns& s) { s.emptiest_sector = 0.9, s.airborne_share = 0.3; };
  EXPECT_EQ(word_with(falling), "cataracting") << "all round, but in flight";
}

TEST(Regime, of_a_charge_under_which_the_wall_passes_is_sliding_or_surging) {
  const auto stays = [](RegimeSigns& s) { s.wall_slip = 0.93, s.carrier_motion = 0.2; };
  EXPECT_EQ(word_with(stays), "sliding");
  EXPECT_EQ(word_with([](RegimeSigns& s) { s.wall_slip = 0.58, s.froude = 0.09; }), "cascading")
      << "slips, but is carried up and flows down";
  EXPECT_EQ(
      word_with([](RegimeSigns& s) { s.wall_slip = 0.93, s.intermittency = 4, s.froude = 1e-3; }),
      "surging");
  const auto bounces = [](RegimeSigns& s) {
    s.wall_slip = 0.7, s.airborne_share = 0.15, s.carrier_motion = 0.3;
  };
  EXPECT_EQ(word_with(bounces), "sliding") << "the wall does not lift the charge";
  const auto falls = [](RegimeSigns& s) {
    s.wall_slip = 0.7, s.airborne_share = 0.3, s.carrier_motion = 0.3;
  };
  EXPECT_EQ(word_with(falls), "cataracting");
  const auto side_by_side = [](RegimeSigns& s) {  // papers/planetary-mill/friction.toml
    s.flight_share = s.airborne_share = 0, s.carrier_motion = 0.0045, s.wall_slip = 0.4;
    s.wall_share = 1;
  };
  EXPECT_EQ(word_with(side_by_side, false), "sliding");
}

/// docs/theory/observe.md, Regimes: each limit from both sides.
TEST(Regime, words_change_at_the_limits_of_the_rule) {
  using Signs = RegimeSigns;
  const auto round = [](double emptiest, double flight, double lag) {
    return word_with(
        [=](Signs& s) { s.emptiest_sector = emptiest, s.flight_share = flight, s.jar_lag = lag; });
  };
  EXPECT_EQ(round(0.11, 0.019, 0.8), "centrifuging");
  EXPECT_EQ(round(0.09, 0.019, 0.8), "cascading");
  EXPECT_EQ(round(0.11, 0.021, 0.8), "cascading");
  EXPECT_EQ(round(0.11, 0.09, 0.19), "centrifuging");
  EXPECT_EQ(round(0.11, 0.11, 0.19), "rigid");
  EXPECT_EQ(round(0.11, 0.09, 0.21), "cascading");
  const auto thrown = [](double froude, double airborne, bool drum, double slip = 0.2) {
    return word_with(
        [=](Signs& s) {
          s.froude = froude, s.airborne_share = airborne, s.wall_slip = slip;
          if (slip > 0.5) s.carrier_motion = 0.3;
        },
        drum);
  };
  EXPECT_EQ(thrown(0.101, 0.2, true), "cataracting");
  EXPECT_EQ(thrown(0.099, 0.2, true), "cascading");
  EXPECT_EQ(thrown(0.3, 0.051, true), "cataracting");
  EXPECT_EQ(thrown(0.3, 0.049, true), "cascading");
  EXPECT_EQ(thrown(0.3, 0.121, false), "cataracting");
  EXPECT_EQ(thrown(0.3, 0.119, false), "cascading");
  EXPECT_EQ(thrown(0.3, 0.21, true, 0.6), "cataracting");
  EXPECT_EQ(thrown(0.3, 0.19, true, 0.6), "sliding");
  const auto slips = [](double slip, double carrier, double flight) {
    return word_with(
        [=](Signs& s) { s.wall_slip = slip, s.carrier_motion = carrier, s.flight_share = flight; });
  };
  EXPECT_EQ(slips(0.51, 0.39, 0.2), "sliding");
  EXPECT_EQ(slips(0.49, 0.39, 0.2), "cascading");
  EXPECT_EQ(slips(0.51, 0.41, 0.2), "cascading");
  EXPECT_EQ(slips(0.11, 0.09, 0.019), "sliding");
  EXPECT_EQ(slips(0.09, 0.09, 0.019), "cascading");
  EXPECT_EQ(slips(0.11, 0.11, 0.019), "cascading");
  EXPECT_EQ(slips(0.11, 0.09, 0.021), "cascading");
  const auto stops = [](double intermittency, double froude, double slip) {
    return word_with(
        [=](Signs& s) { s.intermittency = intermittency, s.froude = froude, s.wall_slip = slip; });
  };
  EXPECT_EQ(stops(2.1, 0.009, 0.51), "surging");
  EXPECT_EQ(stops(2.1, 0.009, 0.49), "slumping");
  EXPECT_EQ(stops(1.9, 0.009, 0.51), "cascading");
  EXPECT_EQ(stops(2.1, 0.011, 0.51), "cascading");
  EXPECT_EQ(word_with([](Signs& s) { s.wall_share = 0.96; }), "rolling on the wall");
  EXPECT_EQ(word_with([](Signs& s) { s.wall_share = 0.94; }), "cascading");
}

TEST(Regime, of_balls_that_roll_on_the_wall_says_so) {
  const auto rolls = [](RegimeSigns& s) {
    s.flight_share = s.airborne_share = 0, s.wall_slip = 0.01, s.wall_share = 1;
  };
  EXPECT_EQ(word_with(rolls, false), "rolling on the wall");
  EXPECT_EQ(word_with(rolls), "rolling on the wall");
}

TEST(Regime, of_avalanches_between_rests_is_slumping) {
  EXPECT_EQ(word_with([](RegimeSigns& s) { s.intermittency = 3, s.froude = 1e-4; }), "slumping");
  EXPECT_EQ(word_with([](RegimeSigns& s) { s.intermittency = 3, s.froude = 0.05; }), "cascading")
      << "a drum of this speed keeps the bed moving: the start was counted";
}

}  // namespace
}  // namespace mahlwerk::results::regime_rule_test
