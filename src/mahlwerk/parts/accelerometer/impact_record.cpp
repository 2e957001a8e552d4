// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/accelerometer/impact_record.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/trig.hpp"

namespace mahlwerk::parts::accelerometer {

void ImpactRecord::collisions(std::span<const scene::Collision> finished) {
  for (const scene::Collision& c : finished) {
    if (c.other >= 0) continue;
    const double from = (c.time - begin_) / step_;
    add(from, from + c.duration / step_, c.impulse * dot(c.normal, axis_));  // (sns.4)
  }
}

void ImpactRecord::serialize(Archive& archive) {
  const std::size_t count = impulses_.size();
  archive(impulses_);
  if (impulses_.size() != count) throw Archive::broken();
}

/// Adds an impulse between two times in intervals from the begin of the record.
void ImpactRecord::add(double from, double to, double impulse) {
  const auto count = static_cast<double>(impulses_.size());
  if (to < 0 || from >= count) return;
  const double first = std::floor(from);
  if (to <= first + 1) {  // within one interval
    if (from >= 0) impulses_[static_cast<std::size_t>(first)] += impulse;
    return;
  }
  const double rate = impulse / (to - from);
  const double end = std::min(std::ceil(to), count);
  for (double i = std::max(first, 0.0); i < end; ++i)
    impulses_[static_cast<std::size_t>(i)] += rate * (std::min(to, i + 1) - std::max(from, i));
}

std::vector<double> low_pass(const std::vector<double>& input, double step, double bandwidth,
                             double start) {
  // x'' + 2 sigma x' + 2 sigma^2 x = 2 sigma^2 u, with sigma = omega / sqrt(2).
  const double sigma = std::numbers::sqrt2 * std::numbers::pi * bandwidth;
  const double decay = math::exp(-sigma * step);
  const auto [sine, cosine] = sin_cos(sigma * step);
  std::vector<double> output;
  output.reserve(input.size());
  double x = start, v = 0;  // v is the derivative over sigma
  for (const double u : input) {
    const double e = x - u;
    x = u + decay * (e * (cosine + sine) + v * sine);
    v = decay * (v * (cosine - sine) - 2 * e * sine);
    output.push_back(x);
  }
  return output;
}

}  // namespace mahlwerk::parts::accelerometer
