// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::geometry {

/// Boxes within boxes, for questions that only concern what is near a point. A node has a number; a
/// leaf is told by ~number, and is what the caller says it is.
class BoxTree {
 public:
  /// Floats, rounded outwards: half the memory, and never too small.
  struct Box {
    std::array<float, 3> low, high;

    void add(const Vec3& p);
    void add(const Box& other);
    static Box empty();
    /// Squared distance from a point [m2], 0 inside.
    double distance2(const Vec3& p) const {
      const double x = std::max({low[0] - p.x, p.x - high[0], 0.0});
      const double y = std::max({low[1] - p.y, p.y - high[1], 0.0});
      const double z = std::max({low[2] - p.z, p.z - high[2], 0.0});
      return x * x + y * y + z * z;
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
    struct Waiting {
      std::int32_t id;
      double distance2;
    };
    std::array<Waiting, 64> stack;  // a node waits at each level of a tree of at most 2^31 leaves
    std::size_t count = 0;
    for (std::int32_t id = root;;) {
      if (id < 0) {
        visit(~id, within2);
      } else {
        const Node& node = nodes_[static_cast<std::size_t>(id)];
        Waiting a{node.child[0], node.box[0].distance2(p)};
        Waiting b{node.child[1], node.box[1].distance2(p)};
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
  std::vector<Node> nodes_;
};

}  // namespace mahlwerk::geometry
