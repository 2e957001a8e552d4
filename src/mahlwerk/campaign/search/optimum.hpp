// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/campaign/search/optimise.hpp"

namespace mahlwerk::campaign {

/// Fills in what settings tried say of the optimum: all but how the search went.
void conclude(const Goal& goal, Optimum& found);

}  // namespace mahlwerk::campaign
