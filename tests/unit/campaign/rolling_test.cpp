// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/rolling.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mahlwerk/campaign/run/run.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::rolling_test {
namespace {

using cases::sample::read_sample;
using cases::sample::vial;

const std::string drum = R"(title = "a ball in a drum"
[mill]
kind = "tumbling"
speed = "60 rpm"
[jar]
kind = "cylinder"
diameter = "100 mm"
height = "50 mm"
[[balls]]
count = 1
diameter = "20 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.5
[run]
engine = "event"
settle = "1 s"
time = "1 s"
)";

Notices notices(const std::string& text, const std::vector<cases::Override>& set = {}) {
  RunOptions options;
  options.threads = 1;
  return rolling_notices(run(read_sample(text, set), options));
}

TEST(Rolling, a_ball_that_rolls_by_default_is_told_with_what_the_tc_rule_gives) {
  const Notices told = notices(drum);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].code, "mostly-rolling");
  EXPECT_EQ(told[0].severity, Severity::warning);
  EXPECT_NE(told[0].text.find("100 % of the time"), std::string::npos) << told[0].text;
  EXPECT_NE(told[0].text.find("with the TC rule (contact.lasting = \"tc\") dissipate"),
            std::string::npos)
      << told[0].text;
}

TEST(Rolling, is_not_told_where_the_case_asked_for_it_or_the_ball_flies) {
  EXPECT_TRUE(
      notices(drum, {{"contact.lasting", "roll"}, {"contact.lasting_friction", "0.3"}}).empty());
  EXPECT_TRUE(notices(drum, {{"contact.lasting", "tc"}}).empty());
  EXPECT_TRUE(notices(vial, {{"run.time", "1 s"}}).empty());
}

TEST(Rolling, is_part_of_the_outcome_once) {
  RunOptions options;
  options.threads = 1;
  const results::Outcome outcome = run(read_sample(drum, {{"run.time", "0.2 s"}}), options);
  EXPECT_EQ(std::ranges::count(outcome.notices, "mostly-rolling", &Notice::code), 1);
}

}  // namespace
}  // namespace mahlwerk::campaign::rolling_test
