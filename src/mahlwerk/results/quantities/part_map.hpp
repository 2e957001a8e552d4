// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/quantities/wall.hpp"

// Maps of hits and wear on the parts in the jar (obs.23).
namespace mahlwerk::results {

/// Hits on each cell of a part.
struct PartRates : HitRates {
  observe::PartGrid grid;
};

/// One of each part, without hits and areas.
std::vector<PartRates> no_part_rates(const observe::CollisionStatistics& of);
/// Adds the hits of a replicate to means over `count` replicates.
void add_hits(std::vector<PartRates>& rates, const Replicate& replicate, double count);
/// One of each part; none without replicates.
std::vector<PartRates> part_rates(const Outcome& outcome);

/// "plus_x": the view of a part that its surface faces.
const char* view_name(observe::PartGrid::Side side);
Table part_map(const Outcome& outcome);  ///< part_map.csv: a row per cell of each part

}  // namespace mahlwerk::results
