// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// measure: numbers of a mill from films, sounds, power logs, jars and drop tests.
#include "mahlwerk/commands/measure/measure.hpp"

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/commands/command.hpp"

namespace mahlwerk::commands {

Command measure_command() {
  return {"measure",
          "turn films, sounds, power logs, weighed jars and drop tests of a mill into its numbers",
          {},
          []() -> int {
            throw InputError(Fault{"mahlwerk measure", "it is not said what was measured",
                                   "write mahlwerk measure film, sound, power, jar or drop",
                                   "bad-command-line"});
          },
          {measure_film_command(), measure_sound_command(), measure_power_command(),
           measure_jar_command(), measure_drop_command()}};
}

}  // namespace mahlwerk::commands
