// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/fourier.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/trig.hpp"

namespace mahlwerk::measure {
namespace {

void reorder_by_reversed_bits(std::vector<Complex>& values) {
  const std::size_t n = values.size();
  for (std::size_t i = 1, reversed = 0; i < n; ++i) {
    std::size_t bit = n >> 1U;
    for (; (reversed & bit) != 0; bit >>= 1U) reversed ^= bit;
    reversed ^= bit;
    if (i < reversed) std::swap(values[i], values[reversed]);
  }
}

double median_interval(std::span<const double> time) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < time.size(); ++i) intervals.push_back(time[i] - time[i - 1]);
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::ranges::nth_element(intervals, middle);
  return *middle;
}

Complex mean(std::span<const Complex> values) {
  Complex sum = 0;
  for (const Complex& value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Removes drift, which would hide slow frequencies.
void remove_line(std::vector<Complex>& values) {
  const std::size_t n = values.size(), quarter = std::max<std::size_t>(1, n / 4);
  const Complex first = mean(std::span(values).first(quarter)),
                last = mean(std::span(values).last(quarter));
  const auto between = static_cast<double>(n - quarter);
  for (std::size_t i = 0; i < n; ++i) {
    const double place =
        (static_cast<double>(i) - 0.5 * static_cast<double>(quarter - 1)) / std::max(1.0, between);
    values[i] -= first + place * (last - first);
  }
}

}  // namespace

std::size_t power_of_two(std::size_t count) {
  std::size_t size = 1;
  while (size < count) size *= 2;
  return size;
}

void fourier_transform(std::vector<Complex>& values) {
  reorder_by_reversed_bits(values);
  const std::size_t n = values.size();
  for (std::size_t half = 1; half < n; half *= 2) {
    std::vector<Complex> factors;
    for (std::size_t j = 0; j < half; ++j) {
      const SinCos at =
          sin_cos(-std::numbers::pi * static_cast<double>(j) / static_cast<double>(half));
      factors.emplace_back(at.cos, at.sin);
    }
    for (std::size_t begin = 0; begin < n; begin += 2 * half)
      for (std::size_t j = 0; j < half; ++j) {
        Complex &a = values[begin + j], &b = values[begin + j + half];
        const Complex turned = b * factors[j];
        b = a - turned;
        a += turned;
      }
  }
}

EvenSeries even_series(std::span<const double> time, std::span<const double> x,
                       std::span<const double> y) {
  EvenSeries made{median_interval(time), {}};
  const double steps = std::floor((time.back() - time.front()) / made.interval * (1 + 1e-9));
  if (!(steps < 20 * static_cast<double>(time.size())))
    throw InputError(Fault{"", "the times have gaps much longer than the usual interval",
                           "give a part without gaps", "bad-readings"});
  std::size_t at = 0;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(steps); ++i) {
    const double t = time.front() + static_cast<double>(i) * made.interval;
    while (at + 2 < time.size() && time[at + 1] < t) ++at;
    const double share = (t - time[at]) / (time[at + 1] - time[at]);
    made.values.emplace_back(x[at] + share * (x[at + 1] - x[at]),
                             y[at] + share * (y[at + 1] - y[at]));
  }
  remove_line(made.values);
  return made;
}

double peak_frequency(const std::vector<EvenSeries>& series, bool both_senses) {
  const std::size_t count = series.front().values.size(), size = power_of_two(4 * count);
  std::vector<double> power(size, 0);
  for (const EvenSeries& one : series) {
    std::vector<Complex> values = one.values;
    values.resize(size);
    fourier_transform(values);
    for (std::size_t i = 0; i < size; ++i) power[i] += std::norm(values[i]);
  }
  const std::size_t least = std::max<std::size_t>(1, size / count);  // one cycle
  std::size_t best = least;
  for (std::size_t i = least; i <= size - least; ++i)
    if ((both_senses || i <= size / 2) && power[i] > power[best]) best = i;
  const double unit = 1 / (static_cast<double>(size) * series.front().interval);
  return unit * (best <= size / 2 ? static_cast<double>(best)
                                  : static_cast<double>(best) - static_cast<double>(size));
}

}  // namespace mahlwerk::measure
