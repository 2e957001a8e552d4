// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/commands/runs/run_jobs.hpp"

namespace mahlwerk::commands {

/// Follows the wear of a case with [wear] evolve, into the result folder of its job; continues an
/// earlier one of the same case. Returns the exit code.
int evolve_wear(const Running& running, const RunJob& job);

}  // namespace mahlwerk::commands
