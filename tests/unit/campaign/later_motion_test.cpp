// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Motion that changes after the counted time (sta.14).
#include "mahlwerk/campaign/run/later_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/campaign/runs.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::later_motion_test {
namespace {

using cases::sample::catalogue;

/// Five balls in a vial: irregular at first, in step with the mill after about two seconds.
cases::Case vial(const std::string& run, const std::string& count = "5") {
  return cases::read_text(R"(
seed = 648
[mill]
kind = "vibration"
frequency = "41.95 Hz"
amplitude = "0.6438 mm"
[jar]
kind = "cylinder"
diameter = "17.29 mm"
height = "21.68 mm"
[[balls]]
count = )" + count + R"(
diameter = "3.03 mm"
density = "6050 kg/m3"
[contact]
restitution = 0.418
friction = 0.165
[run]
)" + run,
                          "case.toml", catalogue(), {});
}

bool told(const cases::Case& c) {
  const results::Outcome outcome = run(c, on(2));
  return std::ranges::any_of(outcome.notices,
                             [](const Notice& n) { return n.code == "changes-later"; });
}

TEST(LaterMotion, is_told_where_balls_fall_in_step_after_the_counted_time) {
  EXPECT_TRUE(told(vial("time = \"0.3 s\"\n")));
}

TEST(LaterMotion, is_not_told_of_a_motion_that_lasts) {
  EXPECT_FALSE(told(vial("time = \"0.3 s\"\n", "1"))) << "one ball, in step from the start";
}

TEST(LaterMotion, is_looked_for_where_the_program_settles_and_chooses_the_engine_only) {
  EXPECT_EQ(later_motion_cost(vial("time = \"0.3 s\"\nsettle = \"0.1 s\"\n"), 0.1), 0);
  EXPECT_EQ(later_motion_cost(vial("time = \"0.3 s\"\nengine = \"soft\"\n"), 0.1), 0);
  EXPECT_EQ(later_motion_cost(vial("time = \"0.3 s\"\n", "7"), 0.1), 0);
  EXPECT_EQ(later_motion_cost(vial("time = \"3 s\"\n"), 0.1), 0) << "more than 40 periods";
  // Three replicates of 4 (0.1 + 0.3) + 2 0.3 s over five of 0.4 s.
  EXPECT_NEAR(later_motion_cost(vial("time = \"0.3 s\"\n"), 0.1), 3 * 2.2 / 2, 1e-2);
}

}  // namespace
}  // namespace mahlwerk::campaign::later_motion_test
