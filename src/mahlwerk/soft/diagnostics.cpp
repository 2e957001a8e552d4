// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/diagnostics.hpp"

#include <fmt/format.h>

#include "mahlwerk/base/units.hpp"

namespace mahlwerk::soft {

RunError unstable_run_error(double time, std::size_t ball, const char* why, const Vec3& position,
                            const Vec3& velocity, double time_step) {
  constexpr double shorter = 0.25;  // enough for pressed beds of any overlap (dem.48)
  return RunError(fmt::format(
      "the run became unstable at {:.9g} s, at ball {}: {}. The ball's position relative to the "
      "jar's centre is ({:.4g}, {:.4g}, {:.4g}) m, its velocity ({:.4g}, {:.4g}, {:.4g}) m/s. "
      "Write run.time_step = \"{}\" or less, a quarter of the present one: a bed that is pressed "
      "together needs a shorter step than a collision. Give a stiffer contact if balls are pressed "
      "through each other or the wall",
      time, ball + 1, why, position.x, position.y, position.z, velocity.x, velocity.y, velocity.z,
      show_rounded(shorter * time_step, "s", 2)));
}

void refuse_start_outside(std::int64_t step, std::size_t ball, std::string_view why) {
  if (step > 0 || why != outside_message) return;
  throw InputError(
      Fault{"balls", fmt::format("ball {}, or a part of it, starts outside the jar", ball + 1),
            "give positions at which no ball overlaps another ball or the jar", "outside-jar"});
}

InputError overlap_error(std::size_t ball, const std::string& with, double overlap,
                         const char* length) {
  return InputError(Fault{"balls",
                          fmt::format("ball {} overlaps {} by {:.2g} of {} at the start", ball + 1,
                                      with, overlap, length),
                          "give positions at which no ball overlaps another ball or the jar",
                          "overlapping-balls"});
}

}  // namespace mahlwerk::soft
