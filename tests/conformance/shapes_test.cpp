// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Every shape in the register meets the requirements of geometry/shape.hpp.
#include "mahlwerk/geometry/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <span>
#include <tuple>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "meshes.hpp"
#include "part_jars.hpp"
#include "register_types.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::shapes_test {
namespace {

using geometry::Attritor;
using geometry::Box;
using geometry::Capsule;
using geometry::Cylinder;
using geometry::LifterCylinder;
using geometry::Mesh;
using geometry::PeriodicBox;
using geometry::PeriodicCylinder;
using geometry::PeriodicLifterCylinder;
using geometry::RoundedCylinder;
using geometry::Sphere;

template <class S>
S sample();
template <>
Sphere sample() {
  return {0.03};
}
template <>
Capsule sample() {
  return {0.012, 0.03621};
}
template <>
Cylinder sample() {
  return {0.042, 0.0325};
}
template <>
RoundedCylinder sample() {
  return {0.042, 0.0325, 0.006};
}

template <>
Box sample() {
  return {0.03, 0.042, 0.0325};
}

template <>
PeriodicBox sample() {
  return {0.03, 0.042, 0.0325};
}
template <>
PeriodicCylinder sample() {
  return {0.042, 0.0325};
}
template <>
LifterCylinder sample() {
  return lifters();
}
template <>
PeriodicLifterCylinder sample() {
  return periodic_lifters();
}
template <>
Attritor sample() {
  return stirrer();
}

template <>
Mesh sample() {
  return mesh_of(cylinder(6, 0.042, 0.0325));
}

template <class S>
class Shapes : public ::testing::Test {
 protected:
  S shape = sample<S>();
  Random random{7, 1};

  /// Distance of a ball's surface to the nearest wall; infinite without walls.
  double to_wall(const Vec3& p, double radius = 0) const {
    double least = std::numeric_limits<double>::infinity();
    if constexpr (std::is_same_v<S, Mesh>) {  // outside, its gaps have no sign
      shape.near(p, 2 * shape.reach(), [&](int, const geometry::Gap& gap) {
        least = std::min(least, gap.distance - radius);
      });
      return least;
    }
    for (int face = 0; face < shape.faces; ++face)
      if (radius == 0 || shape.can_touch(face, radius))
        least = std::min(least, shape.gap(face, p).distance);
    return least - radius;
  }
  double nearest(const Vec3& p, double radius = 0) const {
    return std::min(to_wall(p, radius), to_image(p));
  }
  /// Distance to the nearest periodic boundary of a periodic shape.
  double to_image(const Vec3& p) const {
    const Vec3 half = 0.5 * geometry::periods_of(shape), at = componentwise_abs(p);
    return std::min({half.x - at.x, half.y - at.y, half.z - at.z});
  }
  Vec3 anywhere() {
    const double r = shape.reach();
    return {random.uniform(-r, r), random.uniform(-r, r), random.uniform(-r, r)};
  }
  Vec3 inside(double radius) {
    Vec3 p = anywhere();
    while (nearest(p, radius) <= 1e-6) p = anywhere();
    return p;
  }
};
/// Every shape of the register, a mesh by one sample of many faces; with all its triangles it is
/// compared in unit/geometry/mesh_test.cpp.
TYPED_TEST_SUITE(Shapes, TypesOf<geometry::Shapes::Any>::type, NameOfModel);

TYPED_TEST(Shapes, gap_is_a_distance_whose_gradient_is_the_inward_normal) {
  double worst = 0;
  int across = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 p = this->inside(0);
    for (int face = 0; face < this->shape.faces; ++face) {
      const auto at = [&](const Vec3& q) { return this->shape.gap(face, q).distance; };
      if (at(p) >= geometry::not_near) continue;  // of a mesh: no ball at p touches this face
      const double h = 1e-7;
      const Vec3 slope{(at(p + Vec3{h, 0, 0}) - at(p - Vec3{h, 0, 0})) / (2 * h),
                       (at(p + Vec3{0, h, 0}) - at(p - Vec3{0, h, 0})) / (2 * h),
                       (at(p + Vec3{0, 0, h}) - at(p - Vec3{0, 0, h})) / (2 * h)};
      // Central differences have an error of h^2/6 times a third derivative of order 1/r^2. They
      // have no meaning across a ridge of the distance function, where the nearest wall changes
      // (geo.1).
      if (std::abs(norm(slope) - 1) > 1e-3) {
        ++across;
        continue;
      }
      const Vec3 inward = this->shape.gap(face, p).inward;
      EXPECT_NEAR(norm(inward), 1, 1e-14);
      worst = max_or_nan(worst, norm(slope - inward));
    }
  }
  stays_below("difference between gradient and inward normal", worst, 1e-3, "geo.1");
  // Ridges are surfaces: a share of 2 h area / volume of the points, about 1e-5, lies across one.
  stays_below("points whose gradient is not 1", across, 5, "geo.1");
}

// A drive that is reversed relies on it (cases/reversal.hpp).
TYPED_TEST(Shapes, is_its_own_mirror_image_at_the_plane_of_x_and_z) {
  if (!geometry::has_exact_touches<TypeParam>) return;  // bars and facets: but for rounding
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = this->anywhere();
    EXPECT_EQ(this->nearest({p.x, -p.y, p.z}), this->nearest(p));
  }
}

/// Compares each lane of gaps() with gap(), bit by bit.
template <class V, class S>
void expect_gaps_of_lanes(const S& shape, std::span<const Vec3> points) {
  for (std::size_t first = 0; first + width_of<V> <= points.size(); ++first) {
    V face{};
    Vec<V> p{};
    for (int l = 0; l < width_of<V>; ++l) {
      const Vec3& point = points[first + static_cast<std::size_t>(l)];
      face[l] = static_cast<double>((first + static_cast<std::size_t>(l)) % shape.faces);
      p.x[l] = point.x, p.y[l] = point.y, p.z[l] = point.z;
    }
    const geometry::LaneGap<V> found = shape.gaps(face, p);
    for (int l = 0; l < width_of<V>; ++l) {
      const geometry::Gap gap = shape.gap(static_cast<int>(face[l]), {p.x[l], p.y[l], p.z[l]});
      EXPECT_EQ(found.distance[l], gap.distance);
      EXPECT_EQ((Vec3{found.inward.x[l], found.inward.y[l], found.inward.z[l]}), gap.inward);
    }
  }
}

TYPED_TEST(Shapes, gaps_of_a_register_have_the_bits_of_a_gap) {
  if constexpr (requires(Register<2> face, Vec<Register<2>> p) { this->shape.gaps(face, p); }) {
    std::vector<Vec3> points{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0.01}};
    for (int i = 0; i < 1000; ++i) points.push_back(this->anywhere());
    expect_gaps_of_lanes<Register<2>>(this->shape, points);
  }
}

TYPED_TEST(Shapes, normal_rate_is_the_derivative_of_the_inward_normal) {
  if (!geometry::has_exact_touches<TypeParam>) return;  // the soft engine does not ask for it
  double worst = 0;
  int across = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 p = this->inside(0), v = this->random.direction();
    for (int face = 0; face < this->shape.faces; ++face) {
      const auto inward = [&](double s) { return this->shape.gap(face, p + s * v).inward; };
      const Vec3 rate = this->shape.normal_rate(face, p, v);
      const double h = 1e-8 / (1 + norm(rate) * 1e-3);
      const Vec3 ahead = (inward(h) - inward(0)) / h, behind = (inward(0) - inward(-h)) / h;
      if (norm(ahead - behind) > 1e-2 * (1 + norm(rate))) {  // across a crease or a ridge
        ++across;
        continue;
      }
      worst = max_or_nan(worst, norm(rate - 0.5 * (ahead + behind)) / (1 + norm(rate)));
    }
  }
  stays_below("relative difference of the normal's rate", worst, 1e-4, "geo.2");
  stays_below("points across a crease or a ridge", across, 5, "geo.2");
}

TYPED_TEST(Shapes, volume_is_that_of_the_points_inside) {
  constexpr int points = 400000;
  int inside = 0;
  for (int i = 0; i < points; ++i) inside += this->nearest(this->anywhere()) > 0;
  const double share = static_cast<double>(inside) / points,
               box = 8 * std::pow(this->shape.reach(), 3);
  const double sigma = std::sqrt(share * (1 - share) / points);
  states("volume [ml]", 1e6 * this->shape.volume(), 1e6 * box * share, 5e6 * box * sigma,
         "Monte Carlo, five standard errors");
}

TYPED_TEST(Shapes, reach_holds_the_jar_and_inradius_the_largest_ball) {
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = this->inside(0);
    EXPECT_LE(norm(p), this->shape.reach() * (1 + 1e-12));
    if (!geometry::has_exact_touches<TypeParam>) continue;  // that of the largest ball found
    EXPECT_LE(this->nearest(p), this->shape.inradius() * (1 + 1e-12));
  }
  Vec3 middle{};
  if constexpr (requires { this->shape.middle(); }) middle = this->shape.middle();
  const double widest = this->shape.faces > 0 ? this->to_wall(middle) : this->to_image(middle);
  EXPECT_NEAR(widest, this->shape.inradius(), 1e-12);
}

/// Conservative advancement relies on this: no path with bounded acceleration reaches the wall
/// sooner.
TYPED_TEST(Shapes, no_touch_within_the_time_that_safe_time_promises) {
  double deepest = 0, longest = 0;
  for (int i = 0; i < 20000; ++i) {
    const double radius = this->random.uniform(0.05, 0.9) * this->shape.inradius();
    const Vec3 start = this->inside(radius);
    const double speed = std::pow(10, this->random.uniform(-2, 1));
    const Vec3 velocity = speed * this->random.direction();
    const geometry::AccelerationBound max_acceleration(
        {this->random.uniform(0, 100), this->random.uniform(0, 100), this->random.uniform(0, 700)});
    double clear = std::numeric_limits<double>::infinity();
    for (int face = 0; face < this->shape.faces; ++face) {
      if (!this->shape.can_touch(face, radius)) continue;
      const geometry::SafeTime safe =
          this->shape.safe_time(face, {start, velocity, max_acceleration}, radius);
      EXPECT_LE(safe.gap, this->shape.gap(face, start).distance - radius + 1e-15);
      clear = std::min(clear, safe.time);
    }
    longest = max_or_nan(longest, clear);
    if (this->shape.faces == 0) continue;  // without walls the safe time must be infinite: below
    Vec3 p = start, v = velocity;
    constexpr int steps = 60;
    const double h = clear / steps;
    const bool steady = i % 2 == 0;  // the worst field is often constant and towards the wall
    Vec3 a{};
    for (int k = 0; k < steps; ++k) {
      if (k == 0 || !steady)
        a = {std::copysign(max_acceleration.components.x, this->random.uniform(-1, 1)),
             std::copysign(max_acceleration.components.y, this->random.uniform(-1, 1)),
             std::copysign(max_acceleration.components.z, this->random.uniform(-1, 1))};
      p += h * (v + 0.5 * h * a);
      v += h * a;
      deepest = max_or_nan(deepest, -this->to_wall(p, radius));
    }
  }
  stays_below("deepest penetration [m]", deepest, 1e-15, "geo.4 to geo.6, 20000 random courses");
  EXPECT_GT(longest, 1e-3);
  if (this->shape.faces == 0) {
    EXPECT_EQ(longest, geometry::never);
  }
}

}  // namespace
}  // namespace mahlwerk::tests::shapes_test
