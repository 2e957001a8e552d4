// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <vector>

#include "mahlwerk/cases/setup/grid.hpp"
#include "mahlwerk/geometry/any_shape.hpp"

namespace mahlwerk::cases {

/// A ball on its way to a free place, in the jar's own axes. Balls of one size stand together.
struct PlacedBall {
  Vec3 position;
  double radius = 0;
  bool fixed = false;  ///< stays where it is, whatever it touches
};

/// How pushing apart ended.
struct PushApartResult {
  bool free = false;       ///< nothing touches anything
  double largest = 0;      ///< times the radius: balls so large would touch nothing where they are
  double typical = 0;      ///< times the radius: where those that touch would touch on average
  std::int64_t moves = 0;  ///< of single balls, for a bound on the work
};

/// Moves balls that overlap apart and back into the jar, like soft spheres coming to rest, until
/// between any two there are at least gap/2 of their radii's sum, and as much of a radius between
/// ball and wall as `gap` and the jar allow. Gives up where they rest against each other, or after
/// `most` moves. Throws Interrupted once `*stop` is set.
PushApartResult push_apart(std::vector<PlacedBall>& balls, const geometry::AnyShape& shape,
                           const Domain& domain, double gap, std::int64_t most,
                           const std::atomic<bool>* stop = nullptr);

}  // namespace mahlwerk::cases
