// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Runs that continue until a quantity is known well enough: [run] time = "until 2 %".
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/results/notices/warnings.hpp"
#include "mahlwerk/results/quantities/series.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"
#include "statement.hpp"
#include "unit/campaign/observed.hpp"

namespace mahlwerk::campaign::until_test {
namespace {

using tests::states;
using tests::stays_below;

/// A period is 50 ms.
cases::Case waiting(double within, double longest) {
  cases::Case c = shaken("event", 1);
  c.contact.rule.restitution = 0.9;
  c.run.until = cases::StopCriterion{within, "dissipated_power"};
  c.run.time = longest;
  return c;
}

double found(const results::Replicate& r) {
  const observe::Estimate e =
      observe::time_series_estimate(results::series(r.windows, "dissipated_power"));
  return e.ci95 / e.mean;
}

bool warned(const cases::Case& mill_case, const results::Replicate& r) {
  results::Outcome outcome;
  outcome.mill_case = mill_case;
  outcome.replicates = {r};
  outcome.summary = results::summarise(outcome);
  return std::ranges::any_of(results::warnings(outcome), [](const Notice& one) {
    return one.code == "not-certain" &&
           one.text.find("dissipated_power is not known within") != std::string::npos;
  });
}

TEST(Until, a_run_ends_with_the_certainty_asked_for) {
  double shorter = 0;
  for (const double within : {0.08, 0.04, 0.02}) {
    const cases::Case mill_case = waiting(within, 2000);
    ReplicateRun replica(mill_case, 0);
    const results::Replicate r = to_the_end(replica).result();
    EXPECT_TRUE(r.complete);
    EXPECT_TRUE(r.precision_reached);
    EXPECT_FALSE(warned(mill_case, r));
    stays_below("half-width over mean", found(r), within, "over_time() of the windows");
    EXPECT_GT(r.time(), shorter) << "more certainty takes longer";
    EXPECT_LT(r.time(), 1999);
    shorter = r.time();
    double sum = 0;
    for (const results::Window& w : r.windows) sum += w.length;
    states("windows sum to the counted time [s]", sum, r.time(), 1e-9 * r.time(), "none is lost");
  }
}

TEST(Until, goes_on_to_the_longest_time_otherwise_and_says_so) {
  const cases::Case mill_case = waiting(0.001, 7);
  ReplicateRun replica(mill_case, 0);
  const results::Replicate r = to_the_end(replica).result();
  EXPECT_TRUE(r.complete);
  EXPECT_FALSE(r.precision_reached);
  EXPECT_GT(found(r), 0.001);
  EXPECT_TRUE(warned(mill_case, r));
  states("time [s]", r.time(), 7, 0.05 + 1e-9, "a window of one period");
}

TEST(Until, goes_on_from_a_saved_state_to_the_same_bits) {
  const cases::Case mill_case = waiting(0.03, 1000);
  ReplicateRun whole(mill_case, 0);
  const results::Replicate one = to_the_end(whole).result();
  for (const double share : {0.1, 0.5, 0.9}) {
    ReplicateRun first(mill_case, 0), second(mill_case, 0);
    while (first.energy_balance().time < share * one.energy_balance.time && !first.done())
      first.run_slice();
    ASSERT_FALSE(first.done());
    Archive out;
    first.serialize(out);
    Archive in(out.bytes());
    second.serialize(in);
    in.finish();
    const results::Replicate other = to_the_end(second).result();
    EXPECT_EQ(other.energy_balance.time, one.energy_balance.time);
    EXPECT_EQ(other.energy_balance.lost_normal, one.energy_balance.lost_normal);
    EXPECT_EQ(other.tally.all.energy_centre, one.tally.all.energy_centre);
    EXPECT_EQ(other.charge.mass_total, one.charge.mass_total);
    EXPECT_EQ(results::series(other.windows, "drawn_power"),
              results::series(one.windows, "drawn_power"));
  }
}

/// A state contains everything that a replicate stores: windows, and sums in a fixed number of bins
/// and cells, of which those that are not zero are written.
TEST(Until, windows_stay_between_100_and_200_and_memory_does_not_grow) {
  const cases::Case mill_case = waiting(1e-6, 90);  // 1800 periods
  ReplicateRun replica(mill_case, 0);
  std::size_t most = 0, least = 1000, size = 0;
  while (!replica.done()) {
    replica.run_slice();
    const std::size_t windows = replica.result().windows.size();
    if (replica.energy_balance().time < 12) continue;  // 200 periods
    most = tests::max_or_nan(most, windows);
    least = std::min(least, windows);
    Archive state;
    replica.serialize(state);
    size = state.bytes().size() - windows * sizeof(results::Window);
  }
  EXPECT_LE(most, 200U);
  EXPECT_GE(least, 99U);
  stays_below("bytes of the statistics", static_cast<double>(size), memory_kept(mill_case),
              "all bins and cells occupied");
}

}  // namespace
}  // namespace mahlwerk::campaign::until_test
