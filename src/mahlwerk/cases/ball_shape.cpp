// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/ball_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::cases {

namespace {

using Kind = BallShape::Kind;

scene::Solid rounded(const BallShape& s) {
  if (s.kind == Kind::rod) return scene::rounded_rod(s.diameter, s.length);
  if (s.kind == Kind::cube) return scene::rounded_cube(s.edge, s.rounding);
  return scene::rounded_cylinder(s.diameter, s.length, s.rounding);
}

/// The spheres within the solid.
scene::Solid inscribed(const BallShape& s) {
  if (s.is_convex()) return rounded(s);
  const int count = static_cast<int>(s.spheres);
  switch (s.kind) {
    case Kind::cylpebs:
      return scene::cylinder_of_spheres(s.diameter, s.length, count);
    case Kind::rod:
      return scene::rod_of_spheres(s.diameter, s.length, count);
    case Kind::cube:
      return scene::cube_of_spheres(s.edge, s.rounding, count);
    case Kind::ellipsoid:
      return scene::ellipsoid_of_spheres(s.diameter, s.length, count);
    default:
      return {};
  }
}

/// [1] The scale at which the spheres of a solid have its volume.
double scale_of(const scene::Solid& solid) {
  constexpr int columns = 100;  // the volume to 1e-3
  const double volume =
      geometry::union_moments(solid.spheres, columns, geometry::Hollows::filled).volume;
  return math::cbrt(solid.volume / volume);
}

}  // namespace

scene::SolidKind BallShape::solid_kind() const {
  switch (kind) {
    case Kind::cylpebs:
      return scene::SolidKind::cylinder;
    case Kind::rod:
      return scene::SolidKind::rod;
    case Kind::cube:
      return scene::SolidKind::cube;
    case Kind::ellipsoid:
      return scene::SolidKind::ellipsoid;
    default:
      return scene::SolidKind::none;
  }
}

scene::Solid BallShape::solid() const {
  if (kind == Kind::clump) return scene::clump(members);
  scene::Solid made = inscribed(*this);
  const double scale = scale_of(made);
  for (geometry::MemberSphere& s : made.spheres) s = {scale * s.centre, scale * s.radius};
  return made;
}

double BallShape::scale() const {
  return kind == Kind::clump ? 1 : scale_of(inscribed(*this));
}

std::int64_t BallShape::usual_spheres() const {
  switch (kind) {
    case Kind::cylpebs:
      return scene::usual_spheres_of_cylinder(diameter, length);
    case Kind::rod:
      return scene::usual_spheres_of_rod(diameter, length);
    case Kind::cube:
      return scene::usual_spheres_of_cube(edge, rounding);
    case Kind::ellipsoid:
      return scene::usual_spheres_of_ellipsoid(diameter, length);
    default:
      return 1;
  }
}

std::int64_t BallShape::fewest_spheres() const {
  constexpr std::int64_t of_a_cube = 9, of_a_row = 2;
  if (kind == Kind::cylpebs) return scene::fewest_in_cylinder(diameter, length);
  return kind == Kind::cube ? of_a_cube : of_a_row;
}

std::string flaw_of_members(const std::vector<geometry::MemberSphere>& members) {
  constexpr double widest = 100;  // finer members would decide the time step alone
  if (members.size() < 2) return "a clump has at least two members";
  if (members.size() > most_members)
    return fmt::format("a clump has at most {} members", most_members);
  const auto [least, most] = std::ranges::minmax(members, {}, &geometry::MemberSphere::radius);
  if (!(least.radius > 0)) return "a radius is not above 0";
  if (most.radius > widest * least.radius)
    return fmt::format("the largest member is more than {} times as wide as the smallest", widest);
  // Members that overlap the first one, directly or by others.
  std::vector<std::size_t> reached{0};
  std::vector<bool> seen(members.size());
  seen[0] = true;
  for (std::size_t next = 0; next < reached.size(); ++next)
    for (std::size_t k = 0; k < members.size(); ++k) {
      const geometry::MemberSphere &a = members[reached[next]], &b = members[k];
      if (seen[k] || !(norm(a.centre - b.centre) < a.radius + b.radius)) continue;
      seen[k] = true, reached.push_back(k);
    }
  const auto apart = std::ranges::find(seen, false);
  if (apart == seen.end()) return "";
  return fmt::format("member {} does not overlap those before it, nor by others between",
                     apart - seen.begin() + 1);
}

const std::vector<std::string>& body_words() {
  static const std::vector<std::string> words{"sphere", "cylpebs",   "rod",
                                              "cube",   "ellipsoid", "clump"};
  return words;
}

const std::vector<std::string>& surface_words() {
  static const std::vector<std::string> words{"spheres", "convex"};
  return words;
}

}  // namespace mahlwerk::cases
