// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/guard.hpp"

#include <sstream>
#include <string>

namespace mahlwerk::event {

namespace {

std::string piled(double time, double within, const std::string& events) {
  std::ostringstream text;
  text << "at " << time << " s " << events << " events took place within " << within
       << " s: bounces have collapsed (inelastic collapse) and time would stand still. ";
  return text.str();
}

constexpr const char* more = "; see docs/errors.md#inelastic-collapse";

}  // namespace

RunError pile_up(double time, double within) {
  return RunError(
      piled(time, within, "a hundred thousand") +
      "Let such contacts last ([contact] lasting = \"roll\", the default for one ball) or "
      "end them by the TC rule (lasting = \"tc\")" +
      more);
}

RunError pile_up_of_many(double time, double within, std::int64_t events) {
  return RunError(piled(time, within, std::to_string(events)) +
                  "End them by the TC rule ([contact] lasting = \"tc\", the default for several "
                  "balls), or with a longer contact_time" +
                  more);
}

}  // namespace mahlwerk::event
