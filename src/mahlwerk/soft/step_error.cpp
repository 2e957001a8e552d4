// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/step_error.hpp"

#include <algorithm>
#include <cstddef>

#include "mahlwerk/contact/laws.hpp"

namespace mahlwerk::soft {
namespace {

/// Errors of tangential speed and spin are larger at other Poisson ratios and between the sampled
/// angles: by up to a fifth, found for hertz-tsuji at e = 0.8 and nu = 0.
constexpr double margin = 1.25;

}  // namespace

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
  const double step_ratio = 50 / steps_per_collision;
  const double scale = step_ratio * std::max(step_ratio, 1.0) / 100;  // the table is in per cent
  const auto at = [&](std::size_t column) {
    return scale * ((1 - part) * table[k][column] + part * table[k + 1][column]);
  };
  return {at(0), margin * at(1), margin * at(2)};
}

}  // namespace mahlwerk::soft
