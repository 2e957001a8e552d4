// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/step_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/results/quantities/spectra.hpp"

namespace mahlwerk::campaign {

double largest_collision_speed(const results::Outcome& outcome) {
  double most = 0;
  for (const results::Replicate& r : outcome.replicates)
    most = std::max(most, results::largest_speed(r));
  return most;
}

Notices speed_notices(const cases::Case& mill_case, double speed) {
  constexpr double much = 1.1, large = 0.02;
  const SoftSettings s = soft_settings(mill_case);
  if (!(speed > s.speed)) return {};
  const soft::StepError stated = step_error(mill_case, s, s.speed),
                        e = step_error(mill_case, s, speed);
  if (!(e.tangential > much * stated.tangential)) return {};
  const double needed = recommended_step(mill_case, speed);
  if (!(needed < s.rules.time_step)) return {};  // the requested error is still kept
  const bool matters = e.largest_mean() > large;
  std::string text = fmt::format(
      "Bodies collided at up to {}, faster than {}, for which the errors of the time step are "
      "stated. The shortest collisions are off by up to {} % of their rebound speed, {} % of their "
      "tangential speed and {} % of their spin on average, instead of {} %, {} % and {} %. Write "
      "run.time_step = \"{}\" or less.",
      show_rounded(speed, "m/s", 2), show_rounded(s.speed, "m/s", 2), two_digits(100 * e.rebound),
      two_digits(100 * e.tangential), two_digits(100 * e.spin), two_digits(100 * stated.rebound),
      two_digits(100 * stated.tangential), two_digits(100 * stated.spin),
      show_rounded(needed, "s", 2));
  return {matters ? warning("faster-than-expected", std::move(text))
                  : note("faster-than-expected", std::move(text))};
}

}  // namespace mahlwerk::campaign
