// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/case.hpp"

// Memory that a run needs, and memory that is available.
namespace mahlwerk::campaign {

/// [bytes] Estimated peak memory of one replicate: the engine's data for each ball, and statistics.
double memory_needed(const cases::Case& mill_case);

/// [bytes] Memory still available to this process: that of the machine or, if less, that of its
/// control group. Empty if the system does not report it. `root` is a prefix of the paths that are
/// read.
std::optional<double> memory_available(const std::string& root = "");

/// A fault if the replicates that `at_once` threads run of the largest case need more than
/// `available` [bytes].
std::vector<Fault> memory_faults(const std::vector<cases::Case>& points, int at_once,
                                 std::optional<double> available);

}  // namespace mahlwerk::campaign
