// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands.hpp"

namespace mahlwerk::app {

/// `fit` of a case whose [fit] has keys of [contact] or [mill]: calibrates them with runs.
int calibrate(const Request& request, const std::filesystem::path& file);

}  // namespace mahlwerk::app
