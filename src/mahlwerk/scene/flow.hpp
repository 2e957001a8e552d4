// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "mahlwerk/base/rotation.hpp"
#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::scene {

/// Balls leave a jar through a plane and enter it in a box, in the jar frame
/// (docs/theory/flow.md). Balls that are outside at the start wait to be fed.
struct Flow {
  enum class Feed {
    none,         ///< nothing enters: a batch is discharged
    recirculate,  ///< what waits, and what has left, enters as soon as there is room
    rate          ///< at a given rate
  };
  Vec3 outlet;         ///< [m] a point of the plane
  Vec3 outlet_normal;  ///< unit vector, out of the jar
  Feed feed = Feed::none;
  Rotation axes;           ///< of the box
  Vec3 inlet, inlet_size;  ///< [m] its middle; its edges
  double rate = 0;         ///< [1/s]
  double mass_rate = 0;    ///< [kg/s] in place of `rate`, unless it is 0
  bool returns = true;     ///< what has left waits to be fed again
  std::uint64_t seed = 1;  ///< of the places in the box, and of the order of the feed

  /// [s] From the entry of a ball to the next one, with Feed::rate.
  double feed_interval(double mass) const { return mass_rate > 0 ? mass / mass_rate : 1 / rate; }

  /// Whether a ball whose centre is at `position` [m] has left (flo.1).
  bool has_left(const Vec3& position) const { return dot(position - outlet, outlet_normal) > 0; }
};

/// A ball that has left the jar, or entered it.
struct Passage {
  double time = 0;           ///< [s] since the start of the run
  double mass = 0;           ///< [kg]
  std::int32_t ball = 0;     ///< its number
  std::int32_t kind = 0;     ///< number of its ball set
  std::int64_t entered = 0;  ///< 1: entered; 0: left
};

}  // namespace mahlwerk::scene
