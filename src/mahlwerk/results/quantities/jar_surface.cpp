// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/jar_surface.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/geometry/solids.hpp"

namespace mahlwerk::results {
namespace {

using Index = std::uint32_t;
Index count(const JarMesh& mesh) {
  return static_cast<Index>(mesh.vertices.size());
}

/// A point of a profile: distance from the axis and height [m].
struct ProfilePoint {
  double rho, z;
};
using Profile = std::vector<ProfilePoint>;

/// Adds a quarter circle about a point, from the angle `from` [rad]: 0 outwards, pi/2 upwards.
void add_quarter(Profile& profile, const ProfilePoint& middle, double radius, double from,
                 Index facets) {
  for (Index i = 0; i <= facets / 4; ++i) {
    const SinCos at = sin_cos(from + 2 * std::numbers::pi * i / facets);
    profile.push_back({middle.rho + radius * at.cos, middle.z + radius * at.sin});
  }
}

/// Adds the surface of revolution of a profile from the lower to the upper end of the axis.
void add_revolved(JarMesh& mesh, const Profile& profile, Index facets) {
  const double tiny = 1e-12 * (profile.back().z - profile.front().z);  // rounding
  Profile rings;
  for (const ProfilePoint& p : profile)
    if (p.rho > tiny && (rings.empty() || std::abs(p.rho - rings.back().rho) > tiny ||
                         std::abs(p.z - rings.back().z) > tiny))
      rings.push_back(p);
  const Index bottom = count(mesh), top = bottom + 1, first = bottom + 2;
  mesh.vertices.push_back({0, 0, profile.front().z});
  mesh.vertices.push_back({0, 0, profile.back().z});
  for (const ProfilePoint& p : rings)
    for (Index k = 0; k < facets; ++k) {
      const SinCos at = sin_cos(2 * std::numbers::pi * k / facets);
      mesh.vertices.push_back({p.rho * at.cos, p.rho * at.sin, p.z});
    }
  const auto last = first + static_cast<Index>(rings.size() - 1) * facets;
  for (Index k = 0; k < facets; ++k) {
    const Index next = (k + 1) % facets;
    mesh.triangles.push_back({bottom, first + next, first + k});
    mesh.triangles.push_back({top, last + k, last + next});
    for (Index ring = first; ring < last; ring += facets) {
      mesh.triangles.push_back({ring + k, ring + next, ring + facets + next});
      mesh.triangles.push_back({ring + k, ring + facets + next, ring + facets + k});
    }
  }
}

/// Adds the side of a cylinder without ends.
void add_tube(JarMesh& mesh, double diameter, double length, Index facets) {
  for (const double z : {-0.5 * length, 0.5 * length})
    for (Index k = 0; k < facets; ++k) {
      const SinCos at = sin_cos(2 * std::numbers::pi * k / facets);
      mesh.vertices.push_back({0.5 * diameter * at.cos, 0.5 * diameter * at.sin, z});
    }
  for (Index k = 0; k < facets; ++k) {
    const Index next = (k + 1) % facets;
    mesh.triangles.push_back({k, next, facets + next});
    mesh.triangles.push_back({k, facets + next, facets + k});
  }
}

Profile profile_of(double diameter, double height) {
  const double r = 0.5 * diameter, h = 0.5 * height;
  return {{0, -h}, {r, -h}, {r, h}, {0, h}};
}

/// Hemispheres below and above; without a height, a sphere.
Profile capsule_profile(double diameter, double height, Index facets) {
  Profile profile;
  add_quarter(profile, {0, -0.5 * height}, 0.5 * diameter, -0.5 * std::numbers::pi, facets);
  add_quarter(profile, {0, 0.5 * height}, 0.5 * diameter, 0, facets);
  return profile;
}

Profile rounded_profile(const geometry::RoundedCylinder& jar, Index facets) {
  const double h = 0.5 * jar.height, core = 0.5 * jar.diameter - jar.fillet;
  Profile profile{{0, -h}};
  add_quarter(profile, {core, jar.fillet - h}, jar.fillet, -0.5 * std::numbers::pi, facets);
  add_quarter(profile, {core, h - jar.fillet}, jar.fillet, 0, facets);
  profile.push_back({0, h});
  return profile;
}

using Cap =
    std::vector<std::array<Index, 3>>;  // triangles of a polygon, by the indices of its corners

/// Adds an anticlockwise polygon extruded along z.
void add_prism(JarMesh& mesh, const std::vector<Vec3>& polygon, const Cap& cap, double height) {
  const auto n = static_cast<Index>(polygon.size());
  for (const double z : {-0.5 * height, 0.5 * height})
    for (const Vec3& p : polygon) mesh.vertices.push_back({p.x, p.y, z});
  for (Index i = 0; i < n; ++i) {
    const Index next = (i + 1) % n;
    mesh.triangles.push_back({i, next, n + next});
    mesh.triangles.push_back({i, n + next, n + i});
  }
  for (const auto& [a, b, c] : cap) {
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({n + a, n + b, n + c});
  }
}

void add_box(JarMesh& mesh, double width, double depth, double height) {
  const double w = 0.5 * width, d = 0.5 * depth;
  add_prism(mesh, {{w, -d, 0}, {w, d, 0}, {-w, d, 0}, {-w, -d, 0}}, {{0, 1, 2}, {0, 2, 3}}, height);
}

/// Point where a bar's side meets the shell: [m] z outwards from the axis, rho aside from the bar's
/// middle.
ProfilePoint bar_base(const geometry::LifterCylinder& jar, const ProfilePoint& top) {
  const SinCos side = sin_cos(jar.lifter_face_angle);
  const double r = 0.5 * jar.diameter, b = top.z * side.sin + top.rho * side.cos;
  const double down = -b + std::sqrt(b * b - (top.z * top.z + top.rho * top.rho - r * r));
  return {top.rho + down * side.cos, top.z + down * side.sin};
}

/// Adds the extruded cross-section of the drum: for each bar the two edges of its top, then the
/// shell up to the next bar.
void add_lifters(JarMesh& mesh, const geometry::LifterCylinder& jar, Index facets) {
  const double slope = math::cos(jar.lifter_face_angle) / math::sin(jar.lifter_face_angle);
  const ProfilePoint top{0.5 * jar.lifter_width - slope * jar.lifter_height,
                         0.5 * jar.diameter - jar.lifter_height};
  const ProfilePoint foot = bar_base(jar, top);
  const auto bars = static_cast<Index>(jar.lifters);
  const double half = math::atan2(foot.rho, foot.z), pitch = 2 * std::numbers::pi / jar.lifters;
  const double shell = pitch - 2 * half;
  const auto pieces = static_cast<Index>(std::ceil(shell / (2 * std::numbers::pi) * facets));
  const Index each = pieces + 3, all = bars * each, middle = pieces / 2;
  std::vector<Vec3> section;
  Cap cap;
  for (Index bar = 0; bar < bars; ++bar) {
    const SinCos at = sin_cos(2 * std::numbers::pi * bar / jar.lifters);
    for (const double aside : {-top.rho, top.rho})
      section.push_back({top.z * at.cos - aside * at.sin, top.z * at.sin + aside * at.cos, 0});
    for (Index i = 0; i <= pieces; ++i) {
      const SinCos to =
          sin_cos(2 * std::numbers::pi * bar / jar.lifters + half + shell * i / pieces);
      section.push_back(0.5 * jar.diameter * Vec3{to.cos, to.sin, 0});
    }
    // Triangulates the pocket between two bars as two fans from the edges of their tops. The tops
    // themselves form a convex polygon.
    const Index left = bar * each + 1, first = left + 1, right = (left + each - 1) % all;
    for (Index i = 0; i < pieces; ++i)
      cap.push_back({i < middle ? left : right, first + i, first + i + 1});
    cap.push_back({left, first + middle, right});
    if (bar > 0) cap.push_back({0, left - 1, left});
    if (bar > 0 && bar + 1 < bars) cap.push_back({0, left, right});
  }
  if (bars > 1) cap.push_back({0, 1, each});
  add_prism(mesh, section, cap, jar.height);
}

/// Adds a shaft through the lid, and arms: capsules across the shaft.
void add_rotor(JarMesh& mesh, const geometry::Attritor& jar, Index facets) {
  const double bottom = -0.5 * jar.height, length = jar.height - jar.shaft_clearance;
  add_revolved(mesh, profile_of(jar.shaft_diameter, length), facets);
  for (Vec3& p : mesh.vertices) p.z += 0.5 * jar.shaft_clearance;
  for (int arm = 0; arm < static_cast<int>(jar.arms); ++arm) {
    const Index first = count(mesh);
    add_revolved(mesh,
                 capsule_profile(jar.arm_diameter, jar.arm_span - jar.arm_diameter, facets / 4),
                 facets / 4);
    const double z = bottom + jar.arm_clearance + arm * jar.arm_spacing;
    for (Index i = first; i < count(mesh); ++i) {
      const Vec3 p =
          mesh.vertices[i];  // cyclic permutation of axes: the capsule's z becomes x or y
      mesh.vertices[i] = arm % 2 == 0 ? Vec3{p.z, p.x, p.y + z} : Vec3{p.y, p.z, p.x + z};
    }
  }
}

void add(JarMesh& mesh, const geometry::Capsule& jar, Index facets) {
  add_revolved(mesh, capsule_profile(jar.diameter, jar.height, facets), facets);
}
void add(JarMesh& mesh, const geometry::Sphere& jar, Index facets) {
  add_revolved(mesh, capsule_profile(jar.diameter, 0, facets), facets);
}
void add(JarMesh& mesh, const geometry::Cylinder& jar, Index facets) {
  add_revolved(mesh, profile_of(jar.diameter, jar.height), facets);
}
void add(JarMesh& mesh, const geometry::RoundedCylinder& jar, Index facets) {
  add_revolved(mesh, rounded_profile(jar, facets), facets);
}
void add(JarMesh& mesh, const geometry::Box& jar, Index) {
  add_box(mesh, jar.width, jar.depth, jar.height);
}
void add(JarMesh& mesh, const geometry::PeriodicBox& jar, Index) {
  add_box(mesh, jar.width, jar.depth, jar.height);
}
void add(JarMesh& mesh, const geometry::PeriodicCylinder& jar, Index facets) {
  add_tube(mesh, jar.diameter, jar.length, facets);
}
void add(JarMesh& mesh, const geometry::LifterCylinder& jar, Index facets) {
  add_lifters(mesh, jar, facets);
}
void add(JarMesh& mesh, const geometry::PeriodicLifterCylinder& jar, Index facets) {
  const auto on_end = [&](const auto& triangle) {  // ends are triangles across the axis
    const Vec3 &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]],
               &c = mesh.vertices[triangle[2]];
    return a.z == b.z && b.z == c.z;
  };
  add_lifters(mesh, jar.drum, facets);
  std::erase_if(mesh.triangles, on_end);
}
void add(JarMesh& mesh, const geometry::Attritor& jar, Index facets) {
  add_revolved(mesh, profile_of(jar.diameter, jar.height), facets);
}
void add(JarMesh& mesh, const geometry::Mesh& jar, Index) {
  mesh.vertices = jar.surface().points;
  for (const auto& [a, b, c] : jar.surface().triangles)
    mesh.triangles.push_back({static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c)});
}

void add(JarMesh& mesh, const geometry::PlaneSolid&, double reach, Index) {
  const double w = 0.7 * reach;
  mesh.vertices = {{-w, -w, 0}, {w, -w, 0}, {w, w, 0}, {-w, w, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
}
template <class Round>
requires requires(const Round s) {
  s.frustum();
}
void add(JarMesh& mesh, const Round& solid, double, Index facets) {
  const geometry::Frustum f = solid.frustum();
  const double half = 0.5 * f.length;
  add_revolved(mesh, {{0, -half}, {f.low_radius, -half}, {f.high_radius, half}, {0, half}}, facets);
}
/// The four edges of the ring, and the bands between them.
void add(JarMesh& mesh, const geometry::RingSolid& ring, double, Index facets) {
  const double inner = 0.5 * ring.hole, outer = 0.5 * ring.diameter, half = 0.5 * ring.thickness;
  const std::array<ProfilePoint, 4> edges{
      {{inner, -half}, {outer, -half}, {outer, half}, {inner, half}}};
  for (const ProfilePoint& edge : edges)
    for (Index k = 0; k < facets; ++k) {
      const SinCos at = sin_cos(2 * std::numbers::pi * k / facets);
      mesh.vertices.push_back({edge.rho * at.cos, edge.rho * at.sin, edge.z});
    }
  for (Index e = 0; e < 4; ++e)
    for (Index k = 0; k < facets; ++k) {
      const Index from = e * facets, to = (e + 1) % 4 * facets, next = (k + 1) % facets;
      mesh.triangles.push_back({from + k, from + next, to + next});
      mesh.triangles.push_back({from + k, to + next, to + k});
    }
}
void add(JarMesh& mesh, const geometry::BladeSolid& solid, double, Index) {
  add_box(mesh, solid.length, solid.thickness, solid.height);
}
void add(JarMesh& mesh, const geometry::MeshSolid& solid, double, Index) {
  mesh.vertices = solid.surface().points;
  for (const auto& [a, b, c] : solid.surface().triangles)
    mesh.triangles.push_back({static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c)});
}

}  // namespace

std::vector<JarMesh> own_part_surfaces(const scene::Chamber& mill, Index facets) {
  std::vector<JarMesh> made;
  const double reach = geometry::reach(*mill.shape);
  for (const scene::MachinePart& part : mill.parts) {
    JarMesh& mesh = made.emplace_back(JarMesh{.name = "part", .vertices = {}, .triangles = {}});
    std::visit([&](const auto& s) { add(mesh, s, reach, facets); }, *part.solid);
  }
  return made;
}

std::vector<JarMesh> part_surfaces(const scene::Chamber& mill, Index facets) {
  std::vector<JarMesh> made = own_part_surfaces(mill, facets);
  for (std::size_t k = 0; k < made.size(); ++k)
    for (Vec3& p : made[k].vertices) p = mill.parts[k].position + mill.parts[k].axes * p;
  return made;
}

std::vector<JarMesh> jar_surface(const geometry::AnyShape& shape, Index facets) {
  std::vector<JarMesh> made{{.name = "jar", .vertices = {}, .triangles = {}}};
  std::visit([&](const auto& s) { add(made.front(), s, facets); }, shape);
  if (const auto* stirred = geometry::as<geometry::Attritor>(shape))
    add_rotor(made.emplace_back(JarMesh{"rotor", {}, {}, true}), *stirred, facets);
  return made;
}

Rotation rotor_turn(const geometry::AnyShape& shape, double time) {
  const auto* stirred = geometry::as<geometry::Attritor>(shape);
  return stirred == nullptr ? Rotation{} : rotation_about({0, 0, 1}, stirred->rotor_speed * time);
}

}  // namespace mahlwerk::results
