// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Two states of one ball that few replicates do not show.
#include "mahlwerk/campaign/run/further_starts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "statement.hpp"
#include "unit/campaign/runs.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::further_starts_test {
namespace {

using cases::sample::catalogue;

/// A ball in a shaker that flies or stays on the wall: 1.2 and 2.2 W at restitution 0.24.
std::string shaker(double restitution, const std::string& run) {
  return fmt::format(R"(
title = "one ball"
seed = 5
[mill]
kind = "figure-eight"
frequency = "15.04 Hz"
stroke_along = "25 mm"
stroke_across = "5 mm"
stroke_up = "5 mm"
[jar]
kind = "cylinder"
diameter = "38 mm"
height = "44 mm"
[[balls]]
count = 1
diameter = "15 mm"
density = "3900 kg/m3"
[contact]
restitution = {}
friction = 0.171
[run]
time = "0.33 s"
)",
                     restitution) +
         run;
}

bool told(const std::string& text) {
  const results::Outcome outcome = run(cases::read_text(text, "case.toml", catalogue(), {}), on(2));
  return std::ranges::any_of(outcome.notices,
                             [](const Notice& n) { return n.code == "state-of-start"; });
}

TEST(FurtherStarts, show_the_two_states_of_one_ball_where_few_replicates_cannot) {
  EXPECT_TRUE(told(shaker(0.239, "replicates = 2\n")));
  EXPECT_FALSE(told(shaker(0.8, "replicates = 2\n"))) << "this ball moves in one way";
}

TEST(FurtherStarts, are_run_for_the_automatic_engine_and_few_replicates_only) {
  EXPECT_FALSE(told(shaker(0.239, "replicates = 2\nengine = \"event\"\n")));
  EXPECT_FALSE(told(shaker(0.239, "replicates = 16\n"))) << "the replicates tell by themselves";
}

TEST(FurtherStarts, are_not_run_for_points_of_a_campaign) {
  const cases::Case c =
      cases::read_text(shaker(0.239, "replicates = 2\n"), "case.toml", catalogue(), {});
  for (const results::Outcome& outcome : run(std::vector{c, c}, on(2)))
    EXPECT_FALSE(std::ranges::any_of(outcome.notices,
                                     [](const Notice& n) { return n.code == "state-of-start"; }));
}

TEST(FurtherStarts, end_when_the_user_stops) {
  const cases::Case c =
      cases::read_text(shaker(0.239, "replicates = 2\n"), "case.toml", catalogue(), {});
  const results::Outcome outcome = run(c, on(1));
  const std::atomic<bool> stop = true;
  EXPECT_FALSE(further_start_notices(outcome, nullptr).empty());
  EXPECT_TRUE(further_start_notices(outcome, &stop).empty());
}

}  // namespace
}  // namespace mahlwerk::campaign::further_starts_test
