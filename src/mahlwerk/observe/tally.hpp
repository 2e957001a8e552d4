// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>

#include "mahlwerk/observe/by_pair.hpp"
#include "mahlwerk/observe/wall_map.hpp"
#include "mahlwerk/scene/observer.hpp"

namespace mahlwerk::observe {

/// Sums over collisions; divide by `count` for means.
struct Sums {
  std::int64_t count = 0;
  std::int64_t between_balls = 0;  ///< the others are with the jar
  double energy_normal = 0, energy_contact_point = 0, energy_centre = 0, lost = 0;  // [J]
  double approach = 0, slip = 0;                                                    // [m/s]
  double angle = 0;                                                                 // [rad]

  void merge(const Sums& o);
};

/// What one replicate's collisions add up to, in fixed memory.
class Tally : public scene::Observer {
 public:
  explicit Tally(double threshold, BallKinds kinds = {}, const WallGrid& wall = {})
      : by_pair(std::move(kinds)), wall_map(wall), threshold_(threshold) {}
  void collisions(std::span<const scene::Collision> finished) override;

  void merge(const Tally& other);  ///< of the same kinds, grid and threshold
  void carry(Archive& archive);

  double threshold() const { return threshold_; }  // [m/s] on u_n
  Spectra whole() const;                           ///< of all kinds of pairs together

  Sums all, above;  // above: u_n >= threshold
  ByPair by_pair;
  WallMap wall_map;

 private:
  void add(const scene::Collision& c, const Columns& columns, std::size_t i);
  double threshold_;
};

}  // namespace mahlwerk::observe
