// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "mahlwerk/base/rotation.hpp"
#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::scene {

/// Balls leave a jar through a plane and enter it again in a box, in the jar frame
/// (docs/theory/flow.md).
struct Flow {
  enum class Feed {
    none,         ///< what has left stays outside: a batch is discharged
    recirculate,  ///< what has left enters again, as soon as there is room
    rate          ///< likewise, at most `rate` balls a second
  };
  Vec3 outlet;         ///< [m] a point of the plane
  Vec3 outlet_normal;  ///< unit vector, out of the jar
  Feed feed = Feed::none;
  Rotation axes;           ///< of the box
  Vec3 inlet, inlet_size;  ///< [m] its middle; its edges
  double rate = 0;         ///< [1/s]
  std::uint64_t seed = 1;  ///< of the places in the box

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
