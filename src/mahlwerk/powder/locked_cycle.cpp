// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/locked_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::powder {
namespace {

/// Share of class `i` that passes the screen: uniform in the logarithm of the size.
double passing(const SizeGrid& grid, int i, double screen) {
  const double low = grid.lower(i), high = grid.upper(i);
  if (screen >= high) return 1;
  return screen <= low ? 0 : math::log(screen / low) / math::log(high / low);
}

double sum(const std::vector<double>& shares) {
  return std::accumulate(shares.begin(), shares.end(), 0.0);
}

/// A charge split by the screen; shares of the charge.
struct Screened {
  std::vector<double> through, on;
};
Screened screen(const SizeGrid& grid, const std::vector<double>& shares, double opening) {
  Screened found{shares, shares};
  for (std::size_t i = 0; i < shares.size(); ++i) {
    found.through[i] = passing(grid, static_cast<int>(i), opening) * shares[i];
    found.on[i] = shares[i] - found.through[i];
  }
  return found;
}

/// Size that 80 % of the product is finer than. The class that the screen cuts ends there.
double p80_of(const SizeGrid& grid, std::vector<double> product, double screen) {
  const double all = sum(product);
  for (double& share : product) share /= all;
  return std::min(quantile(grid, product, 0.8), screen);
}

bool agree(const std::vector<Cycle>& cycles, double within) {
  if (cycles.size() < 4) return false;
  const auto last = std::span(cycles).last(3);
  const auto [least, most] = std::ranges::minmax(last, {}, &Cycle::per_turn);
  return most.per_turn - least.per_turn <= within * most.per_turn;
}

}  // namespace

LockedCycleTest locked_cycle_test(const SizeGrid& grid, const std::vector<double>& feed,
                                  const LockedCycleRules& rules, const GrindTurns& grind) {
  LockedCycleTest test;
  test.f80 = quantile(grid, feed, 0.8);
  const double ideal = 1 / (1 + rules.circulating_load);
  const double fine = sum(screen(grid, feed, rules.closing_size).through);
  if (fine >= ideal)
    throw std::invalid_argument("the feed holds as much undersize as the product should have");
  std::vector<double> charge = feed;
  double turns = rules.first_turns, undersize_fed = fine, fed = 1;
  for (int k = 0; k < rules.most_cycles && !test.steady; ++k) {
    const std::vector<double> ground = grind(charge, turns);
    const Screened parts = screen(grid, ground, rules.closing_size);
    Cycle cycle{.turns = turns, .fed = fed, .undersize_fed = undersize_fed};
    cycle.product = sum(parts.through);
    cycle.per_turn = (cycle.product - undersize_fed) / turns;
    cycle.circulating_load = (1 - cycle.product) / cycle.product;
    if (!(cycle.per_turn > 0))
      throw std::invalid_argument("grinding makes no undersize: no hit breaks these grains");
    cycle.p80 = p80_of(grid, parts.through, rules.closing_size);
    test.mass_error = std::max(test.mass_error, std::abs(sum(parts.on) + cycle.product - 1));
    test.cycles.push_back(cycle);
    test.steady = agree(test.cycles, rules.agreement);
    // Fresh feed replaces the product.
    fed = cycle.product, undersize_fed = fine * fed;
    for (std::size_t i = 0; i < charge.size(); ++i) charge[i] = parts.on[i] + fed * feed[i];
    turns = std::max(1.0, (ideal - undersize_fed) / cycle.per_turn);
  }
  const auto last = std::span(test.cycles).last(std::min<std::size_t>(3, test.cycles.size()));
  for (const Cycle& cycle : last) {
    test.per_turn += cycle.per_turn / static_cast<double>(last.size());
    test.p80 += cycle.p80 / static_cast<double>(last.size());
  }
  return test;
}

double bond_work_index(double closing_size, double grams_per_turn, double f80, double p80) {
  constexpr double micron = 1e6, short_ton = 0.90718474;  // t
  const double apart = 10 / std::sqrt(micron * p80) - 10 / std::sqrt(micron * f80);
  return 44.5 / (math::pow(micron * closing_size, 0.23) * math::pow(grams_per_turn, 0.82) * apart) /
         short_ton;
}

double bond_ball_size(double f80, double work_index, double density, double speed,
                      double diameter) {
  constexpr double wet_overflow = 350, short_ton = 0.90718474, in_ft = 1 / 0.3048;
  return 0.0254 * std::sqrt(1e6 * f80 / wet_overflow) *
         math::cbrt(density / 1000 * work_index * short_ton /
                    (100 * speed * std::sqrt(in_ft * diameter)));
}

double azzaroni_ball_size(double f80, double work_index, double density, double speed,
                          double diameter) {
  const double rpm = speed * 42.3 / std::sqrt(diameter);
  return 1e-3 * 4.5 * math::pow(1e6 * f80, 0.263) * math::pow(density / 1000 * work_index, 0.4) /
         math::pow(rpm * diameter, 0.25);
}

}  // namespace mahlwerk::powder
