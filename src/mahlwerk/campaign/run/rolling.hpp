// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::campaign {

/// For one ball that rolled or slid on the wall for most of the time, by a rule or a friction that
/// the case does not specify: a notice with the results of a short run with the TC rule. Else
/// empty.
Notices rolling_notices(const results::Outcome& outcome);

}  // namespace mahlwerk::campaign
