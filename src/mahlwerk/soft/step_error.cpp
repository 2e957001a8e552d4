// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/step_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mahlwerk/contact/laws.hpp"

namespace mahlwerk::soft {
namespace {

constexpr double steps_of_table = 25;
/// Single collisions are off by more at other phases and angles than those of the table: by up to
/// 1.54 times as much (jkr, rebound, 48 phases).
constexpr double margin_of_single = 1.6;
/// Below the table's least restitution errors are larger than at it: the rebound's, over a tenth of
/// the impact speed, by up to 1.4 (linear-spring at e = 0.02), those of friction by up to 2.3
/// (adams-impact).
constexpr double margin_of_slow_rebound = 1.5, margin_of_slow_friction = 2.5;

}  // namespace

double StepError::largest_mean() const {
  return std::max({rebound, tangential, spin});
}

StepError step_error(const contact::AnyLaw& law, double restitution, double steps_per_collision) {
  const contact::StepErrors& table =
      std::visit([](const auto& l) -> const contact::StepErrors& { return l.step_errors; }, law);
  constexpr auto restitutions = contact::step_error_restitutions;
  const double e = std::clamp(restitution, restitutions.front(), restitutions.back());
  std::size_t k = 0;
  while (k + 2 < restitutions.size() && e > restitutions[k + 1]) ++k;
  const double part = (e - restitutions[k]) / (restitutions[k + 1] - restitutions[k]);
  // The error is of second order, plus a part of first order where sliding begins between two
  // steps. That part dominates in short steps, so the bound is scaled linearly there.
  const double step_ratio = steps_of_table / steps_per_collision;
  const double scale = step_ratio * std::max(step_ratio, 1.0) / 100;  // the table is in per cent
  const auto at = [&](std::size_t column) {
    return scale * ((1 - part) * table[k][column] + part * table[k + 1][column]);
  };
  const bool slow = restitution < restitutions.front();
  const double rebound = slow ? margin_of_slow_rebound : 1,
               friction = slow ? margin_of_slow_friction : 1;
  return {rebound * at(0), friction * at(1), friction * at(2), friction * margin_of_single * at(3)};
}

double steps_per_collision(const contact::AnyLaw& law, double restitution, double error) {
  constexpr double fewest = 16;
  const double share = step_error(law, restitution, steps_of_table).largest_mean() / error;
  return std::max(fewest, steps_of_table * (share < 1 ? std::sqrt(share) : share));
}

}  // namespace mahlwerk::soft
