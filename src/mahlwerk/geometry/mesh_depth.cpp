// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "mahlwerk/geometry/mesh_wall.hpp"

// Depth of a mesh: a lower bound of the wall distance for each cell, and the largest ball inside.
namespace mahlwerk::geometry {
namespace {

struct DepthSample {
  Vec3 position;
  double depth;  // [m]
};

/// Depth at points near the present position of the climb. In the middle of a round jar all of the
/// wall is about equally near, and a search for the nearest facet would be very slow. Therefore
/// only the facets are kept that may be the nearest around that position, and most points need only
/// the information that some facet is near.
class LocalDepth {
 public:
  LocalDepth(const MeshWall& wall, std::span<const std::int32_t> all) : wall_(wall), all_(all) {}

  /// Prepares for queries at most `reach` [m] from `p`.
  void move_to(const Vec3& p, double reach) {
    const double enlarged = 4 * reach, off = norm(p - centre_);
    const bool inside = off + reach <= within_;
    if (inside && within_ <= 4 * enlarged) return;
    near_ = wall_.nearest_around(p, enlarged, off + enlarged <= within_ ? near_ : all_);
    centre_ = p;
    within_ = enlarged;
  }
  double operator()(const Vec3& p, double beyond) const {
    return wall_.depth_beyond(beyond, p, near_);
  }

 private:
  const MeshWall& wall_;
  std::span<const std::int32_t> all_;
  std::vector<std::int32_t> near_;
  Vec3 centre_;
  double within_ = -1;  // [m] from centre_; < 0: none yet
};

/// Pattern search for the nearest maximum of the depth: steps in the best of 26 directions as long
/// as one increases the depth, then halves the step, down to `least` [m].
DepthSample hill_climb(DepthSample from, double step, double least, LocalDepth depth) {
  while (step > least) {
    depth.move_to(from.position, 1.8 * step);  // sqrt(3) step, and rounding
    DepthSample best = from;
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) {
          const Vec3 p = from.position + step * Vec3{1.0 * x, 1.0 * y, 1.0 * z};
          if (const double d = depth(p, best.depth); d > best.depth) best = {p, d};
        }
    if (best.depth > from.depth)
      from = best;
    else
      step *= 0.5;
  }
  return from;
}

}  // namespace

/// Samples the depth at cell centres. A distance changes by no more than the point moves, so one
/// sample gives a bound for a whole cell.
void MeshWall::sample_depth() {
  constexpr int cells = MeshView::cells;
  const Vec3 cell = extent_.size() / cells;
  const double half = 0.5 * norm(cell) * (1 + 1e-6);  // and float rounding
  std::vector<std::int32_t> all(facets_.facets.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<float> found;
  std::vector<DepthSample> deep;
  for (int x = 0; x < cells; ++x)
    for (int y = 0; y < cells; ++y)
      for (int z = 0; z < cells; ++z) {
        const Vec3 p =
            extent_.low + Vec3{(x + 0.5) * cell.x, (y + 0.5) * cell.y, (z + 0.5) * cell.z};
        const double d = nearest(p).gap.distance;
        found.push_back(static_cast<float>(std::max(0.0, (d - half) * (1 - 1e-6))));
        deep.push_back({p, d});
      }
  distance_bounds_ = std::move(found);
  constexpr std::size_t tried = 4;
  std::ranges::partial_sort(deep, deep.begin() + tried, std::ranges::greater{},
                            &DepthSample::depth);
  DepthSample best = deep[0];
  for (std::size_t i = 0; i < tried; ++i) {
    if (deep[i].depth + half < best.depth) break;  // its cell has no deeper point
    const DepthSample peak = hill_climb(deep[i], half, 1e-9 * reach_, LocalDepth(*this, all));
    if (peak.depth > best.depth) best = peak;
  }
  inradius_ = std::max(0.0, best.depth);
  largest_ball_centre_ = best.position;
}

}  // namespace mahlwerk::geometry
