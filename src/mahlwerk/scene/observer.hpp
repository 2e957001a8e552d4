// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "mahlwerk/scene/collision.hpp"
#include "mahlwerk/scene/flow.hpp"
#include "mahlwerk/scene/grain_breakage.hpp"

namespace mahlwerk::scene {

/// Receives collisions in the order in which they end, in chunks. An observer gets copies and
/// cannot change a trajectory.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void collisions(std::span<const Collision> finished) = 0;
  /// Balls that have left the jar or entered it, in the order in which they did.
  virtual void passages(std::span<const Passage> /*passed*/) {}
  /// Changes of the sizes of a powder whose grains break, in the order in which they happened.
  virtual void size_changes(std::span<const SizeChange> /*changes*/) {}
};

}  // namespace mahlwerk::scene
