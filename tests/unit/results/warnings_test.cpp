// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/notices/warnings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"
#include "unit/results/fake.hpp"

namespace mahlwerk::results::warnings_test {
namespace {

bool has(const Notices& notices, const std::string& code) {
  return std::ranges::find(notices, code, &Notice::code) != notices.end();
}

/// One replicate of `windows` windows that dissipates `power(i)` [W] and draws `drawn(i)`.
template <class Power, class Drawn>
Outcome run_of(int windows, const Power& power, const Drawn& drawn) {
  Outcome o = fake_outcome({100});
  Replicate& r = o.replicates[0];
  r.windows.clear();
  double lost = 0, work = 0;
  for (int i = 0; i < windows; ++i) {
    const double length = 10.0 / windows;
    r.windows.push_back({.time = length * (i + 1),
                         .length = length,
                         .collisions = 10,
                         .lost = power(i) * length,
                         .wall_work = drawn(i) * length});
    lost += r.windows.back().lost;
    work += r.windows.back().wall_work;
  }
  r.energy_balance.lost_normal = r.at_settled.lost_normal + lost;
  r.at_settled.wall_work = 5;
  r.energy_balance.wall_work = 5 + work;
  r.energy_balance.kinetic = work - lost;
  return o;
}

TEST(NotSettled, is_told_of_a_start_that_stands_out_and_gains_energy) {
  const auto power = [](int i) { return i < 40 ? 0.5 + 0.0125 * i : 1.0; };
  const auto drawn = [](int i) { return 1.0 + 1e-4 * (i % 7); };
  const Notices notices = warnings(ended(run_of(200, power, drawn)));
  EXPECT_TRUE(has(notices, "not-settled"));
  EXPECT_FALSE(has(warnings(ended(run_of(200, drawn, drawn))), "not-settled"));
}

TEST(NotSettled, is_not_told_of_a_short_series) {
  const auto power = [](int i) { return i < 4 ? 0.5 : 1.0; };
  const auto drawn = [](int) { return 1.0; };
  for (const int windows : {1, 2, 10, 12, 40})
    EXPECT_FALSE(has(warnings(ended(run_of(windows, power, drawn))), "not-settled")) << windows;
}

TEST(NotSettled, is_not_told_where_the_stored_energy_goes_up_and_down) {
  // The power differs by chance between the halves of the run, and the stored energy oscillates.
  int told = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    Random random(5, seed);
    const double begin = random.uniform(0, 6.28);
    const auto power = [&](int i) { return 1 + 0.4 * random.uniform(-1, 1) + (i < 30 ? 0.2 : 0); };
    Outcome o = run_of(200, power, power);
    double before = std::sin(begin);
    for (int i = 0; i < 200; ++i) {  // 8 windows are a period
      results::Window& w = o.replicates[0].windows[static_cast<std::size_t>(i)];
      const double now = std::sin(begin + 6.28 / 8 * (i + 1));
      w.wall_work = w.lost + now - before;
      before = now;
    }
    o.replicates[0].energy_balance.wall_work += 0.5;  // 5 % of what is lost
    // A trend of the power itself (sta.12) has other words.
    told += std::ranges::any_of(warnings(ended(o)), [](const Notice& n) {
      return n.text.starts_with("The charge had not settled");
    });
  }
  EXPECT_EQ(told, 0) << "of 40 runs";
}

/// Three replicates of 200 windows whose hits scatter about `rate(share of the time)` per window.
template <class Rate>
Outcome run_with_hits(std::uint32_t seed, const Rate& rate) {
  Random random(17, seed);
  Outcome o = fake_outcome({100, 100, 100});
  for (Replicate& r : o.replicates) {
    r.windows.clear();
    for (int i = 0; i < 200; ++i) {
      double hits = 0;  // binomial of 20 draws
      for (int draw = 0; draw < 20; ++draw) hits += random.uniform(0, 20) < rate(i / 199.0) ? 1 : 0;
      r.windows.push_back(
          {.time = 0.05 * (i + 1), .length = 0.05, .above = hits, .lost = 1, .wall_work = 1});
    }
  }
  return o;
}

TEST(NotSettled, is_told_of_hits_that_fall_in_the_sum_of_the_replicates) {  // (sta.12)
  int falling = 0, steady = 0;
  constexpr int runs = 400;
  for (std::uint32_t seed = 0; seed < runs; ++seed) {
    const auto fall = [](double share) { return 0.3 - 0.2 * share; };  // 120 hits, by 100 %
    falling += has(warnings(ended(run_with_hits(seed, fall))), "not-settled") ? 1 : 0;
    const auto same = [](double) { return 0.2; };
    steady += has(warnings(ended(run_with_hits(seed, same))), "not-settled") ? 1 : 0;
  }
  // The change is 100 +- 33 % of the mean for 120 hits (Poisson): 3.2 errors are met in half.
  EXPECT_GT(falling, runs / 3) << "of " << runs;
  // 1.5 ci95 of 18 degrees of freedom: 0.55 % of 400 runs are 2.2, with a binomial scatter of 1.5.
  EXPECT_LE(steady, 2.2 + 4 * 1.5) << "of " << runs;
}

TEST(FewHits, are_told_below_a_hundred_and_not_where_there_is_none) {
  EXPECT_TRUE(has(warnings(ended(fake_outcome({60, 60, 60}))), "few-hits"));   // 90 above
  EXPECT_FALSE(has(warnings(ended(fake_outcome({80, 80, 80}))), "few-hits"));  // 120 above
  EXPECT_FALSE(has(warnings(ended(fake_outcome({0, 0, 0}))), "few-hits"));
}

TEST(Overlap, is_warned_of_by_what_was_reached) {
  Outcome o = fake_outcome();
  o.engine = cases::EngineName::soft;
  o.replicates[1].energy_balance.deepest_overlap = 0.009;
  EXPECT_TRUE(warnings(ended(o)).empty());
  o.replicates[1].energy_balance.deepest_overlap = 0.03;
  ASSERT_EQ(warnings(ended(o)).size(), 1U);
  EXPECT_EQ(warnings(ended(o))[0].code, "soft-contacts");
  EXPECT_NE(warnings(ended(o))[0].text.find("overlapped by 3 %"), std::string::npos);
  o.replicates[1].energy_balance.deepest_overlap = 0.3;
  ASSERT_EQ(warnings(ended(o)).size(), 1U);
  EXPECT_EQ(warnings(ended(o))[0].code, "deep-overlap");
}

TEST(Overlap, advice_does_not_ask_for_more_than_the_stiffness_of_the_material) {
  Outcome o = fake_outcome();
  o.engine = cases::EngineName::soft;
  o.replicates[1].energy_balance.deepest_overlap = 0.03;
  o.mill_case.contact.softening = 0.1;
  EXPECT_NE(warnings(ended(o))[0].text.find("contact.softening is 0.1, and 1 gives"),
            std::string::npos);
  o.mill_case.contact.softening = 1;
  const std::string text = warnings(ended(o))[0].text;
  EXPECT_EQ(text.find("larger contact.softening"), std::string::npos) << text;
  EXPECT_NE(text.find("check youngs_modulus"), std::string::npos) << text;
}

TEST(TwoStates, are_named_with_their_shares_and_values) {
  EXPECT_FALSE(summarise(fake_outcome({100, 101, 99, 102, 98, 100, 101, 99})).two_states);
  const Outcome o = fake_outcome({100, 900, 102, 98, 904, 101, 99, 100});
  const auto found = summarise(o).two_states;
  ASSERT_TRUE(found);
  EXPECT_EQ(found->states[0].replicates, (std::vector<std::size_t>{1, 3, 4, 6, 7, 8}));
  EXPECT_EQ(found->states[1].replicates, (std::vector<std::size_t>{2, 5}));
  EXPECT_DOUBLE_EQ(found->share(found->states[1]), 0.25);
  EXPECT_NEAR(named(found->states[0].quantities, "dissipated_power").value, 0.01,
              1e-12);  // 1 mJ each, 10 s
  EXPECT_NEAR(named(found->states[1].quantities, "dissipated_power").value, 0.0902, 1e-12);
  EXPECT_NEAR(named(found->states[1].quantities, "collision_rate_above_threshold").value, 45.1,
              1e-9);
  EXPECT_LE(found->p_value, 0.01);
  const Notices notices = warnings(ended(o));
  ASSERT_EQ(notices.size(), 1U);
  EXPECT_EQ(notices[0].code, "two-states");
  EXPECT_NE(notices[0].text.find("6 of 8 replicates (75 %) dissipate 10 mW"), std::string::npos)
      << notices[0].text;
}

/// The ball of replicate 1 is in contact for 0.6 of the 10 s more than that of replicate 0: told.
TEST(FlightAndRolling, is_told_where_replicates_differ_by_more_than_half_of_the_time) {
  Outcome o = fake_outcome({100, 101});
  const double balls = static_cast<double>(cases::balls_count(o.mill_case.balls));
  const auto told = [&](double share) {
    o.replicates[1].energy_balance.contact_time =
        o.replicates[0].energy_balance.contact_time + share * balls * o.replicates[1].time();
    const Notices all = warnings(ended(o));
    return std::ranges::any_of(all, [](const Notice& n) { return n.code == "flight-and-rolling"; });
  };
  EXPECT_FALSE(told(0));
  EXPECT_FALSE(told(0.49));
  EXPECT_TRUE(told(0.51));
}

TEST(TwoStates, that_hardly_differ_are_one) {
  EXPECT_FALSE(
      summarise(fake_outcome({1000, 1200, 1000, 1200, 1000, 1200, 1000, 1200})).two_states);
  EXPECT_TRUE(summarise(fake_outcome({1000, 1300, 1000, 1300, 1000, 1300, 1000, 1300})).two_states);
}

TEST(TwoStates, are_none_where_nothing_is_lost_but_by_rounding) {
  Outcome o = fake_outcome({100, 900, 102, 98, 904, 101, 99, 100});
  for (Replicate& r : o.replicates)
    r.windows[0].kinetic = 1e6;  // J: a power below 1e-4 W is rounding
  EXPECT_TRUE(summarise(o).two_states);
  for (Replicate& r : o.replicates) r.windows[0].kinetic = 1e12;
  EXPECT_FALSE(summarise(o).two_states);
}

TEST(TwoStates, need_four_replicates) {
  EXPECT_FALSE(summarise(fake_outcome({100, 100, 900})).two_states);
  EXPECT_FALSE(summarise(fake_outcome({})).two_states);
}

}  // namespace
}  // namespace mahlwerk::results::warnings_test
