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

struct BoxSearch;

/// Bounding volume hierarchy for queries near a point. A node is identified by its number, a leaf
/// by ~number; the caller defines what a leaf is. Boxes lie along the coordinate axes until
/// orient() lays them along the surface.
class BoxTree {
 public:
  using Four = float __attribute__((vector_size(16)));  // x, y, z, unused

  /// A query point, and the bound on float rounding of its coordinates and of a box's borders.
  struct Probe {
    Four x, y, z;  // each coordinate of the point, repeated
    Four slack;
  };
  /// A box in floats, rounded outwards: half the memory of doubles, and never too small. `axes`
  /// are the columns of the matrix that takes a point to the coordinates of the box.
  struct Box {
    std::array<Four, 3> axes{Four{1, 0, 0, 0}, Four{0, 1, 0, 0}, Four{0, 0, 1, 0}};
    Four low, high;

    void add(const Vec3& p);
    void add(const Box& other);  ///< of the same axes
    static Box empty();
    /// Lower bound of the squared distance from a point [m2], close to it; 0 inside.
    double distance2(const Probe& p) const {
      const Four at = axes[0] * p.x + axes[1] * p.y + axes[2] * p.z;
      const Four below = low - at, above = at - high;
      const Four out = (below > above ? below : above) - p.slack;
      const Four way = out > 0 ? out : Four{};
      const Four squares = way * way;
      constexpr double rounding = 1 - 3e-6;  // of the axes, of three squares and their sum
      return rounding * (squares[0] + squares[1] + squares[2]);
    }
    /// Upper bound of the squared distance of a point from the farthest point in the box [m2].
    double farthest2(const Probe& p) const {
      const Four at = axes[0] * p.x + axes[1] * p.y + axes[2] * p.z;
      const Four below = at - low, above = high - at;
      const Four way = (below > above ? below : above) + p.slack;
      const Four squares = way * way;
      constexpr double rounding = 1 + 3e-6;
      return rounding * (squares[0] + squares[1] + squares[2]);
    }
  };
  struct Item {
    std::int32_t id;  ///< ~leaf, or a node built before
    Box box;
  };
  /// A flat piece of the surface.
  struct Piece {
    std::array<Vec3, 3> corner;  ///< [m]
    Vec3 area;                   ///< [m2] along its normal
  };

  /// Builds a tree of all items and returns its root, or the item itself if there is only one.
  /// Reorders `items`.
  Item build(std::span<Item> items);

  /// Lays the boxes of the tree at `root` along the pieces in them, `piece(leaf)`. A box along the
  /// axes around an inclined piece is as deep as the piece is wide, and a query near the surface
  /// would visit all pieces within the root of that depth; one along the piece has no depth.
  template <class PieceOf>
  void orient(std::int32_t root, PieceOf piece) {
    std::vector<Piece> pieces;
    if (root >= 0) orient(root, piece, pieces);
  }

  /// The boxes as they are stored, for searches.
  struct Node {
    std::array<Box, 2> box;
    std::array<std::int32_t, 2> child;
  };
  /// The tree without memory of its own: `copy(vector)` says where the elements are.
  template <class Copy>
  BoxSearch view(const Copy& copy) const;

 private:
  /// Appends the pieces below a node, and lays its boxes along them.
  template <class PieceOf>
  void orient(std::int32_t id, PieceOf& piece, std::vector<Piece>& pieces) {
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t first = pieces.size();
      const std::int32_t child = nodes_[static_cast<std::size_t>(id)].child[k];
      if (child < 0)
        pieces.push_back(piece(~child));
      else
        orient(child, piece, pieces);
      Box& box = nodes_[static_cast<std::size_t>(id)].box[k];
      box = smaller_around(box, std::span(pieces).subspan(first));
    }
  }
  static Box smaller_around(const Box& along_axes, std::span<const Piece> pieces);

  std::vector<Node> nodes_;
  double widest_ = 0;  // [m] largest of all coordinates
};

/// Searches in a tree, wherever its nodes are.
struct BoxSearch {
  const BoxTree::Node* nodes = nullptr;
  double widest = 0;  ///< [m] largest of all coordinates

  /// Calls `visit(leaf, within2)` for the leaves nearer to `p` than the square root of `within2`
  /// [m2], nearer boxes first. `visit` may reduce `within2`. `root` is the node to begin with.
  template <class Visit>
  void near(std::int32_t root, const Vec3& p, double& within2, Visit visit) const {
    const BoxTree::Probe probe = probe_at(p);
    search(
        root, within2, [&](const BoxTree::Box& box) { return box.distance2(probe); },
        [&](std::int32_t leaf, double, double& most) { visit(leaf, most); });
  }

  /// Calls `visit(leaf, bound, most)` for the leaves whose boxes have a `bound(box)` less than
  /// `most`, the least first; that of a root which is a leaf is 0. `visit` may reduce `most`.
  template <class Bound, class Visit>
  void search(std::int32_t root, double& most, Bound bound, Visit visit) const {
    struct StackEntry {
      std::int32_t id;
      double bound;
    };
    // One waiting node per level, in a tree of at most 2^31 leaves.
    std::array<StackEntry, 64> stack;
    std::size_t count = 0;
    double least = 0;  // bound of the node `id`
    for (std::int32_t id = root;;) {
      if (id < 0) {
        visit(~id, least, most);
      } else {
        const BoxTree::Node& node = nodes[id];
        StackEntry a{node.child[0], bound(node.box[0])};
        StackEntry b{node.child[1], bound(node.box[1])};
        if (b.bound < a.bound) std::swap(a, b);
        if (b.bound < most) stack[count++] = b;
        if (a.bound < most) {
          id = a.id, least = a.bound;
          continue;
        }
      }
      while (count > 0 && !(stack[count - 1].bound < most)) --count;
      if (count == 0) return;
      id = stack[--count].id, least = stack[count].bound;
    }
  }

  BoxTree::Probe probe_at(const Vec3& p) const {
    const auto all = [](double a) {
      const auto x = static_cast<float>(a);
      return BoxTree::Four{x, x, x, x};
    };
    // A coordinate in a box is a sum of three products: six roundings of up to 6e-8 of the norm.
    return {all(p.x), all(p.y), all(p.z),
            all(8e-7 * std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z), widest}))};
  }
};

template <class Copy>
BoxSearch BoxTree::view(const Copy& copy) const {
  return {copy(nodes_), widest_};
}

}  // namespace mahlwerk::geometry
