// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/commands/command.hpp"

namespace mahlwerk::commands {

/// The commands after `measure`.
Command measure_film_command();
Command measure_sound_command();
Command measure_power_command();
Command measure_jar_command();
Command measure_drop_command();

}  // namespace mahlwerk::commands
