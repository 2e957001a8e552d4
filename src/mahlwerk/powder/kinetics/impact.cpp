// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/kinetics/impact.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::powder {

double ImpactKinetics::share_of_hit(double energy, bool second) const {
  const double share = second ? second_share : processed_share;
  const double beyond = energy - (second ? second_threshold : threshold_energy);
  if (beyond < 0) return 0;
  if (energy_exponent == 0) return share;
  return std::min(1.0, share * math::pow(beyond / reference_energy, energy_exponent));
}

ImpactRates ImpactKinetics::rates(const MillingConditions& mill) const {
  ImpactRates all;
  // A hit that processes all powder leaves a rounding error, not an infinite rate.
  constexpr double whole = 1 - 0x1p-53;
  const auto rate_of = [=](double fraction) { return -math::log1p(-std::min(fraction, whole)); };
  for (const PowderHits& hit : mill.hits) {
    const double captured = std::min(1.0, hit.mass / mill.powder_mass);  // (rea.2)
    const double one = captured * share_of_hit(hit.energy);
    const double two = has_second() ? captured * share_of_hit(hit.energy, true) : 0;
    if (!(one + two > 0)) continue;
    if (scheme == Scheme::parallel) {  // (rea.5)
      const double both = rate_of(std::min(one + two, captured)) / (one + two);
      all.first += hit.rate * both * one;
      all.second += hit.rate * both * two;
    } else {  // (rea.3)
      all.first += hit.rate * rate_of(one);
      all.second += hit.rate * rate_of(two);
    }
    all.hits += hit.rate;
    all.power += hit.rate * hit.energy;
    const double once =
        scheme == Scheme::parallel ? std::min(one + two, captured) : std::max(one, two);
    all.mass += hit.rate * once * mill.powder_mass;
  }
  return all;
}

double share_processed(double mean, std::int64_t needed) {
  if (needed == 1) return -math::expm1(-mean);
  if (!(mean > 0)) return 0;
  // The Poisson probability of `needed` or of one less, factor by factor so that none overflows,
  // then the terms on the side where they fall.
  const auto n = static_cast<double>(needed);
  const double decay = math::exp(-mean / n);
  double term = 1;
  for (std::int64_t i = 1; i <= needed; ++i) term *= mean / static_cast<double>(i) * decay;
  double sum = 0;
  constexpr double negligible = 1e-17;
  if (mean < n) {
    for (double i = n; term > negligible * sum; ++i, term *= mean / i) sum += term;
    return sum;
  }
  term *= n / mean;
  for (double i = n - 1; i >= 0 && term > negligible * sum; term *= i / mean, --i) sum += term;
  return 1 - sum;
}

namespace {

/// [1] Intermediate of a sequence with rates times time `a` and `b` (rea.5):
/// a (exp(-b) - exp(-a)) / (a - b), without cancellation.
double intermediate(double a, double b) {
  const double apart = std::abs(a - b);
  return a * math::exp(-std::min(a, b)) * (apart > 0 ? -math::expm1(-apart) / apart : 1);
}

}  // namespace

ReactionShares ImpactKinetics::shares(const MillingConditions& mill, double time) const {
  const ImpactRates rate = rates(mill);
  const double first = rate.first * time, second = rate.second * time;
  if (scheme == Scheme::simple)
    return ReactionShares::of_one_product(share_processed(first, hits_needed));
  if (scheme == Scheme::parallel) {
    const double done = -math::expm1(-(first + second));
    const double part = first + second > 0 ? rate.first / (rate.first + rate.second) : 0;
    return {done, done * part, done * (1 - part)};
  }
  const double done = -math::expm1(-first);
  const double product = intermediate(first, second);
  return {done, product, std::max(0.0, done - product)};
}

}  // namespace mahlwerk::powder
