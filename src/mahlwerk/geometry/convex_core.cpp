// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/convex_core.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::geometry {
namespace {

/// A point of the difference of two cores, in the axes of the first, and the points that it is made
/// of, each in the axes of its core.
struct Difference {
  Vec3 w, a, b;
};

/// Up to four points of the difference whose hull has the point nearest to the origin.
class Simplex {
 public:
  using Index = std::size_t;
  /// Points by number with their weights; the rest has the weight 0. None: the hull of four points
  /// holds the origin.
  struct Weights {
    std::array<Index, 3> of{};
    std::array<double, 3> weight{};
    std::size_t count = 0;
  };

  void add(const Difference& d) { points_[count_++] = d; }
  void drop_last() { --count_; }
  bool has(const Vec3& w) const {
    for (std::size_t k = 0; k < count_; ++k)
      if (points_[k].w == w) return true;
    return false;
  }
  /// The point of the hull nearest to the origin.
  Weights nearest() const {
    if (count_ == 1) return {{0}, {1}, 1};
    if (count_ == 2) return nearest_on_edge(0, 1);
    return count_ == 3 ? nearest_on_triangle(0, 1, 2) : nearest_on_tetrahedron();
  }
  /// The same by trying all corners, edges and triangles: rounding may make the regions of slivers
  /// overlap or leave gaps.
  Weights nearest_of_all() const {
    Weights best = {{0}, {1}, 1};
    const auto consider = [&](const Weights& at) {
      if (squared(point(at)) < squared(point(best))) best = at;
    };
    for (Index i = 1; i < count_; ++i)
      for (Index j = 0; j < i; ++j) {
        consider(nearest_on_edge(i, j));
        for (Index k = 0; k < j; ++k) consider(nearest_on_triangle(i, j, k));
      }
    return best;
  }
  Vec3 point(const Weights& at) const {
    Vec3 sum;
    for (std::size_t n = 0; n < at.count; ++n) sum += at.weight[n] * points_[at.of[n]].w;
    return sum;
  }
  /// Leaves the points with weights.
  void keep(const Weights& at) {
    const std::array<Difference, 4> all = points_;
    for (std::size_t n = 0; n < at.count; ++n)
      points_[n] = all[at.of[n]], weights_[n] = at.weight[n];
    count_ = at.count;
  }
  /// The point of the first core that belongs to the nearest point.
  Vec3 on_first() const {
    Vec3 sum;
    for (std::size_t k = 0; k < count_; ++k) sum += weights_[k] * points_[k].a;
    return sum;
  }
  NearestHulls hulls() const {
    NearestHulls out;
    out.count = static_cast<std::int64_t>(count_);
    for (std::size_t k = 0; k < count_; ++k) out.of_a[k] = points_[k].a, out.of_b[k] = points_[k].b;
    return out;
  }
  template <class Of>
  CoreFeature feature(const Of& of) const {
    int distinct = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      bool fresh = true;
      for (std::size_t l = 0; l < k; ++l) fresh = fresh && !(of(points_[l]) == of(points_[k]));
      distinct += fresh ? 1 : 0;
    }
    return static_cast<CoreFeature>(std::clamp(distinct - 1, 0, 2));
  }

 private:
  Weights nearest_on_edge(Index i, Index j) const {
    const Vec3 &a = points_[i].w, along = points_[j].w - a;
    const double t = -dot(a, along), length = dot(along, along);
    if (t <= 0) return {{i}, {1}, 1};
    if (t >= length) return {{j}, {1}, 1};
    return {{i, j}, {1 - t / length, t / length}, 2};
  }

  /// By the regions of Voronoi of corners, edges and face.
  Weights nearest_on_triangle(Index i, Index j, Index k) const {
    const Vec3 &a = points_[i].w, &b = points_[j].w, &c = points_[k].w;
    const Vec3 ab = b - a, ac = c - a;
    const double d1 = -dot(ab, a), d2 = -dot(ac, a), d3 = -dot(ab, b), d4 = -dot(ac, b),
                 d5 = -dot(ab, c), d6 = -dot(ac, c);
    if (d1 <= 0 && d2 <= 0) return {{i}, {1}, 1};
    if (d3 >= 0 && d4 <= d3) return {{j}, {1}, 1};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return nearest_on_edge(i, j);
    if (d6 >= 0 && d5 <= d6) return {{k}, {1}, 1};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return nearest_on_edge(i, k);
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return nearest_on_edge(j, k);
    const double sum = va + vb + vc;
    return {{i, j, k}, {va / sum, vb / sum, vc / sum}, 3};
  }

  Weights nearest_on_tetrahedron() const {
    constexpr double flatness = 1e-9;  // of points on a rim close to each other
    constexpr std::array<std::array<Index, 4>, 4> faces{
        {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}}};
    Weights best;
    double least = 0;
    for (const auto& [i, j, k, opposite] : faces) {
      const Vec3& a = points_[i].w;
      const Vec3 n = cross(points_[j].w - a, points_[k].w - a), height = points_[opposite].w - a;
      const double origin = -dot(n, a), other = dot(n, height);
      const bool flat = other * other <= flatness * flatness * squared(n) * squared(height);
      if (origin * other > 0 && !flat) continue;  // the origin lies on the inner side
      const Weights at = nearest_on_triangle(i, j, k);
      const double squared_distance = squared(point(at));
      if (best.count == 0 || squared_distance < least) best = at, least = squared_distance;
    }
    return best;
  }

  std::array<Difference, 4> points_;
  std::array<double, 4> weights_{};
  std::size_t count_ = 0;
};

/// The points of the difference of two cores, in the axes of the first.
class CoreDifference {
 public:
  CoreDifference(const PlacedCore& a, const PlacedCore& b)
      : a_(a.core), b_(b.core), way_(a.axes.apply_inverse(b.centre - a.centre)) {
    if (b_ != nullptr)
      turn_ = {a.axes.apply_inverse(b.axes.ex), a.axes.apply_inverse(b.axes.ey),
               a.axes.apply_inverse(b.axes.ez)};
  }
  const Vec3& way() const { return way_; }
  /// The one that is farthest along `d`.
  Difference farthest(const Vec3& d) const {
    return of(a_ == nullptr ? Vec3{} : a_->support(d),
              b_ == nullptr ? Vec3{} : b_->support(turn_.apply_inverse(-d)));
  }
  /// That of two points of the cores.
  Difference of(const Vec3& a, const Vec3& b) const { return {a - (way_ + turn_ * b), a, b}; }

 private:
  const ConvexCore *a_, *b_;
  Vec3 way_;       // to the centre of the second
  Rotation turn_;  // from the axes of the second
};

}  // namespace

Vec3 ConvexCore::support(const Vec3& d) const {
  if (is_cylinder()) {
    const double across = std::sqrt(d.x * d.x + d.y * d.y);
    const double z = d.z >= 0 ? half_length : -half_length;
    if (!(across > 0)) return {radius, 0, z};
    return {radius * d.x / across, radius * d.y / across, z};
  }
  std::size_t best = 0;
  double most = dot(corners[0], d);
  for (std::size_t k = 1; k < corners.size(); ++k)
    if (const double along = dot(corners[k], d); along > most) most = along, best = k;
  return corners[best];
}

double ConvexCore::reach() const {
  double most = std::sqrt(radius * radius + half_length * half_length);
  for (const Vec3& c : corners) most = std::max(most, norm(c));
  return most;
}

ConvexCore ConvexCore::scaled(double factor) const {
  ConvexCore out = *this;
  for (Vec3& c : out.corners) c = factor * c;
  out.radius *= factor, out.half_length *= factor;
  return out;
}

NearestPoints nearest_points(const PlacedCore& a, const PlacedCore& b, NearestHulls& hulls) {
  constexpr double accuracy = 1e-8;  // of the square of the distance
  constexpr int most_rounds = 100;
  const CoreDifference difference(a, b);
  Simplex simplex;
  for (std::size_t k = 0; k < static_cast<std::size_t>(hulls.count); ++k)
    simplex.add(difference.of(hulls.of_a[k], hulls.of_b[k]));
  if (hulls.count == 0) simplex.add(difference.farthest(difference.way()));
  const Simplex::Weights first = simplex.nearest();
  Vec3 at = simplex.point(first);  // nearest to the origin so far
  simplex.keep(first);
  double square = squared(at);
  NearestPoints found;
  for (int round = 0; round < most_rounds && square > 0; ++round) {
    const Difference next = difference.farthest(-at);
    const double along = dot(at, next.w);
    if (square - along <= accuracy * square || simplex.has(next.w)) break;
    simplex.add(next);
    Simplex::Weights nearest = simplex.nearest();
    if (nearest.count == 0) {  // they meet
      simplex.drop_last();
      square = 0;
      break;
    }
    Vec3 nearer = simplex.point(nearest);
    if (!(squared(nearer) < square)) {
      nearest = simplex.nearest_of_all();
      nearer = simplex.point(nearest);
    }
    if (!(squared(nearer) < square)) {  // rounding
      simplex.drop_last();
      break;
    }
    simplex.keep(nearest);
    at = nearer, square = squared(at);
  }
  const Vec3 on_a = simplex.on_first();
  found.on_a = a.centre + a.axes * on_a, found.on_b = a.centre + a.axes * (on_a - at);
  found.distance = std::sqrt(square);
  hulls = simplex.hulls();
  found.feature_a = simplex.feature([](const Difference& d) { return d.a; });
  found.feature_b = simplex.feature([](const Difference& d) { return d.b; });
  return found;
}

double mean_curvature(const ConvexCore& core, double rounding, const Vec3& at, const Vec3& normal,
                      CoreFeature feature) {
  if (!core.is_cylinder()) return 0.5 * (2 - static_cast<int>(feature)) / rounding;
  constexpr double near = 1e-9;
  const double across = std::sqrt(at.x * at.x + at.y * at.y);
  if (across < core.radius * (1 - near)) return 0;  // an end
  if (std::abs(at.z) < core.half_length * (1 - near)) return 0.5 / (core.radius + rounding);
  const double side = std::sqrt(normal.x * normal.x + normal.y * normal.y);
  return 0.5 * (1 / rounding + side / (core.radius + rounding * side));
}

}  // namespace mahlwerk::geometry
