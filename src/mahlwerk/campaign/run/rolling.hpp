// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::campaign {

/// Of one ball that rolled or slid on the wall for most of the time, by a rule or a friction that
/// the case does not say: what the TC rule gives, by a short run of its own. Nothing else.
Notices rolling_notices(const results::Outcome& outcome);

}  // namespace mahlwerk::campaign
