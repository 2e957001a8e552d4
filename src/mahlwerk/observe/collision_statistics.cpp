// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/collision_statistics.hpp"

#include <algorithm>

namespace mahlwerk::observe {
namespace {

/// Adds one collision. Sums run in the order of collisions, independent of their batches.
void add(CollisionSums& sums, const CollisionBatch& c, std::size_t i, bool counts) {
  const double one = counts ? 1 : 0;
  sums.count += counts ? 1 : 0;
  sums.energy_normal += one * c.energy_normal[i];
  sums.energy_contact_point += one * c.energy_contact_point[i];
  sums.energy_centre += one * c.energy_centre[i];
  sums.lost += one * c.lost[i];
  sums.approach += one * c.approach[i];
  sums.slip += one * c.slip[i];
  sums.angle += one * c.angle[i];
}

}  // namespace

void CollisionSums::merge(const CollisionSums& o) {
  count += o.count;
  between_balls += o.between_balls;
  energy_normal += o.energy_normal;
  energy_contact_point += o.energy_contact_point;
  energy_centre += o.energy_centre;
  lost += o.lost;
  approach += o.approach;
  slip += o.slip;
  angle += o.angle;
}

void CollisionStatistics::collisions(std::span<const scene::Collision> finished) {
  CollisionBatch batch;
  while (!finished.empty()) {
    const auto some = finished.first(std::min(finished.size(), CollisionBatch::most));
    finished = finished.subspan(some.size());
    batch.load(some, wall_map.grid());
    for (std::size_t i = 0; i < some.size(); ++i) observe::add(all, batch, i, true);
    for (std::size_t i = 0; i < some.size(); ++i)
      observe::add(above, batch, i, !(batch.approach[i] < threshold_));
    for (std::size_t i = 0; i < some.size(); ++i) add(some[i], batch, i);
  }
}

void CollisionStatistics::add(const scene::Collision& c, const CollisionBatch& batch,
                              std::size_t i) {
  const bool counts = !(c.approach < threshold_);
  const int pair = by_pair.pair_of(c);
  const PairFactors& factors = by_pair.factors(pair);
  by_pair.at(pair).add(batch, i, counts, factors);
  body_hits.add(c, batch, i);
  if (c.other >= 0) {
    ++all.between_balls;
    above.between_balls += counts ? 1 : 0;
    return;
  }
  WallSums& cell = cell_of(c, batch, i, pair);
  ++cell.count;
  cell.energy_normal += batch.energy_normal[i];
  cell.lost += batch.lost[i];
  cell.load_distance += factors.load_distance_per_loss * batch.lost_tangential[i];
  cell.erosion += batch.erosion[i];
}

WallSums& CollisionStatistics::cell_of(const scene::Collision& c, const CollisionBatch& batch,
                                       std::size_t i, int pair) {
  if (~c.other < wall_map.grid().faces) return wall_map.at(batch.cell[i]);
  const int first = by_pair.faces() - static_cast<int>(part_maps.size());
  PartMap& part = part_maps[static_cast<std::size_t>(by_pair.kinds_of(pair).face() - first)];
  return part.at(part.grid().cell_of(c.where, -1.0 * c.normal));
}

void CollisionStatistics::merge(const CollisionStatistics& other) {
  all.merge(other.all);
  above.merge(other.above);
  by_pair.merge(other.by_pair);
  wall_map.merge(other.wall_map);
  body_hits.merge(other.body_hits);
  for (std::size_t k = 0; k < part_maps.size(); ++k) part_maps[k].merge(other.part_maps[k]);
}

void CollisionStatistics::serialize(Archive& archive) {
  archive(all)(above);
  by_pair.serialize(archive);
  wall_map.serialize(archive);
  body_hits.serialize(archive);
  for (PartMap& one : part_maps) one.serialize(archive);
}

Spectra CollisionStatistics::total_spectra() const {
  Spectra sum;
  for (int pair = 0; pair < by_pair.pairs(); ++pair) sum.merge(by_pair[pair].spectra);
  return sum;
}

}  // namespace mahlwerk::observe
