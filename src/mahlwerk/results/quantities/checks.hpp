// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::results {

/// Of powder as grains: the same in every replicate.
std::vector<Measure> grain_measures(const cases::Case& what);
/// What says how exact a run was.
std::vector<Measure> check_measures();

}  // namespace mahlwerk::results
