// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/nips.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <variant>

#include "mahlwerk/cases/wear_heat.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/observe/columns.hpp"
#include "mahlwerk/results/quantities/jar_surface.hpp"
#include "mahlwerk/results/quantities/wall.hpp"

namespace mahlwerk::results {
namespace {

/// A bit of the wall: its face, its curvature as a matrix over two tangents [1/m], concave > 0.
struct WallBit {
  int face = 0;
  double area = 0;  // [m2]
  int cell = 0;     // of the map
  double one = 0, both = 0, other = 0;

  /// [m] Geometric mean of both effective radii (cap.3); 0 where a ball so large does not touch.
  double effective_radius(double radius) const {
    const double a = 1 / radius - one, b = 1 / radius - other, det = a * b - both * both;
    return a > 0 && det > 0 ? 1 / std::sqrt(det) : 0;
  }
};

/// The bit of wall nearest to `near`.
template <class Shape>
WallBit wall_bit(const Shape& shape, const Vec3& near, double area, const observe::WallGrid& grid) {
  WallBit bit;
  geometry::Gap gap{.distance = std::numeric_limits<double>::infinity(), .inward = {}};
  for (int face = 0; face < shape.faces; ++face)
    if (const geometry::Gap one = shape.gap(face, near);
        std::abs(one.distance) < std::abs(gap.distance)) {
      gap = one;
      bit.face = face;
    }
  const Vec3 at = near - gap.inward * gap.distance;
  const Vec3 away = std::abs(gap.inward.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 across = cross(gap.inward, away);
  const Vec3 t = across / norm(across), u = cross(gap.inward, t);
  const auto bends = [&](const Vec3& along, const Vec3& of) {
    return -dot(of, shape.normal_rate(bit.face, at, along));
  };
  bit.area = area;
  bit.cell = observe::cell_of(grid, at, -gap.inward.z);
  bit.one = bends(t, t);
  bit.both = bends(t, u);
  bit.other = bends(u, u);
  return bit;
}

/// Calls `visit(middle, area)` for pieces of a triangle that are no larger than `most` [m2].
template <class Visit>
void in_pieces(const Vec3& a, const Vec3& b, const Vec3& c, double most, const Visit& visit) {
  const double area = 0.5 * norm(cross(b - a, c - a));
  if (!(area > most)) return visit((a + b + c) / 3, area);
  const double ab = norm(b - a), bc = norm(c - b), ca = norm(a - c);
  // Halved at its longest side, which comes first.
  if (bc > ab && bc >= ca) return in_pieces(b, c, a, most, visit);
  if (ca > ab) return in_pieces(c, a, b, most, visit);
  in_pieces(a, (a + b) / 2, c, most, visit);
  in_pieces((a + b) / 2, b, c, most, visit);
}

/// The wall in some thousand bits, as fine as the cells of its map.
std::vector<WallBit> wall_bits(const geometry::AnyShape& shape, const observe::WallGrid& grid) {
  constexpr std::uint32_t facets = 32;
  constexpr double pieces = 4000;
  const double most = wall_area(shape) / pieces;
  std::vector<WallBit> bits;
  const auto add = [&](const Vec3& middle, double area) {
    std::visit(
        [&](const auto& s) {
          if (s.faces > 0) bits.push_back(wall_bit(s, middle, area, grid));
        },
        shape);
  };
  for (const JarMesh& mesh : jar_surface(shape, facets))
    for (const auto& [a, b, c] : mesh.triangles)
      in_pieces(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], most, add);
  return bits;
}

/// [m] Mean over the bits of a face, each by its area and the power of the hits around it.
double mean_radius(const std::vector<WallBit>& bits, int face, double radius,
                   const observe::WallMap& hits, const std::vector<double>& areas) {
  double hit = 0, hit_weight = 0, plain = 0, plain_weight = 0;
  for (const WallBit& bit : bits) {
    if (face >= 0 && bit.face != face) continue;
    const double effective = bit.effective_radius(radius);
    if (!(effective > 0)) continue;
    const double in_cell = areas[static_cast<std::size_t>(bit.cell)];
    const double weight = in_cell > 0 ? bit.area * hits[bit.cell].energy_normal / in_cell : 0;
    hit += weight * effective;
    hit_weight += weight;
    plain += bit.area * effective;
    plain_weight += bit.area;
  }
  if (hit_weight > 0) return hit / hit_weight;
  return plain_weight > 0 ? plain / plain_weight : radius;
}

}  // namespace

double effective_radius(const geometry::AnyShape& shape, int face, double radius,
                        const observe::WallMap& hits) {
  return mean_radius(wall_bits(shape, hits.grid()), face, radius, hits,
                     wall_areas(shape, hits.grid()));
}

std::vector<powder::Nip> nips(const cases::Case& what, const observe::Tally& tally) {
  const observe::WallMap& hits = tally.wall_map;
  const std::vector<WallBit> bits = wall_bits(*what.jar.shape, hits.grid());
  const std::vector<double> areas = wall_areas(*what.jar.shape, hits.grid());
  const observe::ByPair& pairs = tally.by_pair;
  std::vector<powder::Nip> found;
  for (int pair = 0; pair < pairs.pairs(); ++pair) {
    const auto kinds = pairs.kinds_of(pair);
    const auto one = static_cast<std::size_t>(kinds.one);
    powder::Nip nip;
    if (kinds.with_jar() && !what.balls[one].grains) {
      // Faces beyond those that are told apart are all in the last.
      const int face = pairs.faces() == 1 ? -1 : kinds.face();
      nip.radius = mean_radius(bits, face, 0.5 * what.balls[one].diameter, hits, areas);
      nip.modulus = cases::flash_pair_with_jar(what, one).modulus;
    } else if (!kinds.with_jar() && !what.balls[one].grains &&
               !what.balls[static_cast<std::size_t>(kinds.other)].grains) {
      const powder::FlashPair flash =
          cases::flash_pair(what, one, static_cast<std::size_t>(kinds.other));
      nip = {flash.radius, flash.modulus};
    }
    found.push_back(nip);
  }
  return found;
}

}  // namespace mahlwerk::results
