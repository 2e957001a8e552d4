// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/cases/case.hpp"

namespace mahlwerk::campaign {

/// [s] of one core that a run of the case takes, to an order of magnitude: for the order of a
/// campaign's runs and the time it has left, which corrects itself as runs end.
double work_estimate(const cases::Case& what);

}  // namespace mahlwerk::campaign
