// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Bond's test in locked cycles (bnd.1 to bnd.3) against a mill that breaks at first order.
#include "mahlwerk/powder/locked_cycle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "statement.hpp"

namespace mahlwerk::powder::locked_cycle_test_ {
namespace {

using tests::states;

constexpr double rate = 1e-3;  // per turn

/// Two octaves of one class each: above and below the screen at 0.1 mm.
SizeGrid two_classes() {
  return {0.1414e-3, 0.2e-3, 0.05e-3, 3};
}

/// All classes above the screen lose mass to the finest class at the same rate.
std::vector<double> first_order(const SizeGrid& grid, const std::vector<double>& shares,
                                double turns) {
  std::vector<double> out = shares;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (grid.lower(static_cast<int>(i)) < 0.0999e-3) continue;
    const double lost = shares[i] * (1 - std::exp(-rate * turns));
    out[i] -= lost, out.back() += lost;
  }
  return out;
}

LockedCycleTest test_with(double load, double fine, LockedCycleRules rules = {}) {
  const SizeGrid grid = two_classes();
  rules.circulating_load = load;
  rules.closing_size = grid.upper(grid.class_of(0.0999e-3));
  std::vector<double> feed(static_cast<std::size_t>(grid.classes()));
  feed.front() = 1 - fine, feed.back() = fine;
  return locked_cycle_test(grid, feed, rules, [&](const auto& shares, double turns) {
    return first_order(grid, shares, turns);
  });
}

TEST(LockedCycle, of_first_order_breakage_has_the_turns_and_grams_of_the_closed_form) {
  for (const double load : {1.0, 2.5, 4.0})
    for (const double fine : {0.0, 0.1}) {
      LockedCycleRules rules;
      rules.agreement = 1e-9, rules.most_cycles = 200;
      const LockedCycleTest found = test_with(load, fine, rules);
      ASSERT_TRUE(found.steady);
      // At the steady state the product i = 1/(1 + load) leaves, and comes in with the undersize
      // of the feed: (1 - fine i) exp(-k n) = 1 - i.
      const double i = 1 / (1 + load), turns = std::log((1 - fine * i) / (1 - i)) / rate;
      const Cycle& last = found.cycles.back();
      states("turns", last.turns, turns, 1e-6 * turns, "first order");
      states("grams per turn over the charge", found.per_turn, (1 - fine) * i / turns,
             1e-6 * i / turns, "first order");
      states("circulating load", last.circulating_load, load, 1e-6 * load, "rule of the test");
      states("mass", found.mass_error, 0, 1e-14, "mass balance of each cycle");
    }
}

TEST(LockedCycle, ends_when_three_cycles_agree_to_three_per_cent) {
  const LockedCycleTest found = test_with(2.5, 0.05);
  ASSERT_TRUE(found.steady);
  EXPECT_LE(found.cycles.size(), 12U);
  const double i = 1 / 3.5, turns = std::log((1 - 0.05 * i) / (1 - i)) / rate;
  states("grams per turn over the charge", found.per_turn, 0.95 * i / turns, 0.03 * i / turns,
         "first order, to the agreement asked");
}

TEST(LockedCycle, refuses_a_feed_that_passes_the_screen_and_a_rock_that_does_not_break) {
  EXPECT_THROW(test_with(2.5, 0.4), std::invalid_argument);
  const SizeGrid grid = two_classes();
  std::vector<double> feed(static_cast<std::size_t>(grid.classes()));
  feed.front() = 1;
  EXPECT_THROW(locked_cycle_test(grid, feed, {.closing_size = 0.1e-3},
                                 [](const auto& shares, double) { return shares; }),
               std::invalid_argument);
}

TEST(LockedCycle, work_index_is_that_of_the_formula_by_hand) {
  // 44.5/(100^0.23 x 1.5^0.82 x (10/sqrt 76 - 10/sqrt 2100)) = 11.913 kWh per short ton.
  states("work index [kWh/t]", bond_work_index(100e-6, 1.5, 2100e-6, 76e-6), 11.913 / 0.90718474,
         0.005, "Bond 1961");
}

TEST(LockedCycle, largest_ball_is_that_of_the_formulas_by_hand) {
  // sqrt(10000/350) (3 x 12/(72 sqrt(12)))^(1/3) in = 2.804 in, for 12 ft.
  states("Bond [m]", bond_ball_size(0.01, 12 / 0.90718474, 3000, 0.72, 12 * 0.3048),
         2.8045 * 0.0254, 1e-4, "Bond");
  // 4.5 x 10000^0.263 (3 x 13)^0.4/(15.228 x 4)^0.25 mm.
  states("Azzaroni [m]", azzaroni_ball_size(0.01, 13, 3000, 0.72, 4), 78.65e-3, 5e-4, "Azzaroni");
}

}  // namespace
}  // namespace mahlwerk::powder::locked_cycle_test_
