// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/case.hpp"

namespace mahlwerk::campaign {

/// Why the graphics card of this machine cannot compute the case: another engine, a part that
/// kernels lack, no card, too little memory. Empty with run.device = "cpu" or "auto".
std::vector<Fault> device_faults(const cases::Case& mill_case);

/// [bytes] of the card's memory that a replicate needs.
double card_memory(const cases::Case& mill_case);

}  // namespace mahlwerk::campaign
