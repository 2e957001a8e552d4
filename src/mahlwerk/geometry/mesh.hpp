// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>

#include "mahlwerk/geometry/crease_angle.hpp"
#include "mahlwerk/geometry/near_facets.hpp"
#include "mahlwerk/geometry/shape.hpp"
#include "mahlwerk/geometry/surface.hpp"

namespace mahlwerk::geometry {

class MeshWall;

/// The inside of a closed surface of triangles. Copies share the surface. Unlike the analytic
/// shapes it has as many faces as its creases make, and it is not convex: a face may be hidden
/// behind another. Therefore gap() refers to the point where a ball can touch a face, distances()
/// to the nearest point of the face.
struct Mesh {
  double crease_angle = 0;  // [rad]
  int faces = 0;

  static constexpr std::string_view name = "mesh";
  static constexpr std::string_view about =
      "the inside of a closed surface of triangles from a file";
  static constexpr bool axisymmetric = false;
  static std::string face_name(int face) { return std::to_string(face + 1); }
  static constexpr auto fields() { return std::array{crease_angle_field<Mesh>()}; }

  Mesh() = default;
  /// `surface` must be without a flaw (flaw_of()); `crease_angle` [rad].
  Mesh(Surface surface, double crease_angle);

  Gap gap(int face, const Vec3& p) const { return gap(face, p, never); }
  /// As above, but a face farther than `within` [m] may be reported as still farther (geo.10).
  Gap gap(int face, const Vec3& p, double within) const;
  /// The same, faster for a ball whose last query has left `near`.
  Gap gap(int face, const Vec3& p, double within, NearFacets& near) const;
  void distances(const Vec3& p, double within, std::span<double> out) const;
  double distance(int face, const Vec3& p, double within) const;
  /// Calls `f(face, gap)` for the faces that a ball at `p` may touch within `within` [m]. Outside
  /// the jar, calls it only for the face that the ball has passed, with a negative distance.
  template <class F>
  void near(const Vec3& p, double within, F f) const;

  Vec3 normal_rate(int, const Vec3&, const Vec3&) const { return {}; }  // facets are flat
  double time_to_curvature_jump(int, const Vec3&, const Vec3&) const { return never; }
  /// Safe time for the whole wall, and so for each face.
  SafeTime safe_time(int face, const SafeTimeQuery& query, double radius) const;
  static constexpr bool whole_wall_safe_time = true;
  bool can_touch(int, double) const { return true; }

  double volume() const;
  double reach() const;
  double inradius() const;            // [m] of the largest ball found
  Vec3 middle() const;                // its centre
  Extent extent() const;              // [m]
  double radius_about_axis() const;   // [m] largest distance from the z axis
  double min_concave_radius() const;  // [m] (geo.12)
  const Surface& surface() const;     // empty for a mesh without one
  bool operator==(const Mesh& o) const;
  /// Null for a mesh without a surface.
  const MeshWall* wall() const { return wall_.get(); }

 private:
  struct NearestFace {
    int face;
    Gap gap;
  };
  double distance_bound(const Vec3& p) const;
  NearestFace nearest(const Vec3& p) const;

  std::shared_ptr<const MeshWall> wall_;
};

template <class F>
void Mesh::near(const Vec3& p, double within, F f) const {
  if (distance_bound(p) > within) return;
  const NearestFace first = nearest(p);
  if (first.gap.distance < 0) {
    f(first.face, first.gap);
    return;
  }
  if (first.gap.distance > within) return;
  for (int face = 0; face < faces; ++face)
    if (const Gap seen = gap(face, p, within); seen.distance <= within) f(face, seen);
}

}  // namespace mahlwerk::geometry
