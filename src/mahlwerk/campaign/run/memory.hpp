// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/case.hpp"

// Memory a run takes and what there is of it.
namespace mahlwerk::campaign {

/// [bytes] that one replicate of the case takes at most, about: what its engine keeps of a ball,
/// and what is counted.
double memory_needed(const cases::Case& what);

/// [bytes] this process may still take: what the machine has free or, where that is less, what its
/// control group leaves. Nothing where the system does not say. `root` is put before the paths
/// read.
std::optional<double> memory_available(const std::string& root = "");

/// A fault if `at_once` replicates of the largest case need more than `available` [bytes].
std::vector<Fault> memory_faults(const std::vector<cases::Case>& points, int at_once,
                                 std::optional<double> available);

}  // namespace mahlwerk::campaign
