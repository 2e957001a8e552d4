// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mahlwerk/powder/sizes.hpp"

// Bond's grindability test: a mill in closed circuit with a screen, in locked cycles
// (docs/theory/bond.md).
namespace mahlwerk::powder {

/// Rules of the test.
struct LockedCycleRules {
  double closing_size = 150e-6;   ///< [m] opening of the screen
  double circulating_load = 2.5;  ///< [1] mass on the screen over mass through it
  double first_turns = 100;       ///< turns of the mill in the first cycle
  int most_cycles = 30;
  double agreement = 0.03;  ///< [1] spread of the last three cycles when the test ends
};

/// One cycle; masses over that of the charge.
struct Cycle {
  double turns = 0;
  double fed = 0;               ///< fresh feed, with its own undersize
  double undersize_fed = 0;     ///< undersize in the fresh feed
  double product = 0;           ///< undersize after grinding, screened off
  double per_turn = 0;          ///< net undersize made per turn
  double p80 = 0;               ///< [m] size that 80 % of the product is finer than
  double circulating_load = 0;  ///< [1] of this cycle
};

/// Result of the test.
struct LockedCycleTest {
  std::vector<Cycle> cycles;
  bool steady = false;      ///< the last three cycles agree
  double per_turn = 0;      ///< mean of the last three cycles, over the mass of the charge
  double f80 = 0, p80 = 0;  ///< [m] of the feed; of the product, mean of the last three
  double mass_error = 0;    ///< [1] largest error of the mass balance of a cycle
};

/// Shares of the classes after so many turns of the mill.
using GrindTurns =
    std::function<std::vector<double>(const std::vector<double>& shares, double turns)>;

/// Runs the test on a charge of constant mass. `feed`: shares of the classes of `grid` in the fresh
/// feed. Throws std::invalid_argument with a sentence if the feed passes the screen by more than
/// the ideal product (bnd.2), or if grinding makes no undersize.
LockedCycleTest locked_cycle_test(const SizeGrid& grid, const std::vector<double>& feed,
                                  const LockedCycleRules& rules, const GrindTurns& grind);

/// [kWh/t] Bond's work index of ball mills (bnd.3); sizes in m, `grams_per_turn` in g.
double bond_work_index(double closing_size, double grams_per_turn, double f80, double p80);

/// [m] Largest ball for a feed by Bond (bnd.4) and by Azzaroni (bnd.5): `f80` [m], `work_index`
/// [kWh/t], `density` of the ore [kg/m3], `speed` as a share of the critical one, `diameter` of the
/// mill [m]; Bond for a wet overflow mill.
double bond_ball_size(double f80, double work_index, double density, double speed, double diameter);
double azzaroni_ball_size(double f80, double work_index, double density, double speed,
                          double diameter);

}  // namespace mahlwerk::powder
