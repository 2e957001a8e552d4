// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/campaign/search/optimise.hpp"

namespace mahlwerk::campaign {

/// Fills in all results that follow from the trials: all but those about the course of the search.
void conclude(const Goal& goal, Optimum& found);

}  // namespace mahlwerk::campaign
