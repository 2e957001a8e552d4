// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/index.hpp"

namespace mahlwerk::geometry {
namespace {

using Triangle = std::array<std::int32_t, 3>;

/// Spatial hash of points, with cells larger than the welding tolerance.
class VertexWelder {
 public:
  VertexWelder(double tolerance, double size)
      : tolerance_(tolerance), cell_(std::max(4 * tolerance, 1e-9 * size)) {}

  /// The number of the first point within the tolerance of `p`, or a new one.
  std::int32_t number(const Vec3& p, std::vector<Vec3>& points) {
    const Vec3 reach{tolerance_, tolerance_, tolerance_};
    const Cell low = cell(p - reach), high = cell(p + reach);
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          const auto [from, to] = cells_.equal_range({x, y, z});
          for (auto at = from; at != to; ++at) {
            const Vec3 apart = componentwise_abs(points[static_cast<std::size_t>(at->second)] - p);
            if (std::max({apart.x, apart.y, apart.z}) <= tolerance_) return at->second;
          }
        }
    const auto number = static_cast<std::int32_t>(points.size());
    points.push_back(p);
    cells_.emplace(cell(p), number);
    return number;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cell& c) const {
      std::uint64_t h = 0;
      for (const std::int64_t i : c) h = (h ^ static_cast<std::uint64_t>(i)) * 0x9e3779b97f4a7c15u;
      return h ^ h >> 32;
    }
  };
  Cell cell(const Vec3& p) const {
    const auto index = [&](double x) { return static_cast<std::int64_t>(std::floor(x / cell_)); };
    return {index(p.x), index(p.y), index(p.z)};
  }

  double tolerance_, cell_;
  std::unordered_multimap<Cell, std::int32_t, Hash> cells_;
};

Surface with_shared_vertices(std::span<const Corners> triangles, double tolerance, double size) {
  Surface out;
  VertexWelder welder(tolerance, size);
  for (const Corners& c : triangles) {
    std::array<std::int32_t, 3> t{};
    for (std::size_t k = 0; k < 3; ++k) t[k] = welder.number(c[k], out.points);
    out.triangles.push_back(t);
  }
  return out;
}

bool closed(const Surface& s) {
  const std::vector<Side> sides = sides_of(s);
  for (std::size_t from = 0, to = 0; from < sides.size(); from = to) {
    for (to = from; to < sides.size() && sides[to].low == sides[from].low &&
                    sides[to].high == sides[from].high;)
      ++to;
    if (to - from < 2) return false;
  }
  return true;
}

/// Index of a triangle's longest side.
std::size_t longest_side(const Surface& s, const Triangle& t) {
  std::size_t longest = 0;
  double most = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double length = squared(s.points[as_index(t[(k + 1) % 3])] - s.points[as_index(t[k])]);
    if (length > most) most = length, longest = k;
  }
  return longest;
}

/// Height of a triangle over its longest side [m].
double height_of(const Surface& s, const Triangle& t) {
  const std::size_t k = longest_side(s, t);
  const Vec3 a = s.points[as_index(t[k])], b = s.points[as_index(t[(k + 1) % 3])],
             c = s.points[as_index(t[(k + 2) % 3])];
  return norm(cross(b - a, c - a)) / norm(b - a);
}

/// Maps a directed side, from one corner to another, to its triangle; of several, the first added.
class SideMap {
 public:
  explicit SideMap(const std::vector<Triangle>& triangles) {
    of_.reserve(3 * triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) note(triangles[i], i);
  }
  std::optional<std::size_t> of(std::int32_t from, std::int32_t to) const {
    const auto at = of_.find(key(from, to));
    if (at == of_.end()) return std::nullopt;
    return at->second;
  }
  void note(const Triangle& t, std::size_t number) {
    for (std::size_t k = 0; k < 3; ++k) of_.emplace(key(t[k], t[(k + 1) % 3]), number);
  }
  void forget(const Triangle& t, std::size_t number) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = of_.find(key(t[k], t[(k + 1) % 3]));
      if (at != of_.end() && at->second == number) of_.erase(at);
    }
  }

 private:
  static std::uint64_t key(std::int32_t from, std::int32_t to) {
    return static_cast<std::uint64_t>(from) << 32 | static_cast<std::uint32_t>(to);
  }
  std::unordered_map<std::uint64_t, std::size_t> of_;
};

/// Edge flip: replaces a triangle without area, whose corner b lies on its side from c to a, and
/// the neighbour at that side by the two triangles at the line from b to the neighbour's opposite
/// corner. Returns whether the flip was possible.
bool flip_longest_side(Surface& s, SideMap& sides, std::size_t flat) {
  const Triangle t = s.triangles[flat];
  const std::size_t k = longest_side(s, t);
  const std::int32_t c = t[k], a = t[(k + 1) % 3], b = t[(k + 2) % 3];
  const auto beside = sides.of(a, c);
  if (!beside) return false;
  const Triangle n = s.triangles[*beside];
  const auto j = static_cast<std::size_t>(std::ranges::find(n, a) - n.begin());
  const std::int32_t d = n[(j + 2) % 3];
  if (d == b) return false;
  sides.forget(t, flat);
  sides.forget(n, *beside);
  sides.note(s.triangles[*beside] = {a, b, d}, *beside);
  sides.note(s.triangles[flat] = {b, c, d}, flat);
  return true;
}

void remove_degenerate_triangles(Surface& s) {
  std::erase_if(s.triangles,
                [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  const double least = 1e-9 * norm(extent_of(s.points).size());
  std::optional<SideMap> sides;  // built for the first triangle without area
  for (int rounds = 0; rounds < 8; ++rounds) {
    bool turned = false;
    for (std::size_t i = 0; i < s.triangles.size(); ++i) {
      if (!(height_of(s, s.triangles[i]) < least)) continue;
      if (!sides) sides.emplace(s.triangles);
      turned = flip_longest_side(s, *sides, i) || turned;
    }
    if (!turned) return;
  }
}

/// Midpoint of a side [m].
Vec3 middle(const Surface& s, const Side& side) {
  return 0.5 * (s.points[as_index(side.low)] + s.points[as_index(side.high)]);
}

/// Shell number of each triangle: connected components, by union-find.
std::vector<std::int32_t> shells(const Surface& s, const std::vector<Side>& sides) {
  std::vector<std::int32_t> of(s.triangles.size());
  std::iota(of.begin(), of.end(), 0);
  const auto root = [&](std::int32_t i) {
    while (of[as_index(i)] != i) i = of[as_index(i)] = of[as_index(of[as_index(i)])];
    return i;
  };
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
    const std::int32_t a = root(sides[i].triangle), b = root(sides[i + 1].triangle);
    of[as_index(std::max(a, b))] = std::min(a, b);
  }
  for (std::size_t i = 0; i < of.size(); ++i) of[i] = root(static_cast<std::int32_t>(i));
  return of;
}

/// The triangles of one shell.
struct Shell {
  std::vector<std::size_t> triangles;
  Extent extent;
};

/// The shells in the order of their first triangles.
std::vector<Shell> shells_of(const Surface& s) {
  const std::vector<std::int32_t> of = shells(s, sides_of(s));
  std::vector<Shell> found;
  std::vector<std::size_t> number(of.size());
  for (std::size_t i = 0; i < of.size(); ++i) {
    if (of[i] == static_cast<std::int32_t>(i)) {
      number[i] = found.size();
      found.emplace_back();
    }
    found[number[as_index(of[i])]].triangles.push_back(i);
  }
  for (Shell& shell : found) {
    std::vector<Vec3> points;
    for (const std::size_t i : shell.triangles)
      for (const std::int32_t corner : s.triangles[i]) points.push_back(s.points[as_index(corner)]);
    shell.extent = extent_of(points);
  }
  return found;
}

/// Six times the volume [m3] between a triangle and `origin`, signed.
double sixfold_volume(const Surface& s, const Triangle& t, const Vec3& origin) {
  return dot(s.points[as_index(t[0])] - origin,
             cross(s.points[as_index(t[1])] - origin, s.points[as_index(t[2])] - origin));
}

bool is_inside_out(const Surface& s, const Shell& shell) {
  double sixfold = 0;
  for (const std::size_t i : shell.triangles)
    sixfold += sixfold_volume(s, s.triangles[i], shell.extent.middle());
  return sixfold < 0;
}

/// How often a shell winds around a point, by solid angles (van Oosterom and Strackee 1983): 0
/// outside, 1 or -1 inside.
double winding_number(const Surface& s, const Shell& shell, const Vec3& p) {
  double half_angle = 0;
  for (const std::size_t i : shell.triangles) {
    const Triangle& t = s.triangles[i];
    const Vec3 a = s.points[as_index(t[0])] - p, b = s.points[as_index(t[1])] - p,
               c = s.points[as_index(t[2])] - p;
    const double la = norm(a), lb = norm(b), lc = norm(c);
    half_angle += math::atan2(dot(a, cross(b, c)),
                              la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return half_angle / (2 * std::numbers::pi);
}

/// Whether `inner` lies in `outer`, by up to 64 of its corners: bodies that overlap are not nested.
bool lies_in(const Surface& s, const Shell& inner, const Shell& outer) {
  const Extent &in = inner.extent, &out = outer.extent;
  const bool in_box = out.low.x <= in.low.x && out.low.y <= in.low.y && out.low.z <= in.low.z &&
                      in.high.x <= out.high.x && in.high.y <= out.high.y && in.high.z <= out.high.z;
  if (!in_box) return false;
  const std::size_t step = inner.triangles.size() / 64 + 1;
  for (std::size_t k = 0; k < inner.triangles.size(); k += step) {
    const Vec3& corner = s.points[as_index(s.triangles[inner.triangles[k]][0])];
    if (std::abs(winding_number(s, outer, corner)) < 0.75) return false;
  }
  return true;
}

}  // namespace

void face_outward(Surface& s) {
  const std::vector<Shell> all = shells_of(s);
  for (std::size_t i = 0; i < all.size(); ++i) {
    bool cavity = false;
    for (std::size_t k = 0; k < all.size(); ++k)
      if (k != i && lies_in(s, all[i], all[k])) cavity = !cavity;
    if (is_inside_out(s, all[i]) == cavity) continue;
    for (const std::size_t t : all[i].triangles) std::swap(s.triangles[t][1], s.triangles[t][2]);
  }
}

Surface weld(std::span<const Corners> triangles) {
  std::vector<Vec3> all;
  for (const Corners& c : triangles) all.insert(all.end(), c.begin(), c.end());
  const double size = norm(extent_of(all).size());
  if (!(size > 0)) return {};
  Surface s = with_shared_vertices(triangles, 0, size);
  remove_degenerate_triangles(s);
  if (closed(s)) return s;
  Surface loose = with_shared_vertices(triangles, 1e-6 * size, size);
  remove_degenerate_triangles(loose);
  return closed(loose) ? loose : s;
}

Extent extent_of(std::span<const Vec3> points) {
  if (points.empty()) return {};
  Extent e{points[0], points[0]};
  for (const Vec3& p : points) {
    e.low = {std::min(e.low.x, p.x), std::min(e.low.y, p.y), std::min(e.low.z, p.z)};
    e.high = {std::max(e.high.x, p.x), std::max(e.high.y, p.y), std::max(e.high.z, p.z)};
  }
  return e;
}

double volume_of(const Surface& s) {
  const Vec3 origin = extent_of(s.points).middle();  // keeps rounding of the differences small
  double sixfold = 0;
  for (const Triangle& t : s.triangles) sixfold += sixfold_volume(s, t, origin);
  return sixfold / 6;
}

std::vector<Side> sides_of(const Surface& s) {
  std::vector<Side> sides;
  sides.reserve(3 * s.triangles.size());
  for (std::size_t i = 0; i < s.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = s.triangles[i][k], b = s.triangles[i][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<std::int32_t>(i),
                       static_cast<std::int32_t>(k), a < b});
    }
  std::ranges::sort(sides, {}, [](const Side& e) { return std::tuple(e.low, e.high, e.triangle); });
  return sides;
}

std::optional<Flaw> flaw_of(const Surface& s) {
  const std::vector<Side> sides = sides_of(s);
  std::optional<Flaw> open, non_manifold, misoriented;
  const auto note = [&](std::optional<Flaw>& flaw, Flaw::Kind kind, const Side& side) {
    if (!flaw) flaw = Flaw{kind, 0, middle(s, side)};
    ++flaw->count;
  };
  for (std::size_t from = 0, to = 0; from < sides.size(); from = to) {
    const Side& first = sides[from];
    for (to = from;
         to < sides.size() && sides[to].low == first.low && sides[to].high == first.high;)
      ++to;
    if (to - from == 1)
      note(open, Flaw::Kind::open, first);
    else if (to - from > 2)
      note(non_manifold, Flaw::Kind::non_manifold, first);
    else if (first.forward == sides[from + 1].forward)
      note(misoriented, Flaw::Kind::misoriented, first);
  }
  for (const auto& flaw : {open, non_manifold, misoriented})
    if (flaw) return flaw;
  const std::vector<std::int32_t> shell = shells(s, sides);
  std::size_t count = 0;
  std::optional<Vec3> second;
  for (std::size_t i = 0; i < shell.size(); ++i) {
    if (shell[i] != static_cast<std::int32_t>(i)) continue;
    if (++count == 2) second = s.points[as_index(s.triangles[i][0])];
  }
  if (second) return Flaw{Flaw::Kind::several_shells, count, *second};
  if (!(volume_of(s) > 0)) return Flaw{Flaw::Kind::inside_out, 0, {}};
  return std::nullopt;
}

}  // namespace mahlwerk::geometry
