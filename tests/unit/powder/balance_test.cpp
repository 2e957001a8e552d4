// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "mahlwerk/powder/population_balance.hpp"
#include "mahlwerk/powder/size_evolution.hpp"
#include "powder_models.hpp"
#include "statement.hpp"

namespace mahlwerk::powder::balance_test {
namespace {

using tests::states;
using tests::stays_below;

const Nip nip{0.004, 110e9};

/// A gram of quartz-like powder, stressed by ten kinds of hits.
Process process(AnyBreakage breakage = VogelPeukert{2, 0.05},
                AnyFragments fragments = BinaryFragments{}, AnyCapture capture = FixedMass{2e-6}) {
  Process p{.capture = capture, .breakage = breakage, .fragments = fragments};
  p.density = 2650;
  p.mass = 1e-3;
  return p;
}
StressSpectrum spectrum() {
  StressSpectrum s{{nip}, {}};
  for (int k = 0; k < 10; ++k)
    s.stresses.push_back({0, 1e-5 * std::exp2(k), 300 / std::exp2(0.7 * k)});
  return s;
}
double sum(const std::vector<double>& all) {
  return std::accumulate(all.begin(), all.end(), 0.0);
}

/// Reid's closed-form solution for rates that all differ, in long double.
std::vector<long double> reid(const RateMatrix& rates, const std::vector<double>& start,
                              double time) {
  const auto n = static_cast<std::size_t>(rates.size);
  std::vector<long double> leaves(n), now(n);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = j + 1; i < n; ++i)
      leaves[j] += rates.at(static_cast<int>(i), static_cast<int>(j));
  std::vector<std::vector<long double>> a(n, std::vector<long double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    long double rest = start[i];
    for (std::size_t j = 0; j < i; ++j) {
      long double in = 0;
      for (std::size_t k = j; k < i; ++k)
        in += rates.at(static_cast<int>(i), static_cast<int>(k)) * a[k][j];
      a[i][j] = in / (leaves[i] - leaves[j]);
      rest -= a[i][j];
    }
    a[i][i] = rest;
    for (std::size_t j = 0; j <= i; ++j) now[i] += a[i][j] * std::exp(-leaves[j] * time);
  }
  return now;
}

TEST(Balance, step_is_reids_closed_form) {
  RateMatrix rates(6);
  std::vector<double> start(6, 0.0);
  start[0] = 1;
  for (int j = 0; j < 6; ++j)
    for (int i = j + 1; i < 6; ++i) rates.at(i, j) = (7.0 - j) / (1 + i - j + 0.3 * i);
  for (const double time : {1e-3, 0.1, 1.0, 5.0}) {
    const std::vector<double> found = product(transition_matrix(rates, time), start);
    const std::vector<long double> expected = reid(rates, start, time);
    for (std::size_t i = 0; i < 6; ++i)
      states("state " + std::to_string(i) + " after " + std::to_string(time) + " s", found[i],
             static_cast<double>(expected[i]), 1e-14, "Reid 1965; a few roundings");
  }
}

TEST(Balance, two_short_steps_are_one_long) {
  RateMatrix rates(40);
  for (int j = 0; j < 40; ++j)
    for (int i = j + 1; i < 40; ++i) rates.at(i, j) = std::exp2(-j) * (1 + (i * 7 + j) % 5);
  const Matrix half = transition_matrix(rates, 50), whole = transition_matrix(rates, 100),
               twice = product(half, half);
  double worst = 0;
  for (std::size_t k = 0; k < whole.values.size(); ++k)
    worst = tests::max_or_nan(worst, std::abs(whole.values[k] - twice.values[k]));
  stays_below("largest difference", worst, 1e-13, "exp(A 2t) = exp(A t)^2; doublings of roundings");
}

TEST(Balance, first_order_grinding_is_gaudin_and_meloys) {
  // S = k x while hits rarely break grains, and B = x/y: the mass coarser than x decays at the rate
  // S(x).
  constexpr double f = 1e-12;
  Process p = process(VogelPeukert{f, 0}, AustinFragments{1, 1, 1});
  const StressSpectrum hits{{nip}, {{0, 1e-3, 100}}};
  const SizeGrid grid(1e-3, 1e-3, 1e-6, 6);
  Feed feed{Feed::Law::rosin_rammler, 0.4e-3, 1.1};
  const double energy = 1e-3 / 2e-6, rate = 100 * 2e-6 / 1e-3;  // [J/kg], [1/s] of a grain
  const double unit = f * energy * rate;                        // S over x [1/(m s)]
  const double time = 3 / (unit * 0.4e-3);
  PopulationBalance balance(p, hits, grid, grid.shares(feed));
  balance.advance(time);
  const std::vector<double> before = grid.shares(feed), after = balance.shares();
  double coarser_before = 0, coarser_after = 0;
  for (int i = 0; i + 1 < grid.classes(); ++i) {
    coarser_before += before[static_cast<std::size_t>(i)];
    coarser_after += after[static_cast<std::size_t>(i)];
    if (i % 8 != 0) continue;
    const double expected = coarser_before * std::exp(-unit * grid.lower(i) * time);
    states("coarser than " + std::to_string(1e6 * grid.lower(i)) + " um", coarser_after, expected,
           1e-8, "R(x, 0) exp(-S(x) t); chance 1 - exp(-z), z < 1e-9, is z to 1e-9 of it");
  }
}

TEST(Balance, random_binary_breakage_is_ziff_and_mcgradys) {
  // Rate proportional to volume, fragments uniform in volume, one initial size: the mass share of
  // grains of less than v is 1 - exp(-t v) (1 + t (1 - v) + ... ) as below, with v relative to the
  // initial volume.
  const auto finer = [](double v, double t) {
    // Integral of u n(u) from 0 to v with n = exp(-t u) (2 t + t^2 (1 - u)).
    const auto antiderivative = [t](double u) {
      const double e = std::exp(-t * u);
      // u (2 t + t^2) e: -(2 + t)(u + 1/t) e; -t^2 u^2 e: (t u^2 + 2 u + 2/t) e
      return e * (-(2 + t) * (u + 1 / t) + t * u * u + 2 * u + 2 / t);
    };
    return antiderivative(v) - antiderivative(0);
  };
  const double t = 4;
  std::vector<double> errors;
  for (const int per_octave : {6, 12, 24, 48}) {
    // The initial size is on an edge: v = 1 is the upper edge of the first class.
    const SizeGrid grid(std::exp2(-0.5 / per_octave), std::exp2(-0.5 / per_octave), 0.05,
                        per_octave);
    RateMatrix rates(grid.classes());
    const BinaryFragments binary;
    for (int j = 0; j + 1 < grid.classes(); ++j)
      for (int i = j + 1; i < grid.classes(); ++i) {
        const double y = grid.middle(j);
        const double low =
            i + 1 < grid.classes() ? binary.breakage_function(grid.lower(i) / y, y, 0) : 0;
        rates.at(i, j) =
            y * y * y * (binary.breakage_function(std::min(1.0, grid.upper(i) / y), y, 0) - low);
      }
    // Grains of exactly v = 1 are kept apart from the classes and decay by themselves.
    std::vector<double> state(static_cast<std::size_t>(grid.classes()), 0.0);
    constexpr int slices =
        4000;  // Duhamel's integral over the time at which initial grains broke, midpoint
    const Matrix slice = transition_matrix(rates, t / slices),
                 half = transition_matrix(rates, 0.5 * t / slices);
    for (int s = 0; s < slices; ++s) {
      const double broke = std::exp(-t * s / slices) * -std::expm1(-t / slices);
      std::vector<double> born(state.size());
      for (int i = 0; i < grid.classes(); ++i) {
        const double low = i + 1 < grid.classes() ? std::pow(grid.lower(i), 6) : 0;
        born[static_cast<std::size_t>(i)] = broke * (std::pow(grid.upper(i), 6) - low);
      }
      state = product(slice, state);
      const std::vector<double> grown = product(half, born);
      for (std::size_t i = 0; i < state.size(); ++i) state[i] += grown[i];
    }
    double worst = 0, below = 0;
    for (int i = grid.classes() - 1; i > 0; --i) {
      below += state[static_cast<std::size_t>(i)];
      const double v = std::pow(grid.upper(i), 3);
      worst = tests::max_or_nan(worst, std::abs(below - finer(v, t)));
    }
    errors.push_back(worst);
    std::printf("    %d classes an octave: off by %.2g\n", per_octave, worst);
  }
  // A class is represented by its middle, which is of second order. Halving its width three times
  // leaves a sixty-fourth of the error.
  for (std::size_t i = 1; i < errors.size(); ++i)
    stays_below("error over that of classes twice as wide", errors[i] / errors[i - 1], 0.3,
                "second order: a quarter");
  stays_below("largest error at 48 an octave", errors.back(), errors.front() / 40,
              "a sixty-fourth");
}

TEST(Balance, mass_is_kept_and_sizes_never_grow_under_every_model) {
  const Feed feed{Feed::Law::lognormal, 0.5e-3, 1.5};
  for (const AnyBreakage& breakage : tests::every_breakage())
    for (const AnyFragments& fragments : tests::every_fragments())
      for (const AnyCapture& capture : tests::every_capture()) {
        const bool many = std::holds_alternative<Tavares>(breakage);  // damage states
        const SizeGrid grid(0.5e-3, feed.largest(), many ? 100e-6 : 4e-6, 3);
        PopulationBalance balance(process(breakage, fragments, capture), spectrum(), grid,
                                  grid.shares(feed));
        std::vector<double> last = balance.shares();
        for (const double time : {1.0, 60.0, 72000.0}) {
          balance.advance(time);
          const std::vector<double> now = balance.shares();
          EXPECT_NEAR(sum(now), 1, 1e-12);
          double coarser_before = 0, coarser_now = 0;
          for (std::size_t i = 0; i < now.size(); ++i) {
            EXPECT_GE(now[i], 0);
            coarser_before += last[i];
            coarser_now += now[i];
            EXPECT_LE(coarser_now, coarser_before + 1e-13);
          }
          last = now;
        }
      }
}

TEST(Balance, welding_alone_doubles_volumes_and_keeps_mass) {
  Process p = process(Threshold{1e12, 1e-3, 0}, Halves{});  // nothing breaks
  p.welding = 0.1;
  const StressSpectrum hits{{nip}, {{0, 1e-3, 100}}};
  const SizeGrid grid(10e-6, 1e-3, 10e-6, 6);
  PopulationBalance balance(p, hits, grid, grid.shares({Feed::Law::equal, 10e-6}));
  const double rate = 0.1 * 100 * 2e-6 / 1e-3, time = 2 / rate;  // two welds a grain, by Poisson
  balance.advance(time);
  const std::vector<double> shares = balance.shares();
  double expected = std::exp(-2.0);
  for (int n = 0; n < 8; ++n) {
    states("welded " + std::to_string(n) + " times",
           shares[static_cast<std::size_t>(grid.class_of(10e-6 * std::exp2(n / 3.0)))], expected,
           1e-13, "Poisson's law with mean 2");
    expected *= 2.0 / (n + 1);
  }
  states("mass", sum(shares), 1, 1e-13, "kept");
}

TEST(Balance, stuck_grains_slow_grinding_down_by_their_share) {
  const SizeGrid grid(1e-3, 1e-3, 10e-6, 6);
  const Feed feed{Feed::Law::equal, 1e-3};
  Process free = process(), stuck = process();
  stuck.sticking = 0.25;
  PopulationBalance one(free, spectrum(), grid, grid.shares(feed)),
      other(stuck, spectrum(), grid, grid.shares(feed));
  one.advance(300);
  other.advance(400);
  for (std::size_t i = 0; i < one.shares().size(); ++i)
    EXPECT_NEAR(one.shares()[i], other.shares()[i], 1e-13);
}

TEST(Balance, mixed_bed_is_of_second_order_in_its_steps) {
  // Compared with steps a hundred times shorter than the automatic ones.
  Process p = process(VogelPeukert{2, 0.05}, BinaryFragments{}, Barrios{300});
  p.bed = Bed::mixed;
  const Feed feed{Feed::Law::equal, 1e-3};
  const SizeGrid grid(1e-3, 1e-3, 20e-6, 6);
  PopulationBalance coarse(p, spectrum(), grid, grid.shares(feed)),
      fine(p, spectrum(), grid, grid.shares(feed));
  coarse.advance(600);
  for (int i = 0; i < 6000; ++i) fine.advance(0.1);
  double worst = 0;
  for (std::size_t i = 0; i < coarse.shares().size(); ++i)
    worst = tests::max_or_nan(worst, std::abs(coarse.shares()[i] - fine.shares()[i]));
  stays_below("largest difference of a share", worst, 0.05 * 0.05 / 24,
              "the midpoint rule's h^2/24 with steps of 5 % in size");
}

}  // namespace
}  // namespace mahlwerk::powder::balance_test
