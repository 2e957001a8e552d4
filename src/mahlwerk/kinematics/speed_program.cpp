// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/kinematics/speed_program.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace mahlwerk::kinematics {
namespace {

/// Share of the change of the rate at a share u of the way, and its integral from 0.
double eased(double u) {
  return u * u * (3 - 2 * u);
}
double eased_integral(double u) {
  const double u2 = u * u;
  return u2 - 0.5 * u * u2;
}

/// The share of the way at which the rate from `a` to `b`, of other signs, is 0.
double turning_point(double a, double b) {
  double low = 0, high = 1;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    ((a + (b - a) * eased(middle) > 0) == (a > 0) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

SpeedProgram::SpeedProgram(std::vector<SpeedRow> rows, bool repeats)
    : rows_(std::move(rows)), clocks_(1, 0), travels_(1, 0), repeats_(repeats) {
  for (std::size_t i = 0; i + 1 < rows_.size(); ++i) {
    const double step = rows_[i + 1].time - rows_[i].time;
    clocks_.push_back(clocks_[i] + step * 0.5 * (rows_[i].rate + rows_[i + 1].rate));
    travels_.push_back(travels_[i] + travel_in(i, 1));
  }
}

bool SpeedProgram::reverses() const {
  const auto [least, most] = std::ranges::minmax_element(rows_, {}, &SpeedRow::rate);
  return !empty() && least->rate < 0 && most->rate > 0;
}

std::size_t SpeedProgram::row_at(double t) const {
  const auto after = std::ranges::upper_bound(rows_, t, {}, &SpeedRow::time);
  return after == rows_.begin() ? 0 : static_cast<std::size_t>(after - rows_.begin()) - 1;
}

Clock SpeedProgram::clock(double t) const {
  if (empty()) return {t};
  if (repeats_ && t >= end()) {
    const double cycles = std::floor(t / end());
    Clock at = clock(std::clamp(t - cycles * end(), 0.0, std::nextafter(end(), 0.0)));
    at.time += cycles * clocks_.back();
    return at;
  }
  const std::size_t i = row_at(t);
  const SpeedRow& from = rows_[i];
  if (t <= 0 || i + 1 == rows_.size())
    return {from.rate * t + (clocks_[i] - from.rate * from.time), from.rate, 0};
  const double step = rows_[i + 1].time - from.time, u = (t - from.time) / step,
               change = rows_[i + 1].rate - from.rate;
  return {clocks_[i] + step * u * (from.rate + change * eased_integral(u)),
          from.rate + change * eased(u), change * (6 * u * (1 - u) / step)};
}

double SpeedProgram::travel_in(std::size_t row, double u) const {
  const SpeedRow &from = rows_[row], &to = rows_[row + 1];
  const double step = to.time - from.time;
  const auto turned = [&](double v) {
    return step * v * (from.rate + (to.rate - from.rate) * eased_integral(v));
  };
  if (from.rate * to.rate >= 0) return std::abs(turned(u));
  const double back = std::min(u, turning_point(from.rate, to.rate));
  return std::abs(turned(back)) + std::abs(turned(u) - turned(back));
}

double SpeedProgram::travel(double t) const {
  if (empty()) return t;
  const double cycles = repeats_ ? std::floor(t / end()) : 0;
  const double within = t - cycles * end();
  const std::size_t i = row_at(within);
  if (i + 1 == rows_.size())
    return cycles * travels_.back() + travels_[i] +
           std::abs(rows_[i].rate) * (within - rows_[i].time);
  const double u = (within - rows_[i].time) / (rows_[i + 1].time - rows_[i].time);
  return cycles * travels_.back() + travels_[i] + travel_in(i, u);
}

/// The derivatives of the clock from a row to the next are at most 1.5 and 6 times the change of
/// the rate over the step, and over its square.
Bounds SpeedProgram::bounds(Bounds b) const {
  if (empty()) return b;
  double rate = std::abs(rows_.front().rate), second = 0, third = 0;
  for (std::size_t i = 0; i + 1 < rows_.size(); ++i) {
    const double step = rows_[i + 1].time - rows_[i].time,
                 change = std::abs(rows_[i + 1].rate - rows_[i].rate);
    rate = std::max(rate, std::abs(rows_[i + 1].rate));
    second = std::max(second, 1.5 * change / step);
    third = std::max(third, 6 * change / (step * step));
  }
  const double largest = std::max({b.acceleration.x, b.acceleration.y, b.acceleration.z});
  b.jerk = rate * rate * rate * b.jerk +
           (3 * std::numbers::sqrt3 * largest * (rate * second) + b.speed * third);
  b.acceleration = rate * rate * b.acceleration + b.speed * second * Vec3{1, 1, 1};
  b.angular_acceleration = rate * rate * b.angular_acceleration + b.spin * second;
  b.speed *= rate;
  b.spin *= rate;
  return b;
}

}  // namespace mahlwerk::kinematics
