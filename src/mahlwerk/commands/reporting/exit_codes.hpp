// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace mahlwerk::commands {

/// Exit codes (docs/cli.md).
enum Exit : int {
  success = 0,
  internal_error = 1,
  bad_input = 2,
  stopped_by_physics = 3,
  output_lost = 4,
  interrupted = 130
};

}  // namespace mahlwerk::commands
