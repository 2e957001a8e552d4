// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/scene/body_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/trig.hpp"
#include "mahlwerk/geometry/principal_axes.hpp"

namespace mahlwerk::scene {
namespace {

using geometry::MemberSphere;
constexpr double pi = std::numbers::pi;

/// Spheres of `radius` on circles about the z axis.
class Rings {
 public:
  Rings(double radius, std::vector<MemberSphere>& out) : radius_(radius), out_(out) {}
  /// `count` spheres on a circle of radius `ring` at the height z.
  void add(double ring, double z, int count) {
    for (int k = 0; k < count; ++k) {
      const SinCos at = sin_cos(2 * pi * k / count);
      out_.push_back({{ring * at.cos, ring * at.sin, z}, radius_});
    }
  }

 private:
  double radius_;
  std::vector<MemberSphere>& out_;
};

/// Number of points at most `step` apart that divide a length, both ends among them; at least two.
int points_along(double length, double step) {
  return std::max(2, 1 + static_cast<int>(std::ceil(length / step * (1 - 1e-12))));
}

/// The spheres of a cylinder with `ring` spheres around it (bod.3).
std::vector<MemberSphere> ringed_cylinder(double diameter, double length, int ring) {
  std::vector<MemberSphere> all;
  const double chord = sin_cos(pi / ring).sin;
  // Neighbours on the ring are a radius apart.
  const double radius = std::min(diameter * chord / (1 + 2 * chord), length / 2);
  const double around = diameter / 2 - radius, half = length / 2 - radius;
  Rings rings(radius, all);
  const int levels = points_along(2 * half, radius);
  for (int level = 0; level < levels; ++level)
    rings.add(around, half * (2.0 * level / (levels - 1) - 1), ring);
  const int inner = points_along(around, radius) - 1;  // rings within the ends, and their middle
  for (const double z : {-half, half})
    for (int n = 0; n < inner; ++n) {
      const double at = around * n / inner;
      rings.add(at, z, n == 0 ? 1 : std::max(3, ring * n / inner));
    }
  const double core = std::min(diameter, length) / 2;
  const int cores = length > diameter ? points_along(length - diameter, core / 2) : 1;
  for (int n = 0; n < cores; ++n)
    all.push_back(
        {{0, 0, cores == 1 ? 0 : (length / 2 - core) * (2.0 * n / (cores - 1) - 1)}, core});
  return all;
}

constexpr int fewest_around = 4, most_around = 64;

/// Number of grid points along an edge of a cube of at most `spheres` spheres.
int points_on_edge(int spheres) {
  int points = 2;
  const auto count = [](int k) { return k * k * k - (k - 2) * (k - 2) * (k - 2) + 1; };
  while (count(points + 1) <= spheres) ++points;
  return points;
}

}  // namespace

double BodyShape::reach() const {
  if (is_rounded()) return core.reach() + rounding;
  double most = is_sphere() ? 1 : 0;
  for (const MemberSphere& s : spheres) most = std::max(most, norm(s.centre) + s.radius);
  return most;
}

double Solid::equivalent_radius() const {
  return math::cbrt(3 * volume / (4 * pi));
}

BodyShape Solid::shape() const {
  const double r = equivalent_radius();
  BodyShape s{.spheres = spheres,
              .inertia_ratio = inertia / (volume * r * r),
              .solid = kind,
              .core = core.scaled(1 / r),
              .rounding = rounding / r};
  for (MemberSphere& m : s.spheres) m = {m.centre / r, m.radius / r};
  return s;
}

Solid clump(std::span<const MemberSphere> spheres) {
  const geometry::SolidMoments m = geometry::union_moments(spheres);
  const Vec3 &s = m.squares, &p = m.products;
  geometry::Matrix3 tensor{
      {{s.y + s.z, -p.x, -p.z}, {-p.x, s.z + s.x, -p.y}, {-p.z, -p.y, s.x + s.y}}};
  const geometry::Matrix3 axes = geometry::diagonalise(tensor);
  const auto column = [&](std::size_t k) { return Vec3{axes[0][k], axes[1][k], axes[2][k]}; };
  const Vec3 ex = column(0), ey = column(1), ez = cross(ex, ey);  // right-handed
  Solid solid{.spheres = {spheres.begin(), spheres.end()},
              .volume = m.volume,
              .inertia = {tensor[0][0], tensor[1][1], tensor[2][2]}};
  for (MemberSphere& one : solid.spheres) {
    const Vec3 from = one.centre - m.centroid;
    one.centre = {dot(ex, from), dot(ey, from), dot(ez, from)};
  }
  return solid;
}

Solid cylinder_of_spheres(double diameter, double length, int spheres) {
  int ring = fewest_around;
  std::vector<MemberSphere> all = ringed_cylinder(diameter, length, ring);
  for (int more = ring + 1; more <= most_around; ++more) {
    std::vector<MemberSphere> finer = ringed_cylinder(diameter, length, more);
    if (std::ssize(finer) > spheres) break;
    all = std::move(finer), ring = more;
  }
  const double r = diameter / 2, volume = pi * r * r * length;
  const double across = volume * (3 * r * r + length * length) / 12;
  return {std::move(all), volume, {across, across, volume * r * r / 2}, SolidKind::cylinder};
}

int fewest_in_cylinder(double diameter, double length) {
  return static_cast<int>(ringed_cylinder(diameter, length, fewest_around).size());
}

Solid rod_of_spheres(double diameter, double length, int spheres) {
  std::vector<MemberSphere> all;
  const double r = diameter / 2, middle = length - diameter;
  for (int n = 0; n < spheres; ++n)
    all.push_back({{0, 0, middle / 2 * (2.0 * n / (spheres - 1) - 1)}, r});
  // A cylinder between two hemispheres, whose centres of mass are at 3 r/8 from its ends.
  const double side = pi * r * r * middle, ends = 4.0 / 3 * pi * r * r * r;
  const double along = side * r * r / 2 + ends * 0.4 * r * r;
  const double shift = middle / 2 + 0.375 * r;
  const double across = side * (3 * r * r + middle * middle) / 12 +
                        ends * (0.4 * r * r - 0.375 * 0.375 * r * r + shift * shift);
  return {std::move(all), side + ends, {across, across, along}, SolidKind::rod};
}

Solid cube_of_spheres(double edge, double rounding, int spheres) {
  std::vector<MemberSphere> all;
  const int points = points_on_edge(spheres);
  const double half = edge / 2 - rounding;
  const auto at = [&](int k) { return half * (2.0 * k / (points - 1) - 1); };
  const auto outer = [&](int k) { return k == 0 || k == points - 1; };
  for (int x = 0; x < points; ++x)
    for (int y = 0; y < points; ++y)
      for (int z = 0; z < points; ++z)
        if (outer(x) || outer(y) || outer(z)) all.push_back({{at(x), at(y), at(z)}, rounding});
  all.push_back({{}, edge / 2});
  // Core, six plates, twelve quarters of a cylinder and eight octants of a sphere.
  const double b = 2 * half, c = half, r = rounding, r2 = r * r, r3 = r2 * r, r4 = r2 * r2;
  const auto cube = [](double a) { return a * a * a; };
  const double volume = cube(b) + 6 * b * b * r + 3 * pi * b * r2 + 4.0 / 3 * pi * r3;
  const double squares = cube(b) * b * b / 12 + b * b * 2 / 3 * (cube(c + r) - cube(c)) +
                         4 * r * b * b * b * b / 12 + pi * r2 * cube(b) / 12 +
                         8 * b * (c * c * pi * r2 / 4 + 2 * c * r3 / 3 + pi * r4 / 16) +
                         8 * (c * c * pi * r3 / 6 + 2 * c * pi * r4 / 16 + pi * r4 * r / 30);
  const double inertia = 2 * squares;
  return {std::move(all), volume, {inertia, inertia, inertia}, SolidKind::cube};
}

Solid ellipsoid_of_spheres(double diameter, double length, int spheres) {
  std::vector<MemberSphere> all;
  const double b = diameter / 2, a = length / 2, focal = a * a - b * b;
  // A sphere at z touches the surface from inside with the radius b sqrt(1 - z^2/(a^2 - b^2)); the
  // last ones touch it at its poles.
  const double last = focal / a;
  for (int n = 0; n < spheres; ++n) {
    const double z = last * (2.0 * n / (spheres - 1) - 1);
    all.push_back({{0, 0, z}, focal > 0 ? b * std::sqrt(1 - z * z / focal) : b});
  }
  const double volume = 4.0 / 3 * pi * a * b * b, across = volume * (a * a + b * b) / 5;
  return {std::move(all), volume, {across, across, volume * 2 * b * b / 5}, SolidKind::ellipsoid};
}

int usual_spheres_of_cylinder(double diameter, double length) {
  constexpr int around = 6;
  return static_cast<int>(ringed_cylinder(diameter, length, around).size());
}
int usual_spheres_of_rod(double diameter, double length) {
  return points_along(length - diameter, diameter / 2);
}
int usual_spheres_of_cube(double edge, double rounding) {
  const int k = points_along(edge - 2 * rounding, rounding), inner = k - 2;
  return k * k * k - inner * inner * inner + 1;
}
int usual_spheres_of_ellipsoid(double diameter, double length) {
  const double b = diameter / 2, a = length / 2;
  return std::max(3, points_along(2 * (a * a - b * b) / a, b / 2));
}

}  // namespace mahlwerk::scene
