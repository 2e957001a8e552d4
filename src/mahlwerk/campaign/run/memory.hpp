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
/// [bytes] Most memory of the result of a replicate that has ended: its statistics, packed, or what
/// is left of them once they are summed up (RunOptions::sums_up).
double memory_kept(const cases::Case& mill_case, bool sums_up = false);
/// [bytes] Most memory of a program that runs all points, `at_once` replicates at a time.
double memory_of_run(const std::vector<cases::Case>& points, int at_once, bool sums_up = false);

/// [bytes] Memory still available to this process: that of the machine or, if less, that of its
/// control group. Empty if the system does not report it. `root` is a prefix of the paths that are
/// read.
std::optional<double> memory_available(const std::string& root = "");

std::string bytes_in_words(double bytes);  ///< "15 MB", "3.2 GB"

/// A fault if a run of all points in `at_once` threads needs more than `available` [bytes].
std::vector<Fault> memory_faults(const std::vector<cases::Case>& points, int at_once,
                                 std::optional<double> available, bool sums_up = false);

}  // namespace mahlwerk::campaign
