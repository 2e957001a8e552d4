// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/worn_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace mahlwerk::geometry {
namespace {

using Triangle = std::array<std::int32_t, 3>;

const Vec3& corner(const Surface& s, const Triangle& t, std::size_t k) {
  return s.points[static_cast<std::size_t>(t[k % 3])];
}
/// [m2] Half of it is the area of a triangle.
Vec3 doubled_area(const Surface& s, const Triangle& t) {
  return cross(corner(s, t, 1) - corner(s, t, 0), corner(s, t, 2) - corner(s, t, 0));
}

double longest_edge(const Surface& s) {
  double longest = 0;
  for (const Triangle& t : s.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, norm(corner(s, t, k + 1) - corner(s, t, k)));
  return longest;
}

/// All triangles cut in four at the middles of their edges.
Surface in_four(const Surface& s) {
  Surface cut{s.points, {}};
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
  const auto middle = [&](std::int32_t a, std::int32_t b) {
    const auto [at, made] = middles.try_emplace(std::minmax(a, b), 0);
    if (made) {
      at->second = static_cast<std::int32_t>(cut.points.size());
      cut.points.push_back(
          0.5 * (s.points[static_cast<std::size_t>(a)] + s.points[static_cast<std::size_t>(b)]));
    }
    return at->second;
  };
  for (const auto& [a, b, c] : s.triangles) {
    const std::int32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    cut.triangles.insert(cut.triangles.end(),
                         {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return cut;
}

/// Unit normals of the vertices, outwards, weighted by the areas of their triangles.
std::vector<Vec3> vertex_normals(const Surface& s) {
  std::vector<Vec3> normals(s.points.size());
  for (const Triangle& t : s.triangles)
    for (const std::int32_t v : t) normals[static_cast<std::size_t>(v)] += doubled_area(s, t);
  for (Vec3& n : normals)
    if (const double length = norm(n); length > 0) n = n / length;
  return normals;
}

/// An edge of the surface and its conductance for what flows between its ends.
struct Link {
  std::size_t a, b;
  double conductance;  // [1] half the sum of the cotangents of the opposite angles, not below 0
};
std::vector<Link> links_of(const Surface& s) {
  std::map<std::pair<std::int32_t, std::int32_t>, double> found;
  for (const Triangle& t : s.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 one = corner(s, t, k) - corner(s, t, k + 2),
                 other = corner(s, t, k + 1) - corner(s, t, k + 2);
      const double across = norm(cross(one, other));
      found[std::minmax(t[k], t[(k + 1) % 3])] += across > 0 ? 0.5 * dot(one, other) / across : 0;
    }
  std::vector<Link> links;
  for (const auto& [ends, value] : found)
    if (value > 0)
      links.push_back(
          {static_cast<std::size_t>(ends.first), static_cast<std::size_t>(ends.second), value});
  return links;
}

Surface moved(const Surface& s, const std::vector<Vec3>& by, double share) {
  Surface m = s;
  for (std::size_t i = 0; i < m.points.size(); ++i) m.points[i] += share * by[i];
  return m;
}

bool turns_over(const Surface& before, const Surface& after) {
  return std::ranges::any_of(before.triangles, [&](const Triangle& t) {
    return !(dot(doubled_area(before, t), doubled_area(after, t)) > 0);
  });
}

}  // namespace

std::optional<Surface> cut_into_small(Surface s, double longest, std::size_t most) {
  while (longest_edge(s) > longest) {
    if (4 * s.triangles.size() > most) return std::nullopt;
    s = in_four(s);
  }
  return s;
}

std::vector<double> vertex_areas(const Surface& s) {
  std::vector<double> areas(s.points.size());
  for (const Triangle& t : s.triangles) {
    const double third = norm(doubled_area(s, t)) / 6;
    for (const std::int32_t v : t) areas[static_cast<std::size_t>(v)] += third;
  }
  return areas;
}

std::vector<double> spread_over(const Surface& s, std::vector<double> lost, double width) {
  const std::vector<double> areas = vertex_areas(s);
  const std::vector<Link> links = links_of(s);
  std::vector<double> leaving(s.points.size());
  for (const Link& l : links) leaving[l.a] += l.conductance, leaving[l.b] += l.conductance;
  double fastest = 0;  // [1/m2]
  for (std::size_t i = 0; i < areas.size(); ++i)
    if (areas[i] > 0) fastest = std::max(fastest, leaving[i] / areas[i]);
  if (!(width > 0) || !(fastest > 0)) return lost;
  constexpr double stable = 0.5, most_steps = 10'000;  // very uneven meshes are smoothed less
  const double whole = 0.5 * width * width;
  const double steps = std::ceil(whole * fastest / stable);
  const double step = steps > most_steps ? stable / fastest : whole / steps;
  std::vector<double> next;
  for (double k = 0; k < std::min(steps, most_steps); ++k) {
    next = lost;
    for (const Link& l : links) {
      const double flow = step * l.conductance * (lost[l.a] / areas[l.a] - lost[l.b] / areas[l.b]);
      next[l.a] -= flow;
      next[l.b] += flow;
    }
    lost.swap(next);
  }
  return lost;
}

std::optional<Surface> worn_surface(const Surface& s, const std::vector<double>& lost,
                                    WornSide side) {
  const std::vector<double> areas = vertex_areas(s);
  std::vector<Vec3> by = vertex_normals(s);
  const double sign = side == WornSide::inside ? 1 : -1;
  double sum = 0;
  for (std::size_t i = 0; i < by.size(); ++i) {
    by[i] *= areas[i] > 0 ? sign * lost[i] / areas[i] : 0;
    sum += lost[i];
  }
  if (!(sum > 0)) return s;
  // The volume is a cubic function of the share of the movement, nearly linear: secants.
  const double before = volume_of(s);
  const auto missing = [&](double share) {
    return sign * (volume_of(moved(s, by, share)) - before) - sum;
  };
  double share = 1, last = 0, of_last = -sum;
  constexpr int most = 30;
  constexpr double rounding = 1e-14;
  for (int i = 0; i < most; ++i) {
    const double now = missing(share);
    if (std::abs(now) <= rounding * std::abs(before) || now == of_last) break;
    const double better = share - now * (share - last) / (now - of_last);
    last = std::exchange(share, better);
    of_last = now;
  }
  if (!(share > 0)) return std::nullopt;
  Surface worn = moved(s, by, share);
  if (turns_over(s, worn)) return std::nullopt;
  return worn;
}

std::size_t NearestVertex::Hash::operator()(const Cell& c) const {
  std::size_t h = 0;
  for (const int k : c) h = h * 1'000'003 + static_cast<std::size_t>(k);
  return h;
}

NearestVertex::NearestVertex(const Surface& s) : points_(s.points) {
  const std::vector<double> areas = vertex_areas(s);
  double mean = 0;
  for (const double a : areas) mean += a / static_cast<double>(areas.size());
  width_ = 2 * std::sqrt(mean);
  const Vec3 size = extent_of(points_).size();
  most_rings_ = 2 + static_cast<int>(std::max({size.x, size.y, size.z}) / width_);
  for (std::size_t i = 0; i < points_.size(); ++i) cells_[cell_of(points_[i])].push_back(i);
}

NearestVertex::Cell NearestVertex::cell_of(const Vec3& p) const {
  const auto slot = [&](double x) { return static_cast<int>(std::floor(x / width_)); };
  return {slot(p.x), slot(p.y), slot(p.z)};
}

void NearestVertex::search(const Cell& m, int ring, const Vec3& p, double& least,
                           std::size_t& found) const {
  for (int i = -ring; i <= ring; ++i)
    for (int j = -ring; j <= ring; ++j)
      for (int k = -ring; k <= ring; ++k) {
        if (std::max({std::abs(i), std::abs(j), std::abs(k)}) != ring) continue;
        const auto at = cells_.find({m[0] + i, m[1] + j, m[2] + k});
        if (at == cells_.end()) continue;
        for (const std::size_t v : at->second)
          if (const double far = norm(points_[v] - p); far < least) least = far, found = v;
      }
}

std::size_t NearestVertex::operator()(const Vec3& p) const {
  std::size_t found = 0;
  double least = std::numeric_limits<double>::infinity();
  const Cell middle = cell_of(p);
  for (int ring = 0; ring <= most_rings_; ++ring) {
    search(middle, ring, p, least, found);
    if (least <= ring * width_) break;  // what is farther out is farther away
  }
  return found;
}

}  // namespace mahlwerk::geometry
