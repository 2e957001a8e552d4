// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "mahlwerk/powder/population_balance.hpp"
#include "powder_models.hpp"
#include "statement.hpp"

namespace mahlwerk::powder::sample_test {
namespace {

using tests::stays_below;

const Nip nip{0.004, 110e9};
constexpr int grains = 2000, samples = 200;
constexpr double duration = 200;  // [s]

/// Energies on rows of the sample's tables, so that both methods have the same captures.
StressSpectrum spectrum() {
  return {{nip}, {{0, std::exp2(-12.0), 40}, {0, std::exp2(-10.0), 20}, {0, std::exp2(-8.5), 5}}};
}
Process process(AnyBreakage breakage, AnyFragments fragments) {
  Process p{.capture = FixedMass{2e-6}, .breakage = breakage, .fragments = fragments};
  p.density = 2650;
  p.mass = 1e-3;
  return p;
}

/// Share of each class after `duration`: the mean of samples and its standard error.
struct Mean {
  std::vector<double> share, error;
};
Mean many(const Process& p, const SizeGrid& grid, const Feed& feed) {
  const StressSpectrum s = spectrum();
  const auto n = static_cast<std::size_t>(grid.classes());
  std::vector<double> sum(n), squares(n);
  for (int k = 0; k < samples; ++k) {
    Sample sample(p, s.nips, grid, feed, grains, static_cast<std::uint64_t>(k));
    for (int second = 0; second < static_cast<int>(duration); ++second)
      for (const Stress& hit : s.stresses)
        for (int i = 0; i < static_cast<int>(hit.rate); ++i)
          sample.hit(sample.kind(hit.nip, hit.energy), hit.energy);
    const std::vector<double> shares = sample.shares();
    for (std::size_t i = 0; i < n; ++i) {
      sum[i] += shares[i];
      squares[i] += shares[i] * shares[i];
    }
  }
  Mean mean;
  for (std::size_t i = 0; i < n; ++i) {
    const double m = sum[i] / samples;
    mean.share.push_back(m);
    mean.error.push_back(std::sqrt(std::max(0.0, squares[i] / samples - m * m) / (samples - 1)));
  }
  return mean;
}

std::vector<double> expected(const Process& p, const SizeGrid& grid, const Feed& feed) {
  PopulationBalance balance(p, spectrum(), grid, grid.shares(feed));
  balance.advance(duration);
  return balance.shares();
}

/// Deviation in standard errors [1]: root mean square over the classes that contain some mass.
/// `known` is the known error of the balance.
double apart(const Mean& found, const std::vector<double>& expected,
             const std::vector<double>& known) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] < 1e-4) continue;
    // Hits one by one instead of all at once: an error of the share of a class that one collision
    // hits.
    const double error = std::hypot(found.error[i], known[i], 2e-3 * expected[i]);
    sum += std::pow((found.share[i] - expected[i]) / error, 2);
    ++count;
  }
  std::printf("    %d classes compared\n", count);
  EXPECT_GT(count, 5);
  return std::sqrt(sum / count);
}

TEST(Sample, mean_of_many_is_the_balance_under_every_model_of_breakage) {
  // Halves of equal grains are in the middles of classes, where the balance has no error of its
  // own.
  const SizeGrid grid(1e-3, 1e-3, 30e-6, 6);
  const Feed feed{Feed::Law::equal, 1e-3};
  for (const AnyBreakage& breakage : tests::every_breakage()) {
    if (std::holds_alternative<Tavares>(breakage)) continue;  // needs levels: tested below
    const Process p = process(breakage, Halves{});
    const std::string name =
        std::visit([](const auto& m) { return std::string(m.name); }, breakage);
    const std::vector<double> none(static_cast<std::size_t>(grid.classes()), 0.0);
    stays_below(name + ": standard errors apart",
                apart(many(p, grid, feed), expected(p, grid, feed), none), 3,
                "issue: within 3 sigma");
  }
}

TEST(Sample, mean_of_many_is_the_balance_under_every_kind_of_fragments) {
  // A class is represented by its middle. The error is the change if the width of classes is
  // halved.
  const Feed feed{Feed::Law::lognormal, 0.5e-3, 1.4};
  for (const AnyFragments& fragments : tests::every_fragments()) {
    if (std::holds_alternative<Halves>(fragments)) continue;
    const Process p = process(VogelPeukert{2, 0.05}, fragments);
    const SizeGrid grid(0.5e-3, feed.largest(), 30e-6, 6),
        finer_grid(grid.middle(0) * std::exp2(1.0 / 24), grid.middle(0) * std::exp2(1.0 / 24),
                   grid.middle(grid.classes() - 1) * std::exp2(-1.0 / 24), 12);
    ASSERT_EQ(finer_grid.classes(), 2 * grid.classes());
    const std::vector<double> coarse = expected(p, grid, feed),
                              fine = expected(p, finer_grid, feed);
    std::vector<double> joined, known;
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      joined.push_back(fine[2 * i] + fine[2 * i + 1]);
      known.push_back(std::abs(joined[i] - coarse[i]));
    }
    const std::string name =
        std::visit([](const auto& m) { return std::string(m.name); }, fragments);
    stays_below(name + ": standard errors apart", apart(many(p, grid, feed), joined, known), 3,
                "issue: within 3 sigma, and what twice the classes changes");
  }
}

TEST(Sample, mean_of_many_is_the_balance_where_grains_remember_damage) {
  const SizeGrid grid(1e-3, 1e-3, 60e-6, 3);
  const Feed feed{Feed::Law::equal, 1e-3};
  const Tavares model{43.4, 3.48e-3, 1.61, 0.5, 4, 5, 0.6, 0.03};
  const Process p = process(model, Halves{});
  const auto by = [&](int count) {
    const StrengthLevels some = strength_levels(model, count);
    std::vector<double> states;
    for (const double share : grid.shares(feed))
      for (const double fresh : some.fresh) states.push_back(share * fresh);
    states = product(transition_matrix(rate_matrix(p, spectrum(), grid, some,
                                                   capture_table(p, spectrum(), grid, 0)),
                                       duration),
                     states);
    std::vector<double> shares(static_cast<std::size_t>(grid.classes()));
    for (std::size_t i = 0; i < states.size(); ++i) shares[i / some.fresh.size()] += states[i];
    return shares;
  };
  // Strength has discrete levels, and there are only three energies: the known error is the change
  // when the number of levels doubles, for two doublings.
  const std::vector<double> coarse = by(20), middling = by(40), fine = by(80);
  std::vector<double> known;
  for (std::size_t i = 0; i < fine.size(); ++i)
    known.push_back(std::max(std::abs(fine[i] - middling[i]), std::abs(middling[i] - coarse[i])));
  stays_below("share of a class, changed by more levels", std::ranges::max(known), 0.02,
              "known to a fiftieth, which is what comparing with a sample can tell");
  stays_below("tavares: standard errors apart", apart(many(p, grid, feed), fine, known), 3,
              "issue: within 3 sigma, and what twice the levels changes");
}

TEST(Sample, welding_and_sticking_are_those_of_the_balance) {
  Process p = process(Threshold{400, 1e-3, 0.5}, Halves{});
  p.welding = 0.05;
  p.welding_energy = 100;
  p.sticking = 0.3;
  p.sticking_size = 0.3e-3;
  const SizeGrid grid(1e-3, 4e-3, 30e-6, 6);
  const Feed feed{Feed::Law::equal, 1e-3};
  const std::vector<double> none(static_cast<std::size_t>(grid.classes()), 0.0);
  stays_below("standard errors apart", apart(many(p, grid, feed), expected(p, grid, feed), none), 3,
              "issue: within 3 sigma");
}

TEST(Sample, sizes_never_grow_without_welding_and_mass_is_kept) {
  const Feed feed{Feed::Law::lognormal, 0.5e-3, 1.5};
  for (const AnyBreakage& breakage : tests::every_breakage())
    for (const AnyFragments& fragments : tests::every_fragments()) {
      const SizeGrid grid(0.5e-3, feed.largest(), 10e-6, 6);
      Sample sample(process(breakage, fragments), {nip}, grid, feed, 500, 3);
      double coarsest = std::ranges::max(sample.sizes()), mean = 0;
      for (const double x : sample.sizes()) mean += x;
      for (int round = 0; round < 20; ++round) {
        for (int i = 0; i < 200; ++i) sample.hit(sample.kind(0, 3e-3), 3e-3);
        const std::vector<double> sizes = sample.sizes();
        double now = 0;
        for (const double x : sizes) now += x;
        EXPECT_EQ(std::ssize(sizes), 500);
        EXPECT_LE(std::ranges::max(sizes), coarsest);
        EXPECT_LE(now, mean);
        coarsest = std::ranges::max(sizes);
        mean = now;
      }
      EXPECT_GT(sample.grain_hits(), 1000);
    }
}

}  // namespace
}  // namespace mahlwerk::powder::sample_test
