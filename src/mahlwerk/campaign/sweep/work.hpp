// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/cases/case.hpp"

namespace mahlwerk::campaign {

/// [s] Estimated time of a run of the case on one core, to an order of magnitude. Used to sort a
/// campaign's runs and to predict its remaining time, which is corrected as runs end.
double work_estimate(const cases::Case& mill_case);

}  // namespace mahlwerk::campaign
