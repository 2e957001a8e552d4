// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The section [flow], and what it refuses.
#include <gtest/gtest.h>

#include <string>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/write.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::flow_test {
namespace {

using namespace sample;

const std::string hopper = R"(title = "Hopper"
[mill]
kind = "still"
[jar]
kind = "cylinder"
diameter = "40 mm"
height = "60 mm"
[[parts]]
name = "floor"
kind = "ring"
diameter = "44 mm"
hole = "16 mm"
thickness = "4 mm"
position = ["0 mm", "0 mm", "-18 mm"]
[[balls]]
diameter = "3 mm"
density = "2500 kg/m3"
count = 50
[flow]
outlet = ["0 mm", "0 mm", "-22 mm"]
feed = "recirculate"
inlet = ["0 mm", "0 mm", "20 mm"]
inlet_size = ["20 mm", "20 mm", "5 mm"]
[run]
time = "1 s"
engine = "soft"
)";

/// The only fault of the hopper with a line changed.
Fault only_fault(std::string_view key, const std::string& line) {
  const std::vector<Fault> found = faults_of(with(hopper, key, line));
  EXPECT_EQ(found.size(), 1U) << line;
  return found.empty() ? Fault{} : found.front();
}

TEST(FlowSection, is_read) {
  const Case c = read_sample(hopper);
  ASSERT_TRUE(c.flow.has_value());
  EXPECT_EQ(c.flow->outlet.z, -0.022);
  EXPECT_EQ(c.flow->outlet_normal, (Vec3{0, 0, -1}));
  EXPECT_EQ(c.flow->feed, Flow::Feed::recirculate);
  EXPECT_EQ(c.flow->inlet_size.z, 0.005);
}

TEST(FlowSection, lies_in_the_axes_of_the_jar) {
  Case c = read_sample(hopper);
  c.mill.jar_axis = {1, 0, 0};
  const scene::Flow flow = flow_in_jar_frame(c);
  EXPECT_NEAR(flow.outlet.x, -0.022, 1e-15);
  EXPECT_NEAR(flow.outlet_normal.x, -1, 1e-15);
  EXPECT_NEAR(flow.inlet.x, 0.02, 1e-15);
  EXPECT_NEAR((flow.axes * Vec3{0, 0, 1}).x, 1, 1e-15);
}

TEST(FlowSection, with_a_feed_needs_an_inlet) {
  for (const char* key : {"inlet = ", "inlet_size", "outlet = "})
    EXPECT_EQ(only_fault(key, "").code, "missing-value") << key;
}

TEST(FlowSection, without_a_feed_has_no_inlet) {
  EXPECT_FALSE(faults_of(with(hopper, "feed", "feed = \"none\"")).empty());
  EXPECT_FALSE(
      faults_of(with(hopper, "feed", "feed = \"recirculate\"\nfeed_rate = \"3 Hz\"")).empty());
}

TEST(FlowSection, with_an_inlet_that_no_ball_fits_is_refused) {
  for (const char* place : {"inlet = [\"0 mm\", \"0 mm\", \"80 mm\"]",      // outside the jar
                            "inlet = [\"0 mm\", \"40 mm\", \"20 mm\"]"}) {  // in its wall
    const Fault fault = only_fault("inlet = ", place);
    EXPECT_EQ(fault.code, "bad-flow");
    EXPECT_NE(fault.what.find("no ball of 3 mm fits into the inlet"), std::string::npos);
  }
  const std::string blocked = with(with(hopper, "kind = \"ring", "kind = \"disc\""), "hole", "");
  const std::string in_part =
      with(with(blocked, "inlet = ", "inlet = [\"0 mm\", \"0 mm\", \"-18 mm\"]"), "inlet_size",
           "inlet_size = [\"1 mm\", \"1 mm\", \"1 mm\"]");
  const auto found = faults_of(in_part);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "bad-flow");
}

TEST(FlowSection, with_an_inlet_beyond_the_outlet_is_refused) {
  const Fault fault = only_fault("inlet = ", "inlet = [\"0 mm\", \"0 mm\", \"-26 mm\"]");
  EXPECT_EQ(fault.code, "bad-flow");
  EXPECT_NE(fault.what.find("beyond the outlet"), std::string::npos);
}

TEST(FlowSection, with_the_whole_jar_beyond_the_outlet_is_refused) {
  const auto found =
      faults_of(with(hopper, "outlet = ", "outlet = [\"0 mm\", \"0 mm\", \"31 mm\"]"));
  ASSERT_FALSE(found.empty());
  EXPECT_NE(found[0].what.find("the whole jar lies beyond the outlet"), std::string::npos);
}

const std::string fed = with(hopper, "feed",
                             "feed = \"rate\"\nfeed_mass_rate = \"5 g/s\"\nfresh_feed = "
                             "[\"balls.2\"]") +
                        R"([[balls]]
diameter = "2 mm"
density = "2500 kg/m3"
filling = "90 %"
)";

TEST(FreshFeed, is_read_written_and_waits_outside) {
  const Case c = read_sample(fed);
  EXPECT_EQ(c.flow->fresh_feed, std::vector<std::string>{"balls.2"});
  EXPECT_EQ(c.flow->feed_mass_rate, 0.005);
  EXPECT_FALSE(flow_in_jar_frame(c).returns);
  EXPECT_EQ(read_sample(write(c)).flow, c.flow);
  const std::vector<scene::Ball> balls = starting_balls(c, 0);
  ASSERT_EQ(std::ssize(balls), c.balls[0].count + c.balls[1].count);
  for (const scene::Ball& b : balls) EXPECT_EQ(b.outside, b.kind == 1);
}

/// 90 % of the jar as solid spheres is denser than any packing, but these balls are not in it.
TEST(FreshFeed, may_be_more_than_the_jar_holds) {
  EXPECT_TRUE(faults_of(fed).empty());
  EXPECT_EQ(faults_of(with(fed, "fresh_feed", "fresh_feed = [\"balls.1\"]")).front().code,
            "too-many-balls");
}

TEST(FreshFeed, of_all_balls_leaves_the_jar_empty) {
  const Case c = read_sample(with(fed, "fresh_feed", "fresh_feed = [\"balls\"]"));
  EXPECT_TRUE(sets_at_start(c).empty());
  for (const scene::Ball& b : starting_balls(c, 0)) EXPECT_TRUE(b.outside);
  for (const DerivedQuantity& q : derived_quantities(c))
    EXPECT_TRUE(q.name != "filling" || q.value == 0);
}

/// The balls inside start where they do without the others.
TEST(FreshFeed, does_not_move_the_balls_inside) {
  const Case c = read_sample(fed);
  const std::vector<scene::Ball> with_feed = starting_balls(c, 0),
                                 alone = starting_balls(read_sample(hopper), 0);
  for (std::size_t i = 0; i < alone.size(); ++i)
    EXPECT_EQ(with_feed[i].position, alone[i].position) << i;
}

TEST(FreshFeed, that_is_wrong_is_refused) {
  const auto code = [](std::string_view key, const std::string& line) {
    const std::vector<Fault> found = faults_of(with(fed, key, line));
    return found.empty() ? "none" : found.front().code;
  };
  EXPECT_EQ(code("fresh_feed", "fresh_feed = [\"ore\"]"), "bad-flow");
  EXPECT_EQ(code("fresh_feed", "fresh_feed = \"balls.2\""), "wrong-type");
  EXPECT_EQ(code("fresh_feed", "recirculate = true"), "too-much") << "nothing fresh";
  EXPECT_EQ(code("fresh_feed", "recirculate = false"), "none") << "the default may stand";
  EXPECT_EQ(code("feed_mass_rate", "feed_mass_rate = \"5 g/s\"\nfeed_rate = \"3 Hz\""), "too-much");
  EXPECT_EQ(code("filling", "positions = [[\"0 mm\", \"0 mm\", \"0 mm\"]]"), "bad-flow");
  EXPECT_EQ(code("feed", "feed = \"none\""), "too-much");
}

TEST(FlowSection, is_refused_with_a_liquid_and_a_final_state) {
  EXPECT_EQ(faults_of(hopper + "[observe]\nfinal_state = true\n").front().code, "bad-flow");
}

TEST(FlowSection, is_refused_by_the_event_engine) {
  Case c = read_sample(hopper);
  c.machine_parts.clear();
  c.run.engine = EngineName::event;
  const std::vector<Fault> found = engine_faults(c);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "flow-needs-soft");
  c.run.engine = EngineName::automatic;
  EXPECT_TRUE(engine_faults(c).empty()) << "auto takes the soft engine";
}

TEST(Ring, with_a_hole_as_wide_as_itself_is_refused) {
  const auto found = faults_of(with(hopper, "hole", "hole = \"44 mm\""));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "bad-part");
}

TEST(Grate, with_an_opening_below_the_smallest_ball_is_refused) {
  const auto found = faults_of(with(hopper, "hole", "hole = \"16 mm\"\nopening = \"2 mm\""));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "bad-part");
}

}  // namespace
}  // namespace mahlwerk::cases::flow_test
