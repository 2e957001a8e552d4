// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "mahlwerk/observe/by_pair.hpp"
#include "mahlwerk/observe/histogram.hpp"
#include "mahlwerk/scene/observer.hpp"

namespace mahlwerk::observe {

/// Impact angle [rad] of `approach` u_n > 0 and `slip` |u_t|: 0 head-on, pi/2 grazing; within 2e-8
/// rad.
double impact_angle(double approach, double slip);

/// Sums over collisions; divide by `count` for means.
struct Sums {
  std::int64_t count = 0;
  std::int64_t between_balls = 0;  ///< the others are with the jar
  double energy_normal = 0, energy_contact_point = 0, energy_centre = 0, lost = 0;  // [J]
  double approach = 0, slip = 0;                                                    // [m/s]
  double angle = 0;                                                                 // [rad]

  void add(const scene::Collision& c, double angle_of_c);
  void merge(const Sums& o);
};

/// What one replicate's collisions add up to, in fixed memory.
class Tally : public scene::Observer {
 public:
  static constexpr int angle_bins = 90;  // of one degree, 0 head-on, 90 grazing

  /// With the kinds of balls it counts by pair of kinds, too.
  explicit Tally(double threshold, BallKinds kinds = {})
      : by_pair(std::move(kinds)), threshold_(threshold) {}
  void collisions(std::span<const scene::Collision> finished) override;

  void carry(Archive& archive);

  double threshold() const { return threshold_; }  // [m/s] on u_n
  Sums all, above;                                 // above: u_n >= threshold
  LogHistogram energy_normal, energy_contact_point, energy_centre, energy_lost;  // [J]
  LogHistogram approach;                                                         // [m/s]
  std::array<std::int64_t, angle_bins> angle_all{}, angle_above{};
  ByPair by_pair;

 private:
  double threshold_;
};

}  // namespace mahlwerk::observe
