// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/nips.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <variant>

#include "mahlwerk/cases/wear_heat.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/observe/collision_batch.hpp"
#include "mahlwerk/results/quantities/jar_surface.hpp"
#include "mahlwerk/results/quantities/pairs.hpp"
#include "mahlwerk/results/quantities/wall.hpp"

namespace mahlwerk::results {
namespace {

/// A patch of the wall: its face and its symmetric curvature matrix over two tangents [1/m],
/// concave > 0.
struct WallPatch {
  int face = 0;
  double area = 0;  // [m2]
  int cell = 0;     // of WallGrid
  double one = 0, both = 0, other = 0;

  /// [m] Geometric mean of both effective radii (cap.3); 0 where a ball of this radius does not
  /// fit.
  double effective_radius(double radius) const {
    const double a = 1 / radius - one, b = 1 / radius - other, det = a * b - both * both;
    return a > 0 && det > 0 ? 1 / std::sqrt(det) : 0;
  }
};

/// The patch of wall nearest to `near`.
template <class Shape>
WallPatch wall_patch(const Shape& shape, const Vec3& near, double area,
                     const observe::WallGrid& grid) {
  WallPatch patch;
  geometry::Gap gap{.distance = std::numeric_limits<double>::infinity(), .inward = {}};
  for (int face = 0; face < shape.faces; ++face)
    if (const geometry::Gap one = shape.gap(face, near);
        std::abs(one.distance) < std::abs(gap.distance)) {
      gap = one;
      patch.face = face;
    }
  const Vec3 at = near - gap.inward * gap.distance;
  const Vec3 away = std::abs(gap.inward.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 across = cross(gap.inward, away);
  const Vec3 t = across / norm(across), u = cross(gap.inward, t);
  const auto bends = [&](const Vec3& along, const Vec3& of) {
    return -dot(of, shape.normal_rate(patch.face, at, along));
  };
  patch.area = area;
  patch.cell = observe::cell_of(grid, at, -gap.inward.z);
  patch.one = bends(t, t);
  patch.both = bends(t, u);
  patch.other = bends(u, u);
  return patch;
}

/// Calls `visit(middle, area)` for pieces of a triangle with areas of at most `most` [m2].
template <class Visit>
void subdivide(const Vec3& a, const Vec3& b, const Vec3& c, double most, const Visit& visit) {
  const double area = 0.5 * norm(cross(b - a, c - a));
  if (!(area > most)) return visit((a + b + c) / 3, area);
  const double ab = norm(b - a), bc = norm(c - b), ca = norm(a - c);
  // Bisects the longest side, which is rotated to the first place.
  if (bc > ab && bc >= ca) return subdivide(b, c, a, most, visit);
  if (ca > ab) return subdivide(c, a, b, most, visit);
  subdivide(a, (a + b) / 2, c, most, visit);
  subdivide((a + b) / 2, b, c, most, visit);
}

/// Splits the wall into some thousand patches, about as fine as the cells of its map.
std::vector<WallPatch> wall_patches(const geometry::AnyShape& shape,
                                    const observe::WallGrid& grid) {
  constexpr std::uint32_t facets = 32;
  constexpr double pieces = 4000;
  const double most = wall_area(shape) / pieces;
  std::vector<WallPatch> patches;
  const auto add = [&](const Vec3& middle, double area) {
    std::visit(
        [&](const auto& s) {
          if (s.faces > 0) patches.push_back(wall_patch(s, middle, area, grid));
        },
        shape);
  };
  for (const JarMesh& mesh : jar_surface(shape, facets))
    for (const auto& [a, b, c] : mesh.triangles)
      subdivide(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], most, add);
  return patches;
}

/// [m] Mean effective radius over the patches of a face, weighted by the power of hits on them; by
/// area alone if there are no hits (cap.4).
double mean_radius(const std::vector<WallPatch>& patches, int face, double radius,
                   const observe::WallMap& hits, const std::vector<double>& areas) {
  double hit = 0, hit_weight = 0, plain = 0, plain_weight = 0;
  for (const WallPatch& patch : patches) {
    if (face >= 0 && patch.face != face) continue;
    const double effective = patch.effective_radius(radius);
    if (!(effective > 0)) continue;
    const double in_cell = areas[static_cast<std::size_t>(patch.cell)];
    const double weight = in_cell > 0 ? patch.area * hits[patch.cell].energy_normal / in_cell : 0;
    hit += weight * effective;
    hit_weight += weight;
    plain += patch.area * effective;
    plain_weight += patch.area;
  }
  if (hit_weight > 0) return hit / hit_weight;
  return plain_weight > 0 ? plain / plain_weight : radius;
}

}  // namespace

double effective_radius(const geometry::AnyShape& shape, int face, double radius,
                        const observe::WallMap& hits) {
  return mean_radius(wall_patches(shape, hits.grid()), face, radius, hits,
                     wall_areas(shape, hits.grid()));
}

std::vector<powder::Nip> nips(const cases::Case& mill_case,
                              const observe::CollisionStatistics& tally) {
  const observe::WallMap& hits = tally.wall_map;
  const std::vector<WallPatch> patches = wall_patches(*mill_case.jar.shape, hits.grid());
  const std::vector<double> areas = wall_areas(*mill_case.jar.shape, hits.grid());
  const observe::StatisticsByPair& pairs = tally.by_pair;
  std::vector<powder::Nip> found;
  for (int pair = 0; pair < pairs.pairs(); ++pair) {
    const auto kinds = pairs.kinds_of(pair);
    const auto one = static_cast<std::size_t>(kinds.one);
    powder::Nip nip;
    if (kinds.with_jar() && !mill_case.balls[one].grains) {
      // With one face in the statistics, it stands for all faces of the jar.
      const int face = distinguished_jar_faces(mill_case, pairs) == 1 ? -1 : kinds.face();
      const double radius = 0.5 * mill_case.balls[one].diameter;
      nip.radius = part_of(mill_case, pairs, kinds.face()) != nullptr
                       ? radius  // parts count as flat
                       : mean_radius(patches, face, radius, hits, areas);
      nip.modulus = cases::flash_pair_with_jar(mill_case, one).modulus;
    } else if (!kinds.with_jar() && !mill_case.balls[one].grains &&
               !mill_case.balls[static_cast<std::size_t>(kinds.other)].grains) {
      const powder::FlashPair flash =
          cases::flash_pair(mill_case, one, static_cast<std::size_t>(kinds.other));
      nip = {flash.radius, flash.modulus};
    }
    found.push_back(nip);
  }
  return found;
}

}  // namespace mahlwerk::results
