// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/guard.hpp"

#include <string>

namespace mahlwerk::event {

RunError pile_up(double time, double within) {
  return RunError(
      "at " + std::to_string(time) + " s a hundred thousand events took place within " +
      std::to_string(within) +
      " s: the ball's bounces have collapsed (inelastic collapse) and time would stand still. "
      "Let such contacts last ([contact] lasting = \"roll\", the default) or end them by the "
      "TC rule (lasting = \"tc\"); see docs/errors.md#inelastic-collapse");
}

}  // namespace mahlwerk::event
