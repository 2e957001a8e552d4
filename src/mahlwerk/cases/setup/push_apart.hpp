// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <vector>

#include "mahlwerk/cases/setup/grid.hpp"
#include "mahlwerk/cases/setup/obstacles.hpp"
#include "mahlwerk/geometry/any_shape.hpp"

namespace mahlwerk::cases {

/// A ball during placement, in the jar's own axes. Balls of one size are contiguous in memory.
struct PlacedBall {
  Vec3 position;
  double radius = 0;
  bool fixed = false;  ///< given position: the ball does not move
};

/// Result of push_apart().
struct PushApartResult {
  bool free = false;       ///< whether no ball touches another ball or the wall
  double largest = 0;      ///< [radii] largest ball size without any contact at these positions
  double typical = 0;      ///< [radii] ball size at which the overlapping pairs touch on average
  std::int64_t moves = 0;  ///< moves of single balls: the work done
};

/// Removes overlaps between balls and with the wall by minimising the energy of soft spheres. Ends
/// when the gap between any two balls is at least gap/2 of the sum of their radii, and the
/// clearance to the wall at least half of wall_clearance(); or when the balls rest against each
/// other; or after `most` moves. Throws Interrupted once `*stop` is set.
PushApartResult push_apart(std::vector<PlacedBall>& balls, const geometry::AnyShape& shape,
                           const Domain& domain, double gap, std::int64_t most,
                           const std::atomic<bool>* stop = nullptr,
                           const Obstacles* obstacles = nullptr);

}  // namespace mahlwerk::cases
