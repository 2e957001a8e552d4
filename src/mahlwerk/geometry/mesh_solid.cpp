// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/mesh_solid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/base/index.hpp"
#include "mahlwerk/geometry/mesh_wall.hpp"

namespace mahlwerk::geometry {
namespace {

/// Whether a side belongs to one triangle only.
bool is_open(const Surface& s) {
  const std::optional<Flaw> flaw = flaw_of(s);
  return flaw && flaw->kind == Flaw::Kind::open;
}

void turn_inside_out(Surface& s) {
  for (auto& t : s.triangles) std::swap(t[1], t[2]);
}

/// The triangles of a sheet with a second, opposite copy of each. The copies share the vertices of
/// the rim alone, so that both sides are one closed surface around no volume.
Surface with_back(const Surface& s) {
  const std::vector<Side> sides = sides_of(s);
  std::vector<bool> rim(s.points.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto same = [&](std::size_t j) {
      return j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high;
    };
    if (same(i + 1) || (i > 0 && same(i - 1))) continue;
    rim[as_index(sides[i].low)] = rim[as_index(sides[i].high)] = true;
  }
  Surface both = s;
  std::vector<std::int32_t> back(s.points.size());
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    back[i] = static_cast<std::int32_t>(rim[i] ? i : both.points.size());
    if (!rim[i]) both.points.push_back(s.points[i]);
  }
  for (const auto& t : s.triangles)
    both.triangles.push_back({back[as_index(t[0])], back[as_index(t[2])], back[as_index(t[1])]});
  return both;
}

/// Within a thousandth of its size; file formats round.
bool in_one_plane(const Surface& s, double size) {
  Vec3 normal;  // of the largest triangle
  Vec3 at;
  for (const auto& t : s.triangles) {
    const Vec3 a = s.points[as_index(t[0])];
    const Vec3 n = cross(s.points[as_index(t[1])] - a, s.points[as_index(t[2])] - a);
    if (norm(n) > norm(normal)) normal = n, at = a;
  }
  return std::ranges::all_of(s.points, [&](const Vec3& p) {
    return std::abs(dot(normal, p - at)) <= 1e-3 * size * norm(normal);
  });
}

}  // namespace

std::optional<Flaw> flaw_of_part(const Surface& surface) {
  std::optional<Flaw> found;
  const std::vector<Side> sides = sides_of(surface);
  for (std::size_t from = 0, to = 0; from < sides.size(); from = to) {
    for (to = from; to < sides.size() && sides[to].low == sides[from].low &&
                    sides[to].high == sides[from].high;)
      ++to;
    const bool crowded = to - from > 2;
    if (!crowded && (to - from == 1 || sides[from].forward != sides[from + 1].forward)) continue;
    if (!found)
      found = Flaw{crowded ? Flaw::Kind::non_manifold : Flaw::Kind::misoriented, 0,
                   0.5 * (surface.points[as_index(sides[from].low)] +
                          surface.points[as_index(sides[from].high)])};
    ++found->count;
  }
  return found;
}

MeshSolid::MeshSolid(Surface surface, double angle) : crease_angle(angle) {
  sheet_ = is_open(surface);
  if (!sheet_) face_outward(surface);
  for (const Vec3& p : surface.points) reach_ = std::max(reach_, norm(p));
  flat_ = in_one_plane(surface, reach_);
  // The wall of a MeshWall faces the inside of its surface; balls are outside of this one.
  Surface seen = surface;
  turn_inside_out(seen);
  wall_ = std::make_shared<MeshWall>(sheet_ ? with_back(seen) : std::move(seen), angle,
                                     MeshWall::Depth::unknown);
  faces = wall_->faces();
  surface_ = std::make_shared<const Surface>(std::move(surface));
}

Gap MeshSolid::gap(int face, const Vec3& p, double within) const {
  return wall_->gap(face, p, within);
}
double MeshSolid::distance(int face, const Vec3& p, double within) const {
  return wall_->distance(face, p, within);
}
Gap MeshSolid::nearest(const Vec3& p) const {
  return wall_ == nullptr ? Gap{never, {0, 0, 1}, 0} : wall_->nearest(p).gap;
}
double MeshSolid::clearance(const Vec3& p) const {
  const double distance = nearest(p).distance;
  return sheet_ ? std::abs(distance) : distance;
}
bool MeshSolid::operator==(const MeshSolid& o) const {
  return crease_angle == o.crease_angle && *surface_ == *o.surface_;
}

}  // namespace mahlwerk::geometry
