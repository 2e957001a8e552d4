// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace mahlwerk::results {

/// One number of a collision record: its name in files, its unit, its description and its offset in
/// scene::Collision.
struct CollisionColumn {
  const char *name, *unit, *about;
  std::size_t offset;
  bool whole = false;  ///< a 32-bit integer instead of a double
};

/// All numbers of a record, in the order of scene::Collision.
std::span<const CollisionColumn> collision_columns();

}  // namespace mahlwerk::results
