// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/match.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/campaign/search/gaussian_process.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"
#include "observed.hpp"
#include "statement.hpp"

namespace mahlwerk::campaign::match_test {
namespace {

using observe::LogHistogram;
using tests::states;
using tests::stays_below;

constexpr std::size_t one_joule = -LogHistogram::lowest_octave * LogHistogram::per_octave;
const double bin = std::numbers::ln2 / 4;

/// A spectrum with its power spread evenly over the bins `first` to `last` above one joule.
DoseSpectrum even(double dose, int first, int last) {
  DoseSpectrum m{
      .dose = dose, .shares = std::vector<double>(LogHistogram::bins, 0), .mean_energy = 1};
  for (int i = first; i <= last; ++i)
    m.shares[one_joule + static_cast<std::size_t>(i)] = 1.0 / (last - first + 1);
  return m;
}

TEST(Distance, of_spectra_is_how_far_one_must_be_moved) {
  states("moved by four bins", spectral_distance(even(1, 0, 2), even(1, 4, 6)), 4 * bin, 1e-14,
         "an octave: ln 2");
  states("moved back", spectral_distance(even(1, 4, 6), even(1, 0, 2)), 4 * bin, 1e-14, "the same");
  EXPECT_EQ(spectral_distance(even(1, 0, 2), even(3, 0, 2)), 0);
  // One bin against the three bins about it: uniform distributions of width w and 3 w. The
  // quantiles differ by 2 w |u - 1/2|, with the mean w/2.
  states("made wider", spectral_distance(even(1, 1, 1), even(1, 0, 2)), bin / 2, 1e-14,
         "mean of the quantiles' distance");
}

TEST(Distance, of_doses_is_their_logarithm) {
  states("dose e times as large", distance(even(1, 0, 2), even(std::numbers::e, 0, 2)), 1, 1e-14,
         "ln e");
  states("both", distance(even(1, 0, 2), even(std::exp(3 * bin), 4, 6)), 5 * bin, 1e-13, "3, 4, 5");
  EXPECT_TRUE(std::isnan(distance(even(1, 0, 2), even(0, 0, 2))));
}

TEST(Overlap, is_the_power_at_the_same_energies) {
  EXPECT_DOUBLE_EQ(overlap(even(1, 0, 3), even(1, 0, 3)), 1);
  EXPECT_DOUBLE_EQ(overlap(even(1, 0, 3), even(1, 2, 5)), 0.5);
  EXPECT_EQ(overlap(even(1, 0, 3), even(1, 4, 5)), 0);
}

TEST(HalfPowerEnergy, lies_in_the_middle_of_an_even_spectrum) {
  states("even over an octave", half_power_energy(even(1, 0, 3)), std::sqrt(2.0), 1e-14,
         "half an octave above 1 J");
}

/// Replicates with doses that scatter by the fraction `scatter` of their mean.
MillSpectra some(double dose, int count, double scatter, std::uint32_t stream) {
  Random random(4, stream);
  MillSpectra made;
  for (int i = 0; i < count; ++i)
    made.replicates.push_back(even(dose * std::exp(scatter * standard_normal(random)), 0, 3));
  made.mean = even(0, 0, 3);
  for (const DoseSpectrum& m : made.replicates) made.mean.dose += m.dose / count;
  return made;
}

TEST(Difference, of_the_same_mill_is_within_its_scatter_in_nineteen_of_twenty) {
  constexpr int times = 200;
  int within = 0, held = 0;
  for (std::uint32_t t = 0; t < times; ++t) {
    const Difference d = difference(some(7, 5, 0.1, 2 * t), some(7, 5, 0.1, 2 * t + 1), t);
    within += d.within_scatter();
    held += d.dose.low <= 1 && 1 <= d.dose.high;
  }
  const double tolerance = 3.3 * std::sqrt(times * 0.95 * 0.05);
  states("within, of 200", within, 0.95 * times, tolerance, "binomial");
  // Two intervals combined in quadrature hold somewhat more often than 95 %.
  EXPECT_GE(held, 0.95 * times - tolerance);
}

TEST(Difference, is_seen_where_it_is_larger_than_the_scatter) {
  const Difference d = difference(some(7, 5, 0.02, 1), some(14, 5, 0.02, 2));
  states("dose", d.dose.value, 2, 3.3 * 2 * 0.02 * std::sqrt(0.4), "3.3 standard errors");
  EXPECT_FALSE(d.within_scatter());
  EXPECT_LT(d.dose.high, 2.2);
  EXPECT_GT(d.dose.low, 1.8);
}

TEST(Difference, is_not_said_to_be_scatter_without_replicates) {
  const Difference d = difference(some(7, 1, 0.02, 1), some(7, 1, 0.02, 2));
  EXPECT_TRUE(std::isnan(d.p_value));
  EXPECT_FALSE(d.within_scatter());
  EXPECT_TRUE(std::isnan(d.dose.low));
  EXPECT_TRUE(std::isnan(difference(some(7, 5, 0.02, 1), {}).distance));
}

results::Outcome shaken_mill(double frequency, std::uint64_t seed) {
  cases::Case c = shaken("event", 5);
  std::get<kinematics::Vibration>(*c.mill.motion).frequency = frequency;
  c.seed = seed;
  c.run.time = 1;
  c.run.replicates = 6;
  return run(c);
}

TEST(MillMark, is_what_the_summary_says) {
  const results::Outcome outcome = shaken_mill(20, 1);
  const MillSpectra spectra = mill_spectra(outcome, false);
  ASSERT_EQ(spectra.replicates.size(), 6U);
  for (const results::Quantity& q : results::summarise(outcome).quantities) {
    if (q.name == "dissipated_power")
      states("power", spectra.mean.dose, q.value, 1e-12 * q.value, "summary.json");
    if (q.name == "energy_lost_mean")
      states("energy", spectra.mean.mean_energy, q.value, 1e-9 * q.value, "summary.json");
  }
  double all = 0;
  for (const double share : spectra.mean.shares) all += share;
  states("shares", all, 1, 1e-12, "all of the power");
}

TEST(MillMark, of_the_same_mill_from_other_starts_differs_by_scatter) {
  constexpr int times = 40;
  int within = 0, held = 0;
  for (std::uint64_t t = 0; t < times; ++t) {
    const Difference d = difference(mill_spectra(shaken_mill(20, 2 * t), false),
                                    mill_spectra(shaken_mill(20, 2 * t + 1), false), t);
    within += d.within_scatter();
    held += d.dose.low <= 1 && 1 <= d.dose.high;
    EXPECT_GT(d.overlap, 0.8);
  }
  const double least = 0.95 * times - 3.3 * std::sqrt(times * 0.95 * 0.05);
  std::printf("    within scatter %d, ratio of doses holds 1 in %d of %d\n", within, held, times);
  EXPECT_GE(within, least);
  EXPECT_GE(held, least);
}

TEST(MillMark, of_a_faster_mill_has_more_dose_and_harder_impacts) {
  const Difference d =
      difference(mill_spectra(shaken_mill(20, 1), false), mill_spectra(shaken_mill(40, 2), false));
  EXPECT_FALSE(d.within_scatter());
  EXPECT_GT(d.dose.low, 1);
  EXPECT_GT(d.half_power.low, 1);
  EXPECT_GT(d.energy_b.mean - d.energy_b.ci95, d.energy_a.mean + d.energy_a.ci95);
  EXPECT_LT(d.overlap, 0.8);
}

TEST(MillMark, without_collisions_is_nothing) {
  cases::Case c = shaken("event", 1);
  c.mill.motion = kinematics::Still{};
  c.run.time = 1e-6;
  c.run.settle = 0;
  const MillSpectra spectra = mill_spectra(run(c), false);
  EXPECT_TRUE(spectra.replicates.empty());
  EXPECT_TRUE(std::isnan(spectra.mean.dose));
}

}  // namespace
}  // namespace mahlwerk::campaign::match_test
