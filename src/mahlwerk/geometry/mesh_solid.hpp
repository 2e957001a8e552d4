// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>

#include "mahlwerk/geometry/crease_angle.hpp"
#include "mahlwerk/geometry/shape.hpp"
#include "mahlwerk/geometry/surface.hpp"

namespace mahlwerk::geometry {

class MeshWall;

/// A body given by triangles, seen from outside. An open surface is a sheet without thickness that
/// balls touch from both sides; closed surfaces may be several, and cavities in them. Copies share
/// the triangles. Its faces are those that its creases make (geo.9).
struct MeshSolid {
  double crease_angle = 0;  // [rad]
  int faces = 0;

  static constexpr std::string_view name = "mesh";
  static constexpr std::string_view about =
      "triangles from a file, of solids or of sheets without thickness";
  static constexpr auto fields() { return std::array{crease_angle_field<MeshSolid>()}; }

  MeshSolid() = default;
  /// `surface` must be without a flaw (flaw_of_part()); `crease_angle` [rad].
  MeshSolid(Surface surface, double crease_angle);

  /// As Mesh::gap(); positive on both sides of a sheet.
  Gap gap(int face, const Vec3& p, double within) const;
  /// Distance of the face [m], never negative; `not_near` beyond `within` [m].
  double distance(int face, const Vec3& p, double within) const;
  /// Distance of the whole body [m], negative in a solid; never so for a sheet.
  double clearance(const Vec3& p) const;
  /// The nearest point of the whole body, for points in a solid, too: there its distance is
  /// negative, and its normal the way out.
  Gap nearest(const Vec3& p) const;
  Vec3 normal_rate(int, const Vec3&, const Vec3&) const { return {}; }  // facets are flat
  double reach() const { return reach_; }
  bool is_sheet() const { return sheet_; }              ///< the surface is open
  bool is_flat() const { return flat_; }                ///< all its points are in one plane
  const Surface& surface() const { return *surface_; }  ///< as read, normals outwards
  bool operator==(const MeshSolid& o) const;

 private:
  std::shared_ptr<const Surface> surface_ = std::make_shared<const Surface>();
  std::shared_ptr<const MeshWall> wall_;
  double reach_ = 0;
  bool sheet_ = false;
  bool flat_ = false;
};

/// Why triangles are neither solids nor sheets: more than two meet at an edge, or neighbours
/// disagree which side is outside. None if they are.
std::optional<Flaw> flaw_of_part(const Surface& surface);

}  // namespace mahlwerk::geometry
