// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/summary.hpp"

namespace mahlwerk::results {

/// Of the quantities of summary.json what says how exact a run was, without the cost of the others.
std::vector<Quantity> summarise_checks(const Outcome& outcome);

}  // namespace mahlwerk::results
