// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/mesh.hpp"

#include <limits>
#include <utility>

#include "mahlwerk/geometry/mesh_wall.hpp"
#include "mahlwerk/geometry/safe_time.hpp"

namespace mahlwerk::geometry {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();  // of a mesh without surface

}  // namespace

Mesh::Mesh(Surface surface, double angle)
    : crease_angle(angle), wall_(std::make_shared<MeshWall>(std::move(surface), angle)) {
  faces = wall_->faces();
}

Gap Mesh::gap(int face, const Vec3& p, double within) const {
  return wall_->gap(face, p, within);
}
Gap Mesh::gap(int face, const Vec3& p, double within, NearFacets& near) const {
  return wall_->gap(face, p, within, near);
}
void Mesh::distances(const Vec3& p, double within, std::span<double> out) const {
  wall_->distances(p, within, out);
}
double Mesh::distance(int face, const Vec3& p, double within) const {
  return wall_->distance(face, p, within);
}
double Mesh::distance_bound(const Vec3& p) const {
  return wall_->distance_bound(p);
}
Mesh::NearestFace Mesh::nearest(const Vec3& p) const {
  const MeshWall::NearestFace n = wall_->nearest(p);
  return {n.face, n.gap};
}

SafeTime Mesh::safe_time(int, const SafeTimeQuery& c, double radius) const {
  const double gap = wall_->nearest(c.position).gap.distance - radius, speed = norm(c.velocity);
  return {gap, speed, plane_safe_time(gap, speed, c.max_acceleration.total)};
}

double Mesh::volume() const {
  return wall_ ? wall_->volume() : unknown;
}
double Mesh::reach() const {
  return wall_ ? wall_->reach() : unknown;
}
double Mesh::inradius() const {
  return wall_ ? wall_->inradius() : unknown;
}
double Mesh::radius_about_axis() const {
  return wall_ ? wall_->radius_about_axis() : unknown;
}
double Mesh::min_concave_radius() const {
  return wall_ ? wall_->min_concave_radius() : unknown;
}
Vec3 Mesh::middle() const {
  return wall_ ? wall_->largest_ball_centre() : Vec3{};
}
Extent Mesh::extent() const {
  return wall_ ? wall_->extent() : Extent{};
}
const Surface& Mesh::surface() const {
  static const Surface none;
  return wall_ ? wall_->surface() : none;
}
bool Mesh::operator==(const Mesh& o) const {
  if (crease_angle != o.crease_angle || (wall_ == nullptr) != (o.wall_ == nullptr)) return false;
  return wall_ == o.wall_ || wall_->surface() == o.wall_->surface();
}

}  // namespace mahlwerk::geometry
