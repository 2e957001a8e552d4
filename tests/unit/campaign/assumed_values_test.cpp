// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What the assumed values of a single run decide.
#include "mahlwerk/campaign/run/assumed_values.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "statement.hpp"
#include "unit/campaign/runs.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::assumed_values_test {
namespace {

using cases::sample::catalogue;
using tests::states;

/// Three balls in a vibration mill, without restitution and friction.
std::string mill(const std::string& run) {
  return R"(
title = "three balls"
[mill]
kind = "vibration"
frequency = "20 Hz"
amplitude = "8 mm"
[jar]
kind = "cylinder"
diameter = "40 mm"
height = "40 mm"
youngs_modulus = "1 GPa"
[[balls]]
count = 3
diameter = "10 mm"
density = "7850 kg/m3"
youngs_modulus = "1 GPa"
[powder]
mass = "1 g"
[run]
engine = "event"
time = "1 s"
settle = "0.1 s"
)" + run;
}

std::optional<results::Sensitivity> found(const std::string& text, int threads = 1) {
  const auto read = [&](const std::string& key, const std::string& value) {
    return cases::read_text(text, "case.toml", catalogue(), {{key, value}});
  };
  const cases::Case c = cases::read_text(text, "case.toml", catalogue(), {});
  return sensitivity_to_assumed(run(c, on(threads)), read, on(threads));
}

TEST(AssumedValues, are_varied_to_both_ends_of_their_range_the_largest_influence_first) {
  const std::string text = mill("replicates = 5\n");
  const results::Sensitivity one = found(text).value();
  ASSERT_EQ(one.keys.size(), 2U);
  EXPECT_EQ(one.quantities.front(), "dissipated_power");
  const auto span = [&](std::size_t i) {
    return std::abs(one.keys[i].at_ends[1][0] - one.keys[i].at_ends[0][0]);
  };
  EXPECT_GE(span(0), span(1));
  const auto power = [&](cases::Case c) {
    return named(run(c, on(1)).summary.quantities, "dissipated_power").value;
  };
  const auto shorter = [&](const std::vector<cases::Override>& set) {
    cases::Case c = cases::read_text(text, "case.toml", catalogue(), set);
    c.run.time = one.time;
    c.run.replicates = 1;
    return power(c);
  };
  const double result = power(cases::read_text(text, "case.toml", catalogue(), {}));
  for (const results::AssumedInfluence& key : one.keys)
    for (std::size_t end = 0; end < 2; ++end)
      states(key.key + " = " + key.ends[end] + ", power [W]", key.at_ends[end][0],
             result * (shorter({{key.key, key.ends[end]}}) / shorter({})), 0,
             "the same runs by themselves, relative to the assumed value");
}

TEST(AssumedValues, that_change_nothing_have_no_range) {
  const results::Sensitivity one = found(mill("replicates = 5\n")).value();
  results::Sensitivity same = one;
  for (results::AssumedInfluence& key : same.keys)
    for (std::vector<double>& values : key.at_ends) values.assign(values.size(), 7.0);
  same.scatter.assign(same.scatter.size(), 1.0);
  const auto range = same.range("dissipated_power", 6.5);
  ASSERT_TRUE(range);
  EXPECT_EQ(range->first, 6.5) << "0.5 is within the scatter of 1";
  EXPECT_EQ(range->second, 6.5);
  EXPECT_EQ(same.range("dissipated_power", 5.5)->second, 7.0) << "1.5 is beyond it";
  EXPECT_GT(one.scatter.front(), 0) << "five replicates scatter";
}

TEST(AssumedValues, have_the_same_bits_on_any_number_of_threads) {
  const std::string text = mill("replicates = 5\n");
  const results::Sensitivity one = found(text, 1).value(), two = found(text, 2).value();
  ASSERT_EQ(one.keys.size(), two.keys.size());
  for (std::size_t i = 0; i < one.keys.size(); ++i) {
    EXPECT_EQ(one.keys[i].key, two.keys[i].key);
    EXPECT_EQ(one.keys[i].at_ends[0][0], two.keys[i].at_ends[0][0]);
    EXPECT_EQ(one.keys[i].at_ends[1][0], two.keys[i].at_ends[1][0]);
  }
}

TEST(AssumedValues, are_left_out_by_name_where_their_runs_cost_more_than_the_run) {
  // Two replicates of 1.1 s pay for three runs of 0.1 + 0.4 s: one as assumed, two for one key.
  const results::Sensitivity one = found(mill("replicates = 2\n")).value();
  EXPECT_EQ(one.keys.size(), 1U);
  EXPECT_EQ(one.left_out, std::vector<std::string>{"contact.friction"});
  const results::Sensitivity none = found(mill("replicates = 1\n")).value();
  EXPECT_TRUE(none.keys.empty()) << "1.1 s do not pay for 1.5 s";
  EXPECT_EQ(none.left_out.size(), 2U);
  EXPECT_EQ(found(mill("replicates = 1\nsensitivity = \"on\"\n"))->keys.size(), 2U);
  EXPECT_FALSE(found(mill("replicates = 5\nsensitivity = \"off\"\n")));
  EXPECT_FALSE(found(mill("replicates = 5\n[contact]\nrestitution = 0.5\nfriction = 0.2\n")))
      << "nothing with a known range was assumed";
}

}  // namespace
}  // namespace mahlwerk::campaign::assumed_values_test
