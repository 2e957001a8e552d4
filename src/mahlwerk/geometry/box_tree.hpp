// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::geometry {

/// Bounding volume hierarchy of axis-aligned boxes, for queries near a point. A node is identified
/// by its number, a leaf by ~number; the caller defines what a leaf is.
class BoxTree {
 public:
  using Four = float __attribute__((vector_size(16)));  // x, y, z, unused

  /// A query point, and the bound on float rounding of its coordinates and of a box's borders.
  struct Probe {
    Four position, slack;
  };
  /// A box in floats, rounded outwards: half the memory of doubles, and never too small.
  struct Box {
    Four low, high;

    void add(const Vec3& p);
    void add(const Box& other);
    static Box empty();
    /// Lower bound of the squared distance from a point [m2], close to it; 0 inside.
    double distance2(const Probe& p) const {
      const Four below = low - p.position, above = p.position - high;
      const Four out = (below > above ? below : above) - p.slack;
      const Four way = out > 0 ? out : Four{};
      const Four squares = way * way;
      constexpr double rounding = 1 - 1e-6;  // of three squares and their sum
      return rounding * (squares[0] + squares[1] + squares[2]);
    }
  };
  struct Item {
    std::int32_t id;  ///< ~leaf, or a node built before
    Box box;
  };

  /// Builds a tree of all items and returns its root, or the item itself if there is only one.
  /// Reorders `items`.
  Item build(std::span<Item> items);

  /// Calls `visit(leaf, within2)` for the leaves nearer to `p` than the square root of `within2`
  /// [m2], nearer boxes first. `visit` may reduce `within2`. `root` is the node to begin with.
  template <class Visit>
  void near(std::int32_t root, const Vec3& p, double& within2, Visit visit) const {
    struct StackEntry {
      std::int32_t id;
      double distance2;
    };
    // One waiting node per level, in a tree of at most 2^31 leaves.
    std::array<StackEntry, 64> stack;
    std::size_t count = 0;
    const Probe probe = probe_at(p);
    for (std::int32_t id = root;;) {
      if (id < 0) {
        visit(~id, within2);
      } else {
        const Node& node = nodes_[static_cast<std::size_t>(id)];
        StackEntry a{node.child[0], node.box[0].distance2(probe)};
        StackEntry b{node.child[1], node.box[1].distance2(probe)};
        if (b.distance2 < a.distance2) std::swap(a, b);
        if (b.distance2 < within2) stack[count++] = b;
        if (a.distance2 < within2) {
          id = a.id;
          continue;
        }
      }
      while (count > 0 && !(stack[count - 1].distance2 < within2)) --count;
      if (count == 0) return;
      id = stack[--count].id;
    }
  }

 private:
  struct Node {
    std::array<Box, 2> box;
    std::array<std::int32_t, 2> child;
  };
  Probe probe_at(const Vec3& p) const {
    const Four position{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    const auto far =
        static_cast<float>(3e-7 * std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z), widest_}));
    return {position, Four{far, far, far, far}};
  }

  std::vector<Node> nodes_;
  double widest_ = 0;  // [m] largest of all coordinates
};

}  // namespace mahlwerk::geometry
