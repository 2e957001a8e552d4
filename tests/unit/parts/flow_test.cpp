// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What passes and stays (flo.2 to flo.7), by hand.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/random.hpp"
#include "mahlwerk/parts/flow/flow_record.hpp"
#include "mahlwerk/parts/flow/residence.hpp"
#include "statement.hpp"

namespace mahlwerk::parts::flow::flow_test {
namespace {

using tests::states;

TEST(ResidenceTimes, of_balls_that_all_left_have_their_mean_and_spread) {
  const ResidenceTimes found = residence_times({{4, true}, {1, true}, {2, true}, {1, true}});
  states("mean [s]", found.mean, 2, 1e-15, "(1 + 1 + 2 + 4)/4");
  states("spread [s]", found.spread, std::sqrt(1.5), 1e-15, "root of the mean square");
  ASSERT_EQ(found.steps.size(), 4U);
  states("still inside after 1 s", found.steps[1].inside, 0.5, 1e-15, "two of four");
}

TEST(ResidenceTimes, count_balls_that_are_still_inside_as_long_as_they_were_followed) {
  // After 1 s one of four leaves; one is followed for 2 s only; then one of two, and the last.
  const ResidenceTimes found = residence_times({{1, true}, {2, false}, {3, true}, {5, true}});
  ASSERT_EQ(found.steps.size(), 4U);
  states("inside after 3 s", found.steps[2].inside, 0.75 * 0.5, 1e-15, "3/4 times 1/2 (flo.6)");
  states("mean [s]", found.mean, 1 + 0.75 * 2 + 0.375 * 2, 1e-15, "area below the steps (flo.7)");
}

TEST(ResidenceTimes, are_unknown_where_many_stay_longer_than_any_was_followed) {
  EXPECT_TRUE(std::isnan(residence_times({{1, true}, {2, false}}).mean));
  EXPECT_TRUE(std::isnan(residence_times({{1, true}, {2, false}}).spread));
  EXPECT_TRUE(std::isnan(residence_times({}).mean));
}

TEST(ResidenceTimes, of_an_ideal_mixer_are_found_although_half_are_cut_off) {
  Random random(1, 0);
  std::vector<Tracer> tracers;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const double stays = -math::log(random.uniform()), followed = 8 * random.uniform();
    tracers.push_back({std::min(stays, followed), stays <= followed});
  }
  const ResidenceTimes found = residence_times(tracers);
  states("mean [s]", found.mean, 1, 4 / std::sqrt(count), "exponential distribution, 4 sigma");
  states("spread [s]", found.spread, 1, 8 / std::sqrt(count), "likewise");
}

constexpr double m = 0.5;  // [kg] of a ball of the first set; 2 m of the second

scene::Passage passage(double time, int ball, bool entered) {
  const bool second = ball >= 2;
  return {time, second ? 2 * m : m, ball, second ? 1 : 0, entered ? 1 : 0};
}

FlowRecord record() {
  return FlowRecord({.inside = {{2, 2 * m}, {1, 2 * m}}, .balls = 3, .interval = 1.0});
}

/// The same balls, of which the two of the first set wait outside.
FlowRecord fresh(bool returns) {
  return FlowRecord({.inside = {{0, 0}, {1, 2 * m}},
                     .balls = 3,
                     .interval = 1.0,
                     .fresh = 2,
                     .returns = returns});
}

scene::EnergyBalance at(double time) {
  scene::EnergyBalance now;
  now.time = time;
  return now;
}

TEST(FlowRecord, knows_what_is_inside_since_the_start_and_counts_from_begin) {
  FlowRecord flow = record();
  flow.passages(std::array{passage(0.5, 0, false)});
  flow.begin(1);
  flow.take(at(1));
  flow.passages(std::array{passage(1.5, 2, false), passage(2.5, 0, true)});
  flow.take(at(3.2));
  ASSERT_EQ(flow.times().size(), 3U);
  EXPECT_EQ(flow.sample(0, 0).inside.count, 1) << "one left before counting";
  EXPECT_EQ(flow.sample(0, 0).left.count, 0);
  EXPECT_EQ(flow.sample(2, 1).left.mass, 2 * m);
  EXPECT_EQ(flow.all().inside.count, 2);
  EXPECT_EQ(flow.all().inside.mass, 2 * m);
  // Two inside for 0.5 s, one for 1 s, two for 1 s.
  states("mean inside", flow.mean_inside(3.5).count, (1 + 1 + 2) / 2.5, 1e-15, "by hand");
  states("mean mass inside [kg]", flow.mean_inside(3.5).mass, (1.5 * m + m + 2 * m) / 2.5, 1e-15,
         "by hand");
}

TEST(FlowRecord, follows_only_balls_that_entered_since_counting_began) {
  FlowRecord flow = record();
  flow.passages(std::array{passage(0.2, 1, false), passage(0.5, 1, true)});
  flow.begin(1);
  flow.passages(std::array{passage(2, 0, false), passage(2, 1, false), passage(3, 0, true),
                           passage(3, 1, true), passage(5, 0, false)});
  const std::vector<Tracer> found = flow.tracers(6);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].time, 2);
  EXPECT_TRUE(found[0].left);
  EXPECT_EQ(found[1].time, 3);
  EXPECT_FALSE(found[1].left);
}

TEST(FlowRecord, knows_how_many_wait_how_long_and_when_the_last_has_entered) {
  FlowRecord flow = fresh(false);
  flow.begin(1);
  EXPECT_EQ(flow.all().inside.count, 1) << "the balls of the other set";
  flow.passages(std::array{passage(2, 0, true)});
  EXPECT_FALSE(flow.exhausted().has_value());
  flow.passages(std::array{passage(4, 1, true), passage(5, 0, false)});
  states("waiting", flow.queue(6).mean, (2 * 1 + 1 * 2) / 5.0, 1e-15, "two for 1 s, one for 2 s");
  states("with one or more [s]", flow.queue(6).busy_time, 3, 1e-15, "until the last entered");
  ASSERT_TRUE(flow.exhausted().has_value());
  states("last entry [s]", *flow.exhausted(), 4, 0, "by hand");
}

TEST(FlowRecord, what_has_left_waits_again_if_it_returns) {
  FlowRecord flow = fresh(true);
  flow.begin(0);
  flow.passages(std::array{passage(1, 0, true), passage(1, 1, true), passage(3, 2, false)});
  EXPECT_FALSE(flow.exhausted().has_value());
  states("waiting", flow.queue(4).mean, (2 * 1 + 0 * 2 + 1 * 1) / 4.0, 1e-15, "by hand");
}

TEST(FlowRecord, goes_on_from_its_saved_state) {
  FlowRecord whole = fresh(true), resumed = fresh(true);
  const std::array first{passage(1.5, 0, true)}, second{passage(2.5, 0, false)};
  for (FlowRecord* one : {&whole, &resumed}) one->begin(1), one->passages(first), one->take(at(2));
  Archive out;
  resumed.serialize(out);
  resumed = fresh(true);
  Archive in(out.bytes());
  resumed.serialize(in);
  in.finish();
  for (FlowRecord* one : {&whole, &resumed}) one->passages(second), one->take(at(3));
  Archive a, b;
  whole.serialize(a), resumed.serialize(b);
  EXPECT_EQ(a.bytes(), b.bytes());
}

}  // namespace
}  // namespace mahlwerk::parts::flow::flow_test
