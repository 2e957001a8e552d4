// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/table.hpp"

namespace mahlwerk::results {

/// Hits of bodies that are no spheres by energy and by where on the body (bod.16); no rows without
/// such hits.
Table body_hits(const Outcome& outcome);

}  // namespace mahlwerk::results
