// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/tally.hpp"

#include <algorithm>

namespace mahlwerk::observe {
namespace {

/// One after the other, whatever the pieces they come in.
void add(Sums& sums, const Columns& c, std::size_t i, bool counts) {
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

void Sums::merge(const Sums& o) {
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

void Tally::collisions(std::span<const scene::Collision> finished) {
  Columns columns;
  while (!finished.empty()) {
    const auto some = finished.first(std::min(finished.size(), Columns::most));
    finished = finished.subspan(some.size());
    columns.take(some, wall_map.grid());
    for (std::size_t i = 0; i < some.size(); ++i) observe::add(all, columns, i, true);
    for (std::size_t i = 0; i < some.size(); ++i)
      observe::add(above, columns, i, !(columns.approach[i] < threshold_));
    for (std::size_t i = 0; i < some.size(); ++i) add(some[i], columns, i);
  }
}

void Tally::add(const scene::Collision& c, const Columns& columns, std::size_t i) {
  const bool counts = !(c.approach < threshold_);
  const int pair = by_pair.pair_of(c);
  const PairFactors& factors = by_pair.factors(pair);
  by_pair.at(pair).add(columns, i, counts, factors);
  if (c.other >= 0) {
    ++all.between_balls;
    above.between_balls += counts ? 1 : 0;
    return;
  }
  WallSums& cell = wall_map.at(columns.cell[i]);
  ++cell.count;
  cell.energy_normal += columns.energy_normal[i];
  cell.lost += columns.lost[i];
  cell.slid += factors.slid_per_loss * columns.lost_tangential[i];
  cell.erosion += columns.erosion[i];
}

void Tally::merge(const Tally& other) {
  all.merge(other.all);
  above.merge(other.above);
  by_pair.merge(other.by_pair);
  wall_map.merge(other.wall_map);
}

void Tally::carry(Archive& archive) {
  archive(all)(above);
  by_pair.carry(archive);
  wall_map.carry(archive);
}

Spectra Tally::whole() const {
  Spectra sum;
  for (int pair = 0; pair < by_pair.pairs(); ++pair) sum.merge(by_pair[pair].spectra);
  return sum;
}

}  // namespace mahlwerk::observe
