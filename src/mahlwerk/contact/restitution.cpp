// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/contact/restitution.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::contact {
namespace {

/// e_n of viscoelastic spheres as a function of the dimensionless damping D = beta v^(1/5)
/// (evt.20). Rational fit to the numerically integrated contact equation; error at most 1e-4 for
/// e_n from 1 to 0.02.
double viscoelastic_e(double d) {
  constexpr double p1 = 2.357410551600542, p2 = 0.21919648629130628;
  constexpr double q1 = 3.51085940969583, q2 = 3.4278800389898;
  constexpr double q3 = 1.1017793573334755, q4 = 0.03714372944981503;
  return (1 + d * (p1 + d * p2)) / (1 + d * (q1 + d * (q2 + d * (q3 + d * q4))));
}

/// The D at which viscoelastic_e is `e`, by bisection; viscoelastic_e decreases from 1.
double damping_for(double e) {
  double low = 0, high = 1;
  while (viscoelastic_e(high) > e) high *= 2;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (viscoelastic_e(middle) > e ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

Restitution Restitution::viscoelastic(double value, double at_speed) {
  if (!(value > 0 && value <= 1 && at_speed > 0 && std::isfinite(at_speed)))
    throw std::invalid_argument("viscoelastic restitution needs a value in (0, 1] and a speed");
  Restitution made(value);
  made.law_ = Law::viscoelastic;
  made.speed_ = at_speed;
  made.scale_ = value < 1 ? damping_for(value) / math::pow(at_speed, 0.2) : 0.0;
  return made;
}

Restitution Restitution::tabulated(Points speed_and_value) {
  double last = 0;
  for (const auto& [speed, value] : speed_and_value) {
    if (!(speed > last && std::isfinite(speed) && value >= 0 && value <= 1))
      throw std::invalid_argument("a restitution table needs rising speeds and values in [0, 1]");
    last = speed;
  }
  if (speed_and_value.empty()) throw std::invalid_argument("a restitution table needs a row");
  Restitution made(speed_and_value.front().second);
  made.law_ = Law::tabulated;
  made.points_ = std::move(speed_and_value);
  return made;
}

double Restitution::speed_dependent(double approach) const {
  if (law_ == Law::viscoelastic)
    return viscoelastic_e(scale_ * math::pow(std::max(approach, 0.0), 0.2));
  if (!(approach > points_.front().first)) return points_.front().second;
  const auto above = std::ranges::upper_bound(points_, approach, {}, &Points::value_type::first);
  if (above == points_.end()) return points_.back().second;
  const auto& [v0, e0] = *std::prev(above);
  const auto& [v1, e1] = *above;
  return e0 + (e1 - e0) * math::log(approach / v0) / math::log(v1 / v0);  // (evt.21)
}

}  // namespace mahlwerk::contact
