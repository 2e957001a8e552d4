// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/scene/body_core.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace mahlwerk::scene {
namespace {

// An edge begins where the normal is as far from that of the face as from the bisector of the edge.
constexpr double tan_of_border = std::numbers::sqrt2 - 1;  // of 22.5 degrees

double from_axis(const Vec3& p) {
  return std::sqrt(p.x * p.x + p.y * p.y);
}
double beyond(double coordinate, double half) {
  return std::max(0.0, std::abs(coordinate) - half);
}

}  // namespace

std::string_view name_of(BodyFeature feature) {
  constexpr std::array<std::string_view, 6> names{"none", "face", "edge", "corner", "side", "cap"};
  return names[static_cast<std::size_t>(feature)];
}

BodyCore::BodyCore(const BodyShape& shape) : kind_(shape.solid) {
  if (shape.is_rounded()) {
    radius_ = shape.core.radius, half_length_ = shape.core.half_length;
    for (const Vec3& corner : shape.core.corners)
      half_length_ = std::max(half_length_, std::abs(corner.z));
    return;
  }
  for (const geometry::MemberSphere& s : shape.spheres) {
    radius_ = std::max(radius_, from_axis(s.centre));
    half_length_ = std::max(half_length_, std::abs(s.centre.z));
  }
}

bool has_feature(SolidKind kind, BodyFeature feature) {
  switch (kind) {
    case SolidKind::cylinder:
      return feature == BodyFeature::face || feature == BodyFeature::edge ||
             feature == BodyFeature::side;
    case SolidKind::rod:
      return feature == BodyFeature::side || feature == BodyFeature::cap;
    case SolidKind::cube:
      return feature == BodyFeature::face || feature == BodyFeature::edge ||
             feature == BodyFeature::corner;
    default:
      return false;
  }
}

BodyFeature BodyCore::feature_at(const Vec3& point) const {
  switch (kind_) {
    case SolidKind::cylinder:
      return of_cylinder(point);
    case SolidKind::rod:
      return of_rod(point);
    case SolidKind::cube:
      return of_cube(point);
    default:
      return BodyFeature::none;
  }
}

BodyFeature BodyCore::of_cylinder(const Vec3& p) const {
  const double outward = beyond(from_axis(p), radius_), along = beyond(p.z, half_length_);
  if (outward == 0 && along == 0)  // within the core, where two bodies overlap deeply
    return from_axis(p) - radius_ > std::abs(p.z) - half_length_ ? BodyFeature::side
                                                                 : BodyFeature::face;
  if (outward <= tan_of_border * along) return BodyFeature::face;
  return along <= tan_of_border * outward ? BodyFeature::side : BodyFeature::edge;
}

BodyFeature BodyCore::of_rod(const Vec3& p) const {
  return beyond(p.z, half_length_) <= tan_of_border * from_axis(p) ? BodyFeature::side
                                                                   : BodyFeature::cap;
}

BodyFeature BodyCore::of_cube(const Vec3& p) const {
  std::array<double, 3> n{beyond(p.x, half_length_), beyond(p.y, half_length_),
                          beyond(p.z, half_length_)};
  std::ranges::sort(n, std::greater());
  // The largest component of the normal along that of a face, the bisector of an edge, the diagonal
  // of a corner.
  const double face = n[0], edge = (n[0] + n[1]) / std::numbers::sqrt2,
               corner = (n[0] + n[1] + n[2]) / std::numbers::sqrt3;
  if (face >= edge && face >= corner) return BodyFeature::face;
  return edge >= corner ? BodyFeature::edge : BodyFeature::corner;
}

}  // namespace mahlwerk::scene
