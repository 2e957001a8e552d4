// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/sweep/work.hpp"

#include <algorithm>

#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/settling.hpp"

namespace mahlwerk::campaign {

double work_estimate(const cases::Case& mill_case) {
  // Soft engine: minimum time of a step, and time of a step for each ball. Event engine: time for
  // each ball and simulated second, some hundred collisions of a microsecond each
  // (docs/performance.md).
  constexpr double step = 2e-7, ball_step = 1e-7, ball_second = 2e-4;
  const auto balls = static_cast<double>(cases::balls_count(mill_case.balls));
  double each = ball_second * balls;
  if (cases::in_time_steps(mill_case.run.engine)) {
    const double dt = soft_settings(mill_case).rules.time_step;
    each = (dt > 0 ? 1 / dt : 0) * std::max(step, ball_step * balls);
  }
  return each * cases::simulated_time(mill_case) * static_cast<double>(mill_case.run.replicates);
}

}  // namespace mahlwerk::campaign
