// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/match.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/random.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/spectra.hpp"

namespace mahlwerk::campaign {
namespace {

using observe::LogHistogram;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
/// Width of a bin in ln energy.
const double bin_width = math::log(2) / LogHistogram::per_octave;

/// Mean of spectra with equal weights: replicates of a mill last equally long.
DoseSpectrum mean_of(const std::vector<const DoseSpectrum*>& some) {
  DoseSpectrum mean{
      .dose = none, .shares = std::vector<double>(LogHistogram::bins, 0), .mean_energy = none};
  if (some.empty()) return mean;
  const auto count = static_cast<double>(some.size());
  mean.dose = mean.mean_energy = 0;
  for (const DoseSpectrum* one : some) {
    mean.dose += one->dose / count;
    mean.mean_energy += one->mean_energy / count;
    for (std::size_t i = 0; i < mean.shares.size(); ++i) mean.shares[i] += one->shares[i] / count;
  }
  return mean;
}

bool has_collisions(const DoseSpectrum& m) {
  return m.dose > 0 && m.mean_energy > 0;
}

/// Area between zero and a straight line from `a` to `b` over a unit interval.
double area(double a, double b) {
  if (a * b >= 0) return std::abs(a + b) / 2;
  return (a * a + b * b) / (2 * (std::abs(a) + std::abs(b)));
}

/// Ratio of `of` between b and a, with the interval from the scatter of its logarithm.
template <class Of>
observe::IntervalEstimate ratio(const MillSpectra& a, const MillSpectra& b, const Of& of) {
  const auto logarithm = [&](const MillSpectra& mill) {
    std::vector<double> values;
    for (const DoseSpectrum& m : mill.replicates) values.push_back(math::log(of(m)));
    return observe::estimate(values);
  };
  const observe::Estimate first = logarithm(a), second = logarithm(b);
  const double mean = second.mean - first.mean, half = math::hypot(first.ci95, second.ci95);
  return {math::exp(mean), math::exp(mean - half), math::exp(mean + half)};  // (opt.13)
}

/// Permutation test: share of random assignments of replicates to two groups that are at least
/// `seen` apart (opt.17).
double permutation_p_value(const MillSpectra& a, const MillSpectra& b, double seen,
                           std::uint64_t seed) {
  constexpr int deals = 999;
  constexpr double rounding = 1e-9;  // of sums in another order
  constexpr std::uint32_t stream = 0x53000000;
  if (a.replicates.size() < 2 || b.replicates.size() < 2 || !std::isfinite(seen)) return none;
  std::vector<const DoseSpectrum*> all;
  for (const MillSpectra* mill : {&a, &b})
    for (const DoseSpectrum& m : mill->replicates) all.push_back(&m);
  const auto share = static_cast<std::ptrdiff_t>(a.replicates.size());
  Random random(seed, stream);
  int as_large = 1;  // the actual assignment
  for (int deal = 0; deal < deals; ++deal) {
    for (std::size_t i = all.size(); i > 1; --i) {
      const auto k = static_cast<std::size_t>(random.uniform() * static_cast<double>(i));
      std::swap(all[i - 1], all[std::min(k, i - 1)]);
    }
    const double other = distance(mean_of({all.begin(), all.begin() + share}),
                                  mean_of({all.begin() + share, all.end()}));
    if (other >= seen * (1 - rounding)) ++as_large;
  }
  return static_cast<double>(as_large) / (deals + 1);
}

observe::Estimate mean_over(const MillSpectra& mill, double DoseSpectrum::*number) {
  std::vector<double> values;
  for (const DoseSpectrum& m : mill.replicates) values.push_back(m.*number);
  return observe::estimate(values);
}

}  // namespace

DoseSpectrum dose_spectrum(const cases::Case& mill_case, const results::Replicate& replicate,
                           bool by_powder) {
  const results::MeanSpectra spectra({&replicate});
  DoseSpectrum made{.dose = results::dissipated_power(replicate), .shares = {}, .mean_energy = 0};
  if (by_powder) made.dose /= mill_case.powder->mass;
  double power = 0, rate = 0;
  for (int bin = 0; bin < LogHistogram::bins; ++bin) {
    made.shares.push_back(spectra.power(&observe::Spectra::energy_lost, bin));
    power += made.shares.back();
    rate += spectra.rate(&observe::Spectra::energy_lost, bin);
  }
  for (double& share : made.shares) share /= power;
  made.mean_energy = power / rate;
  return made;
}

MillSpectra mill_spectra(const results::Outcome& outcome, bool by_powder) {
  MillSpectra made;
  for (const results::Replicate* r : results::averaged_replicates(outcome))
    if (DoseSpectrum one = dose_spectrum(outcome.mill_case, *r, by_powder); has_collisions(one))
      made.replicates.push_back(std::move(one));
  std::vector<const DoseSpectrum*> all;
  for (const DoseSpectrum& m : made.replicates) all.push_back(&m);
  made.mean = mean_of(all);
  return made;
}

double spectral_distance(const DoseSpectrum& a, const DoseSpectrum& b) {
  if (a.shares.size() != b.shares.size()) return none;
  double sum = 0, before = 0, behind = 0;
  for (std::size_t i = 0; i < a.shares.size(); ++i) {
    behind = before + a.shares[i] - b.shares[i];
    sum += bin_width * area(before, behind);  // (opt.14)
    before = behind;
  }
  return sum;
}

double overlap(const DoseSpectrum& a, const DoseSpectrum& b) {
  if (a.shares.size() != b.shares.size()) return none;
  double sum = 0;
  for (std::size_t i = 0; i < a.shares.size(); ++i) sum += std::min(a.shares[i], b.shares[i]);
  return sum;  // (opt.15)
}

double distance(const DoseSpectrum& a, const DoseSpectrum& b) {
  if (!has_collisions(a) || !has_collisions(b)) return none;
  return math::hypot(math::log(b.dose / a.dose), spectral_distance(a, b));  // (opt.16)
}

double half_power_energy(const DoseSpectrum& m) {
  double below = 0;
  for (std::size_t i = 0; i < m.shares.size(); ++i) {
    if (below + m.shares[i] >= 0.5) {
      const double part = (0.5 - below) / m.shares[i];
      return LogHistogram::lower(static_cast<int>(i)) * math::exp(part * bin_width);
    }
    below += m.shares[i];
  }
  return none;
}

Difference difference(const MillSpectra& a, const MillSpectra& b, std::uint64_t seed) {
  Difference found{.dose_a = mean_over(a, &DoseSpectrum::dose),
                   .dose_b = mean_over(b, &DoseSpectrum::dose),
                   .dose = ratio(a, b, [](const DoseSpectrum& m) { return m.dose; }),
                   .half_power = ratio(a, b, half_power_energy),
                   .energy_a = mean_over(a, &DoseSpectrum::mean_energy),
                   .energy_b = mean_over(b, &DoseSpectrum::mean_energy),
                   .spectral = spectral_distance(a.mean, b.mean),
                   .overlap = overlap(a.mean, b.mean),
                   .distance = distance(a.mean, b.mean),
                   .p_value = none};
  found.p_value = permutation_p_value(a, b, found.distance, seed);
  return found;
}

}  // namespace mahlwerk::campaign
