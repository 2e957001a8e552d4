// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/campaign/run/run.hpp"

namespace mahlwerk::campaign {

/// Lets three replicates of a short run of few balls with settle = "auto" go on: a warning if
/// power, hits or their energy are others then. A few balls may fly irregularly for seconds before
/// they move in step with the mill, or stay on its wall, which no trend announces (sta.14).
Notices later_motion_notices(const results::Outcome& outcome, const RunOptions& options);

/// [1] What that costs, over the cost of the run of `mill_case`, which settles for `settling` [s].
double later_motion_cost(const cases::Case& mill_case, double settling);

}  // namespace mahlwerk::campaign
