// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/histogram.hpp"

#include <cmath>

namespace mahlwerk::observe {

void LogHistogram::merge(const LogHistogram& other) {
  inner_.merge(other.inner_, [](Whole& mine, Whole more) { mine += more; });
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    ends_[i].count += other.ends_[i].count;
    ends_[i].sum += other.ends_[i].sum;
  }
}

double LogHistogram::lower(int bin) {
  const auto quarter = static_cast<std::size_t>(bin % per_octave);
  return std::ldexp(edges[quarter], bin / per_octave + lowest_octave);  // (obs.2)
}

double LogHistogram::unit(std::int64_t bin) {
  // The first bin also holds negative values, which may be as large as others. A unit of 1e-30 J is
  // accurate enough there and leaves room for large sums.
  constexpr int first_bits = 20;
  const int octave = static_cast<int>(bin) / per_octave + lowest_octave;
  return std::ldexp(1.0, octave - (bin == 0 ? first_bits : mantissa_bits));
}

void LogHistogram::add_to_end(double value, std::int64_t at) {
  constexpr double max_units = 0x1p110;
  const double units = value / unit(at);
  End& end = ends_[at == 0 ? 0 : 1];
  ++end.count;
  end.sum += static_cast<Signed>(std::isnan(units) ? 0 : std::clamp(units, -max_units, max_units));
}

std::int64_t LogHistogram::count(int bin) const {
  if (!inside(bin)) return end(bin).count;
  return static_cast<std::int64_t>(inner_[static_cast<std::size_t>(bin)] >> count_place);
}

double LogHistogram::sum(int bin) const {
  if (!inside(bin)) return static_cast<double>(end(bin).sum) * unit(bin);
  return static_cast<double>(inner_[static_cast<std::size_t>(bin)] & (one - 1)) * unit(bin);
}

double LogHistogram::sum() const {
  double all = 0;
  for (int bin = 0; bin < bins; ++bin) all += sum(bin);
  return all;
}

std::int64_t LogHistogram::total() const {
  std::int64_t all = 0;
  for (int bin = 0; bin < bins; ++bin) all += count(bin);
  return all;
}

std::array<int, 2> LogHistogram::occupied_range() const {
  int first = 0, last = bins;
  while (first < bins && count(first) == 0) ++first;
  if (first == bins) return {0, 0};
  while (count(last - 1) == 0) --last;
  return {first, last};
}

}  // namespace mahlwerk::observe
