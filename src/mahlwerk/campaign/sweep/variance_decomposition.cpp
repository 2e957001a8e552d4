// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Variance decomposition from groups of runs (docs/theory/sensitivity.md).
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/campaign/sweep/sensitivity.hpp"

namespace mahlwerk::campaign {
namespace {

/// Outcomes of one group, and squares of their errors.
struct Group {
  double a = 0, b = 0;
  std::vector<double> mixed;
  double noise_a = 0, noise_b = 0;
  std::vector<double> noise_mixed;
};

std::vector<Group> groups_of(std::size_t keys, const std::vector<double>& outcomes,
                             const std::vector<double>& errors) {
  const auto square = [&](std::size_t row) {
    return errors.empty() ? 0 : errors[row] * errors[row];
  };
  std::vector<Group> groups(outcomes.size() / (keys + 2));
  for (std::size_t row = 0; Group & g : groups) {
    g.a = outcomes[row];
    g.noise_a = square(row++);
    for (std::size_t i = 0; i < keys; ++i) {
      g.mixed.push_back(outcomes[row]);
      g.noise_mixed.push_back(square(row++));
    }
    g.b = outcomes[row];
    g.noise_b = square(row++);
  }
  return groups;
}

/// Mean and variance of the outcomes of a and b; the variance is without that of errors.
struct Moments {
  double mean = 0, variance = 0, noise = 0;
};

Moments moments_of(const std::vector<Group>& groups, const std::vector<std::size_t>& drawn) {
  double count = 0, sum = 0, squares = 0, noise = 0;
  const auto each = [&](const auto& take) {
    for (const std::size_t j : drawn) {
      const Group& g = groups[j];
      if (std::isfinite(g.a)) take(g.a, g.noise_a);
      if (std::isfinite(g.b)) take(g.b, g.noise_b);
    }
  };
  each([&](double y, double e) { count += 1, sum += y, noise += e; });
  const double mean = sum / count;
  each([&](double y, double) { squares += (y - mean) * (y - mean); });
  noise /= count;
  return {mean, squares / (count - 1) - noise, noise};  // (sen.7)
}

struct IndexPair {
  double first = unknown, total = unknown;
  std::size_t count = 0;
};

IndexPair indices_of(const std::vector<Group>& groups, const std::vector<std::size_t>& drawn,
                     const Moments& spread, std::size_t key) {
  double first = 0, total = 0;
  std::size_t count = 0;
  for (const std::size_t j : drawn) {
    const Group& g = groups[j];
    const double change = g.mixed[key] - g.a;
    if (!std::isfinite(change) || !std::isfinite(g.b)) continue;
    ++count;
    first += (g.b - spread.mean) * change;
    total += (change * change - g.noise_a - g.noise_mixed[key]) / 2;
  }
  if (count == 0 || !(spread.variance > 0)) return {.count = count};
  const double whole = static_cast<double>(count) * spread.variance;
  return {first / whole, total / whole, count};  // (sen.8, sen.9)
}

/// The 95 % percentile interval. NaN values come from samples without variance: if there are more
/// than one tail holds, the index is unbounded, and there is no interval.
observe::IntervalEstimate percentile_interval(double value, std::vector<double> values) {
  constexpr double beyond = 0.025;
  const auto drawn = static_cast<double>(values.size());
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  const auto left = static_cast<double>(values.size());
  if (values.size() < 2 || drawn - left > beyond * drawn) return {value, unknown, unknown};
  std::ranges::sort(values);
  const auto at = [&](double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), values.size() - 2);
    return std::lerp(values[below], values[below + 1], place - static_cast<double>(below));
  };
  return {value, at(beyond), at(1 - beyond)};
}

/// Number of bootstrap samples: fewer for large designs, to limit the time.
std::size_t bootstrap_samples(std::size_t groups, std::size_t keys) {
  return std::clamp<std::size_t>(200'000'000 / (groups * (keys + 2)), 200, 1000);
}

/// Whether a key changes no outcome in any group: its runs are then identical, errors included.
bool is_inactive(const std::vector<Group>& groups, std::size_t key) {
  bool any = false;
  for (const Group& g : groups) {
    const double change = g.mixed[key] - g.a;
    if (!std::isfinite(change)) continue;
    if (change != 0) return false;
    any = true;
  }
  return any;
}

/// Errors that are not subtracted look like a share of variance.
std::optional<bool> is_significant(const Effect& shares, bool errors_known) {
  if (shares.count < 2) return std::nullopt;
  if (!(shares.total.low > 0)) return false;
  return errors_known ? std::optional(true) : std::nullopt;
}

/// Indices of each key in the bootstrap samples (Efron 1979).
struct BootstrapSample {
  std::vector<std::vector<double>> firsts, totals;
};

BootstrapSample bootstrap(const std::vector<Group>& groups, std::size_t keys, std::uint64_t seed) {
  constexpr std::uint32_t stream = 0x40000000;  // designs use lower streams
  Random random(seed, stream);
  BootstrapSample made{std::vector<std::vector<double>>(keys),
                       std::vector<std::vector<double>>(keys)};
  std::vector<std::size_t> drawn(groups.size());
  const auto count = static_cast<double>(groups.size());
  for (std::size_t time = groups.empty() ? 0 : bootstrap_samples(groups.size(), keys); time > 0;
       --time) {
    for (std::size_t& j : drawn)
      j = std::min(groups.size() - 1, static_cast<std::size_t>(random.uniform() * count));
    const Moments spread = moments_of(groups, drawn);
    for (std::size_t key = 0; key < keys; ++key) {
      const IndexPair shares = indices_of(groups, drawn, spread, key);
      made.firsts[key].push_back(shares.first);
      made.totals[key].push_back(shares.total);
    }
  }
  return made;
}

Effect with_intervals(const IndexPair& best, std::vector<double> firsts,
                      std::vector<double> totals) {
  if (best.count < 2) firsts = totals = {};  // one group gives no scatter
  return {.first_order = percentile_interval(best.first, std::move(firsts)),
          .total = percentile_interval(best.total, std::move(totals)),
          .count = best.count};
}

}  // namespace

Sensitivity variance_decomposition(std::size_t keys, const std::vector<double>& outcomes,
                                   const std::vector<double>& errors, std::uint64_t seed) {
  if (outcomes.size() % (keys + 2) != 0 || (!errors.empty() && errors.size() != outcomes.size()))
    throw std::invalid_argument("a design and its outcomes have different numbers of rows");
  Sensitivity found{.design = cases::Design::sobol_indices, .base = mean_of_points(outcomes)};
  found.failed =
      static_cast<int>(std::ranges::count_if(outcomes, [](double y) { return !std::isfinite(y); }));
  const std::vector<Group> groups = groups_of(keys, outcomes, errors);
  std::vector<std::size_t> all(groups.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const Moments spread = moments_of(groups, all);
  found.variance = spread.variance;
  found.noise = errors.empty() ? unknown : spread.noise / (spread.variance + spread.noise);
  BootstrapSample again = bootstrap(groups, keys, seed);
  for (std::size_t key = 0; key < keys; ++key) {
    Effect& shares = found.effects.emplace_back(with_intervals(indices_of(groups, all, spread, key),
                                                               std::move(again.firsts[key]),
                                                               std::move(again.totals[key])));
    shares.inactive = is_inactive(groups, key);
    if (shares.inactive && std::isfinite(shares.total.value))
      shares.first_order = shares.total = {0, 0, 0};
    shares.significant = is_significant(shares, !errors.empty());
  }
  return found;
}

}  // namespace mahlwerk::campaign
