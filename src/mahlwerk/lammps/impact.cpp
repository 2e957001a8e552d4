// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/lammps/impact.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/contact/laws.hpp"

namespace mahlwerk::lammps {
namespace {

/// x'' = -x^p - c x^q x' in the units of a collision at speed 1.
struct Spring {
  bool hertz;
  double damping;
  double acceleration(double x, double v) const {
    x = std::max(x, 0.0);
    if (!hertz) return -x - damping * v;
    const double half = std::sqrt(x);
    return -x * half - damping * std::sqrt(half) * v;
  }
};

constexpr double step = 1e-3;   // a collision without damping takes about 3
constexpr double longest = 50;  // of a collision that never ends, at e = 0

}  // namespace

Impact::Impact(const contact::AnyLaw& law, const contact::EffectivePair& pair)
    : mass_(pair.mass),
      restitution_(pair.pair.restitution),
      friction_(pair.pair.friction),
      spring_ratio_(contact::tangential_stiffness_ratio) {
  const auto* linear = std::get_if<contact::LinearSpring>(&static_cast<const contact::Laws&>(law));
  // The spring of Mindlin stretches by t, its stiffness grows with t^(1/2): 2/3 of k_t/k_n.
  if (linear == nullptr) spring_ratio_ = 4 * pair.pair.shear_modulus / pair.pair.modulus;
  const double b = contact::damping_ratio(restitution_);
  const Spring spring{linear == nullptr, linear ? -2 * b : -std::sqrt(5.0) * b};
  exponent_ = linear ? 1 : 1.25;
  frequency_ =
      std::sqrt((linear ? linear->stiffness_of(pair) : contact::hertz_stiffness(pair)) / mass_);
  double x = 0, v = 1;
  for (double time = step; time < longest; time += step) {
    const double v1 = v, a1 = spring.acceleration(x, v);
    const double v2 = v + 0.5 * step * a1, a2 = spring.acceleration(x + 0.5 * step * v1, v2);
    const double v3 = v + 0.5 * step * a2, a3 = spring.acceleration(x + 0.5 * step * v2, v3);
    const double v4 = v + step * a3, a4 = spring.acceleration(x + step * v3, v4);
    x += step / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    v += step / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    if (x <= 0) break;
    const double phase = v / math::pow(x, exponent_);
    if (!curve_.empty() && phase >= curve_.back().phase) break;  // it creeps to the end, at e = 0
    curve_.push_back({time, x, v, phase});
    largest_ = std::max(largest_, x);
  }
}

double Impact::scale(double overlap, double x) const {
  return frequency_ * math::pow(overlap / x, exponent_);
}

double Impact::speed_of_largest(double overlap) const {
  return overlap > 0 ? scale(overlap, largest_) : 0;
}

double Impact::duration(double speed) const {
  const double overlap = math::pow(speed / frequency_, 1 / exponent_);  // where the curve has 1
  return curve_.back().time * overlap / speed;
}

Impact::Found Impact::found(double overlap, double rate) const {
  if (!(overlap > 0)) return {};
  const double phase = rate / (frequency_ * math::pow(overlap, exponent_));
  const auto at = std::ranges::lower_bound(curve_, phase, std::ranges::greater(), &Instant::phase);
  const Instant& is = at == curve_.end() ? curve_.back() : *at;
  // Of the two, the one that changes little from instant to instant.
  const double speed = is.rate > 0.5 ? rate / is.rate : scale(overlap, is.overlap);
  const double whole = duration(speed);
  return {speed, is.time / curve_.back().time * whole, whole};
}

}  // namespace mahlwerk::lammps
