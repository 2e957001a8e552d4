// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// One ball in both engines (docs/theory/engine-choice.md, "One ball").
#include "mahlwerk/campaign/run/other_engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/campaign/runs.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::other_engine_test {
namespace {

using cases::sample::catalogue;

/// A ball in a mixer mill: 66 hits per second by the rule of the event engine, 79 by contact
/// forces.
cases::Case mixer(const std::string& contact, const std::string& run,
                  const std::string& count = "1") {
  return cases::read_text(R"(
seed = 715
[mill]
kind = "arc-shaker"
frequency = "21.64 Hz"
arm = "136 mm"
swing = "3.9 deg"
[jar]
kind = "cylinder"
diameter = "29.44 mm"
height = "38.74 mm"
[[balls]]
count = )" + count + R"(
diameter = "9.854 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.733
)" + contact + R"([run]
time = "0.3 s"
)" + run,
                          "case.toml", catalogue(), {});
}

bool told(const cases::Case& c) {
  const results::Outcome outcome = run(c, on(2));
  return std::ranges::any_of(outcome.notices,
                             [](const Notice& n) { return n.code == "engines-differ"; });
}

TEST(OtherEngine, is_told_where_contact_forces_make_other_hits_than_the_rule) {
  EXPECT_TRUE(told(mixer("friction = 0.537\n", "")));
}

TEST(OtherEngine, is_not_told_where_both_agree) {
  EXPECT_FALSE(told(mixer("friction = 0\n", ""))) << "without friction both have the same law";
}

TEST(OtherEngine, is_looked_for_where_the_program_chose_for_one_ball_only) {
  EXPECT_FALSE(told(mixer("friction = 0.537\n", "engine = \"event\"\n")));
  EXPECT_FALSE(told(mixer("friction = 0.537\n", "engine = \"soft\"\n")));
  EXPECT_FALSE(told(mixer("friction = 0.537\n", "", "2"))) << "two run in the soft engine";
  EXPECT_FALSE(told(mixer("friction = 0.537\n", "replicates = 16\n"))) << "more than 5 s";
}

}  // namespace
}  // namespace mahlwerk::campaign::other_engine_test
