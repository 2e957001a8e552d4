// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Maps and spectra of many replicates, summed up and forgotten while a run computes.
#include "mahlwerk/results/quantities/summed_up.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/notices/warnings.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::summed_up_test {
namespace {

using cases::sample::read_sample;
using cases::sample::vial;
using results::Outcome;

const std::string drum = R"([mill]
kind = "tumbling"
speed = "60 rpm"
[jar]
kind = "cylinder"
diameter = "50 mm"
height = "20 mm"
youngs_modulus = "200 GPa"
poisson_ratio = 0.3
hardness = 800
[[balls]]
count = 3
diameter = "8 mm"
density = "7850 kg/m3"
youngs_modulus = "200 GPa"
poisson_ratio = 0.3
hardness = 800
[contact]
restitution = 0.6
friction = 0.3
softening = 1e-4
[wear]
coefficient = 1e-4
[heat]
[run]
engine = "soft"
time = "0.05 s"
)";

cases::Case of_many(const std::string& text, const std::string& time) {
  cases::Case made = read_sample(text);
  made.run.replicates = 40;
  made.run.settle = 0;
  made.run.time = std::stod(time);
  return made;
}

Outcome outcome_of(const cases::Case& mill_case, bool sums_up, int threads = 2) {
  RunOptions options;
  options.threads = threads;
  options.sums_up = sums_up;
  return run(mill_case, options);
}

bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

/// All numbers of an outcome's tables are those of another one.
void expect_same_tables(const Outcome& found, const Outcome& expected) {
  const auto a = results::tables(found), b = results::tables(expected);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t t = 0; t < a.size(); ++t) {
    ASSERT_EQ(a[t].name, b[t].name);
    ASSERT_EQ(a[t].table.rows.size(), b[t].table.rows.size()) << a[t].name;
    for (std::size_t i = 0; i < a[t].table.rows.size(); ++i)
      EXPECT_TRUE(std::ranges::equal(a[t].table.rows[i], b[t].table.rows[i], same_bits))
          << a[t].name << ", row " << i;
  }
  EXPECT_EQ(found.summary.regime_reason, expected.summary.regime_reason);
  const Notices more = results::warnings(found), those = results::warnings(expected);
  ASSERT_EQ(more.size(), those.size());
  for (std::size_t i = 0; i < more.size(); ++i) EXPECT_EQ(more[i].text, those[i].text);
}

TEST(SummedUp, tables_and_notices_are_those_of_replicates_that_are_kept_to_the_bit) {
  for (const cases::Case& one : {of_many(vial, "0.3"), of_many(drum, "0.02")}) {
    const Outcome kept = outcome_of(one, false);
    ASSERT_EQ(kept.summed_up, nullptr);
    for (const int threads : {1, 2}) {
      const Outcome summed_up = outcome_of(one, true, threads);
      ASSERT_NE(summed_up.summed_up, nullptr);
      for (const results::Replicate& r : summed_up.replicates) EXPECT_TRUE(r.read_before);
      expect_same_tables(summed_up, kept);
    }
  }
}

/// Replicates that end one after the other in some order; those of `broken` before their end.
Outcome ended_in_order(Outcome outcome, const std::vector<std::size_t>& order,
                       const std::vector<std::size_t>& broken, bool sums_up) {
  for (const std::size_t one : broken) outcome.replicates[one].complete = false;
  results::SummingUp sums(outcome);
  for (const std::size_t one : order)
    if (sums_up) sums.ended(one);
  outcome.summary = results::summarise(outcome);
  return outcome;
}

TEST(SummedUp, the_order_in_which_replicates_end_changes_no_bit) {
  const Outcome kept = outcome_of(of_many(vial, "0.3"), false);
  std::vector<std::size_t> order(kept.replicates.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = (7 * i + 3) % order.size();
  expect_same_tables(ended_in_order(kept, order, {}, true), ended_in_order(kept, {}, {}, false));
}

/// One incomplete replicate is not averaged, so that means on the wall are over one fewer than was
/// expected; if all but one are incomplete, nothing is summed up.
TEST(SummedUp, incomplete_replicates_are_kept_and_left_out_of_means_as_they_are_otherwise) {
  const Outcome kept = outcome_of(of_many(vial, "0.3"), false);
  const std::size_t count = kept.replicates.size();
  std::vector<std::size_t> order(count), all_but_one(count - 1);
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  for (std::size_t i = 0; i + 1 < count; ++i) all_but_one[i] = i + 1;
  const Outcome one = ended_in_order(kept, order, {0, 5}, true);
  EXPECT_FALSE(one.replicates[5].read_before);
  EXPECT_TRUE(one.replicates[6].read_before);
  const Outcome same = ended_in_order(kept, {}, {0, 5}, false);
  const results::WallRates found = results::wall_rates(one), expected = results::wall_rates(same);
  for (std::size_t i = 0; i < found.rate.size(); ++i)
    EXPECT_NEAR(found.rate[i], expected.rate[i], 1e-12 * expected.rate[i]) << "cell " << i;
  const auto spectra = results::spectrum(one), those = results::spectrum(same);
  ASSERT_EQ(spectra.rows.size(), those.rows.size());
  EXPECT_EQ(spectra.rows, those.rows);
  const Outcome alone = ended_in_order(kept, order, all_but_one, true);
  EXPECT_EQ(alone.summed_up, nullptr);
  expect_same_tables(alone, ended_in_order(kept, {}, all_but_one, false));
}

}  // namespace
}  // namespace mahlwerk::campaign::summed_up_test
