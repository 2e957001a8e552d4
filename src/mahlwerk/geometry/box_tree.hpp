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

/// Boxes within boxes, for questions that only concern what is near a point. A node has a number; a
/// leaf is told by ~number, and is what the caller says it is.
class BoxTree {
 public:
  using Four = float __attribute__((vector_size(16)));  // x, y, z and nothing

  /// A point, and what floats may have made of it and of a box's borders.
  struct Probe {
    Four position, slack;
  };
  /// Floats, rounded outwards: half the memory, and never too small.
  struct Box {
    Four low, high;

    void add(const Vec3& p);
    void add(const Box& other);
    static Box empty();
    /// Squared distance from a point [m2], or a little less; 0 inside.
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

  /// A node that holds them all; their order is changed. The item itself if there is only one.
  Item build(std::span<Item> items);

  /// Calls `visit(leaf, within2)` for leaves nearer to `p` than the root of `within2` [m2], which
  /// it may lessen; the nearest boxes first.
  template <class Visit>
  void near(std::int32_t root, const Vec3& p, double& within2, Visit visit) const {
    struct StackEntry {
      std::int32_t id;
      double distance2;
    };
    std::array<StackEntry, 64>
        stack;  // a node waits at each level of a tree of at most 2^31 leaves
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
  double widest_ = 0;  // [m] of all coordinates
};

}  // namespace mahlwerk::geometry
