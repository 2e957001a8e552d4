// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "mahlwerk/observe/body_hits.hpp"
#include "mahlwerk/observe/pair_statistics.hpp"
#include "mahlwerk/observe/part_map.hpp"
#include "mahlwerk/observe/wall_map.hpp"
#include "mahlwerk/scene/observer.hpp"

namespace mahlwerk::observe {

/// Sums over collisions; divide by `count` for means.
struct CollisionSums {
  std::int64_t count = 0;
  std::int64_t between_balls = 0;  ///< the other collisions are with the jar
  double energy_normal = 0, energy_contact_point = 0, energy_centre = 0, lost = 0;  // [J]
  double approach = 0, slip = 0;                                                    // [m/s]
  double angle = 0;                                                                 // [rad]

  void merge(const CollisionSums& o);
};

/// Collision statistics of one replicate, in fixed memory.
class CollisionStatistics : public scene::Observer {
 public:
  /// `parts`: one of each part; they are the last ones of the distinguished faces of `kinds`.
  explicit CollisionStatistics(double threshold, BallKinds kinds = {}, const WallGrid& wall = {},
                               const std::vector<PartGrid>& parts = {})
      : by_pair(std::move(kinds)),
        wall_map(wall),
        part_maps(parts.begin(), parts.end()),
        threshold_(threshold) {}
  void collisions(std::span<const scene::Collision> finished) override;

  void merge(const CollisionStatistics& other);  ///< of the same kinds, grid and threshold
  /// Gives back the memory of what is zero; nothing is added from then on.
  void pack() {
    by_pair.pack();
    wall_map.pack();
    body_hits.pack();
    for (PartMap& one : part_maps) one.pack();
  }
  /// Forgets spectra and maps, but not the sums.
  void let_go() {
    by_pair.let_go();
    wall_map.let_go();
    body_hits.let_go();
    for (PartMap& one : part_maps) one.let_go();
  }
  void serialize(Archive& archive);

  double threshold() const { return threshold_; }  // [m/s] on u_n
  Spectra total_spectra() const;                   ///< of all kinds of pairs together

  CollisionSums all, above;  // above: collisions with u_n >= threshold
  StatisticsByPair by_pair;
  WallMap wall_map;
  BodyHits body_hits;
  std::vector<PartMap> part_maps;

 private:
  void add(const scene::Collision& c, const CollisionBatch& batch, std::size_t i);
  /// The sums of the cell that a hit on a wall belongs to.
  WallSums& cell_of(const scene::Collision& c, const CollisionBatch& batch, std::size_t i,
                    int pair);
  double threshold_;
};

}  // namespace mahlwerk::observe
