// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/points/plan.hpp"

#include <gtest/gtest.h>

#include <set>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/number_text.hpp"

namespace mahlwerk::campaign::plan_test {
namespace {

using cases::Design;
using cases::Sweep;
using cases::SweptKey;
using Values = std::vector<std::string>;

SweptKey list(const std::string& key, Values values) {
  return {.key = key, .values = std::move(values)};
}
SweptKey range(const std::string& key, const std::string& from, const std::string& to,
               std::int64_t steps = 0, bool logarithmic = false) {
  return {key, {from, to}, true, steps, logarithmic};
}

std::vector<Values> all(const Plan& plan) {
  std::vector<Values> points;
  for (std::size_t i = 0; i < plan.size(); ++i) points.push_back(plan.values(i));
  return points;
}

TEST(Plan, a_grid_is_every_combination_the_last_key_fastest) {
  Sweep sweep;
  sweep.keys = {list("a", {"1", "2"}), list("b", {"x", "y", "z"})};
  EXPECT_EQ(all(Plan(sweep, 1)),
            (std::vector<Values>{
                {"1", "x"}, {"1", "y"}, {"1", "z"}, {"2", "x"}, {"2", "y"}, {"2", "z"}}));
}

TEST(Plan, keys_that_go_together_go_side_by_side) {
  Sweep sweep;
  sweep.keys = {list("a", {"1", "2"}), list("b", {"x", "y", "z"}), list("c", {"7", "8"})};
  sweep.together = {{"a", "c"}};
  EXPECT_EQ(all(Plan(sweep, 1)), (std::vector<Values>{{"1", "x", "7"},
                                                      {"1", "y", "7"},
                                                      {"1", "z", "7"},
                                                      {"2", "x", "8"},
                                                      {"2", "y", "8"},
                                                      {"2", "z", "8"}}));
}

TEST(Plan, a_range_with_steps_is_even_from_end_to_end) {
  Sweep sweep;
  sweep.keys = {range("contact.restitution", "0.35", "0.9", 12)};
  EXPECT_EQ(Plan(sweep, 1).values(0), (Values{"0.35"}));
  EXPECT_EQ(Plan(sweep, 1).values(1), (Values{"0.4"}));
  EXPECT_EQ(Plan(sweep, 1).values(11), (Values{"0.9"}));
  sweep.keys = {range("run.time", "1 ms", "10 s", 5, true)};
  EXPECT_EQ(all(Plan(sweep, 1)),
            (std::vector<Values>{{"0.001 s"}, {"0.01 s"}, {"0.1 s"}, {"1 s"}, {"10 s"}}));
}

TEST(Plan, the_unit_of_a_range_is_that_of_its_upper_end) {
  EXPECT_EQ(value_in_range(range("mill.speed", "1 Hz", "120 rpm"), 0), "60 rpm");
  EXPECT_EQ(value_in_range(range("mill.speed", "1 Hz", "120 rpm"), 0.5), "90 rpm");
  EXPECT_EQ(value_in_range(range("jar.diameter", "10 mm", "0.02 m"), 1), "0.02 m");
  EXPECT_EQ(value_in_range(range("heat.ambient", "20 degC", "50 degC"), 0), "20 degC");
  EXPECT_EQ(value_in_range(range("heat.ambient", "293.15 K", "50 degC"), 0.5), "35 degC");
}

TEST(Plan, balls_are_counted_in_whole_numbers) {
  EXPECT_EQ(value_in_range(range("balls.2.count", "1", "10"), 0.5), "6");
  EXPECT_EQ(value_in_range(range("mill.ratio", "-3", "-1"), 0.25), "-2.5");
}

TEST(Plan, ranges_that_are_none_are_refused) {
  const auto refused = [](const SweptKey& key) {
    try {
      value_in_range(key, 0);
    } catch (const InputError& error) {
      return error.faults().front().code == "bad-range";
    }
    return false;
  };
  EXPECT_TRUE(refused(range("a", "1 mm", "5 s")));
  EXPECT_TRUE(refused(range("a", "5 mm", "5 mm")));
  EXPECT_TRUE(refused(range("a", "5 mm", "1 mm")));
  EXPECT_TRUE(refused(range("a", "one", "two")));
  EXPECT_TRUE(refused(range("a", "1 foo", "2 foo")));
  EXPECT_TRUE(refused(range("a", "0", "1", 0, true)));
  Sweep sweep;
  for (const char* key : {"a", "b", "c"}) sweep.keys.push_back(range(key, "0", "1", 1000));
  EXPECT_THROW(Plan(sweep, 1), InputError);  // 1e9 points
  sweep.design = Design::morris;
  sweep.samples = 9'000'000;
  EXPECT_THROW(Plan(sweep, 1), InputError);
}

TEST(Plan, a_latin_hypercube_meets_each_part_of_each_range_once) {
  Sweep sweep;
  sweep.design = Design::latin_hypercube;
  sweep.samples = 50;
  sweep.keys = {range("a", "0 mm", "50 mm"), range("b", "100 rpm", "600 rpm")};
  const Plan plan(sweep, 3);
  ASSERT_EQ(plan.size(), 50U);
  std::set<int> a, b;
  for (const Values& values : all(plan)) {
    a.insert(static_cast<int>(number_text(values[0]).number));
    b.insert(static_cast<int>((number_text(values[1]).number - 100) / 10));
    EXPECT_TRUE(values[0].ends_with(" mm")) << values[0];
  }
  EXPECT_EQ(a.size(), 50U);
  EXPECT_EQ(b.size(), 50U);
  EXPECT_EQ(all(plan), all(Plan(sweep, 3)));
  EXPECT_NE(all(plan), all(Plan(sweep, 4)));
}

TEST(Plan, one_at_a_time_leaves_the_others_as_the_case_has_them) {
  Sweep sweep;
  sweep.design = Design::one_at_a_time;
  sweep.keys = {range("a", "1", "3"), range("b", "5 mm", "7 mm")};
  EXPECT_EQ(all(Plan(sweep, 1)),
            (std::vector<Values>{{"", ""}, {"1", ""}, {"3", ""}, {"", "5 mm"}, {"", "7 mm"}}));
}

TEST(Plan, a_key_that_stays_as_the_case_has_it_is_not_put_into_it) {
  Sweep sweep;
  sweep.design = Design::one_at_a_time;
  sweep.keys = {range("a", "1", "3"), range("b", "5 mm", "7 mm")};
  EXPECT_TRUE(Plan(sweep, 1).overrides(0).empty());
  const auto last = Plan(sweep, 1).overrides(4);
  ASSERT_EQ(last.size(), 1U);
  EXPECT_EQ(last[0].key, "b");
  EXPECT_EQ(last[0].value, "7 mm");
  EXPECT_EQ(last[0].source, cases::ValueSource::sweep);
}

TEST(Plan, designs_have_as_many_points_as_they_say) {
  Sweep sweep;
  sweep.samples = 6;
  sweep.keys = {range("a", "1", "3"), range("b", "5", "7"), range("c", "5", "7")};
  sweep.design = Design::sobol;
  EXPECT_EQ(Plan(sweep, 1).size(), 6U);
  sweep.design = Design::morris;
  EXPECT_EQ(Plan(sweep, 1).size(), 24U);
  sweep.design = Design::sobol_indices;
  EXPECT_EQ(Plan(sweep, 1).size(), 30U);
}

}  // namespace
}  // namespace mahlwerk::campaign::plan_test
