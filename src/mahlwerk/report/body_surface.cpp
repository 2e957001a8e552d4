// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/body_surface.hpp"

#include <algorithm>
#include <numbers>

#include "mahlwerk/base/trig.hpp"

namespace mahlwerk::report {
namespace {

constexpr std::uint32_t steps = 6;                      // of a quarter of a circle of the rounding
constexpr std::uint32_t quarters = 4, per_quarter = 8;  // steps of a quarter about the axis

/// Half the size of a core.
Vec3 half_size(const geometry::ConvexCore& core) {
  if (core.is_cylinder()) return {core.radius, core.radius, core.half_length};
  Vec3 half;
  for (const Vec3& c : core.corners)
    half = {std::max(half.x, c.x), std::max(half.y, c.y), std::max(half.z, c.z)};
  return half;
}

/// The directions about the axis; the ends of each quarter stand twice, for the faces of a box.
struct Meridian {
  SinCos angle;
  double side_x, side_y;  // -1 or 1, of the quarter
};
std::vector<Meridian> meridians() {
  std::vector<Meridian> all;
  for (std::uint32_t quarter = 0; quarter < quarters; ++quarter)
    for (std::uint32_t k = 0; k <= per_quarter; ++k)
      all.push_back({sin_cos(std::numbers::pi / 2 * (quarter + double(k) / per_quarter)),
                     quarter == 0 || quarter == 3 ? 1.0 : -1.0, quarter < 2 ? 1.0 : -1.0});
  return all;
}

}  // namespace

BodySurface body_surface(const scene::BodyShape& shape) {
  const Vec3 half = half_size(shape.core);
  const std::vector<Meridian> columns = meridians();
  const auto count = static_cast<std::uint32_t>(columns.size());
  BodySurface surface;
  const auto add = [&](const Vec3& core, const Vec3& normal) {
    surface.vertices.push_back(core + shape.rounding * normal);
    surface.normals.push_back(normal);
  };
  for (const double side : {-1.0, 1.0})
    for (std::uint32_t k = 0; k <= steps; ++k) {
      const double share = double(k) / steps;
      const SinCos height = sin_cos(std::numbers::pi / 2 * (side < 0 ? share - 1 : share));
      for (const Meridian& at : columns) {
        const Vec3 n{height.cos * at.angle.cos, height.cos * at.angle.sin, height.sin};
        const Vec3 edge = shape.core.is_cylinder()
                              ? Vec3{half.x * at.angle.cos, half.y * at.angle.sin, 0}
                              : Vec3{half.x * at.side_x, half.y * at.side_y, 0};
        add(edge + Vec3{0, 0, side * half.z}, n);
      }
    }
  for (std::uint32_t row = 0; row + 1 < 2 * (steps + 1); ++row)
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t a = row * count + k, b = row * count + (k + 1) % count;
      surface.triangles.push_back({a, b, b + count});
      surface.triangles.push_back({a, b + count, a + count});
    }
  const std::uint32_t bottom = 2 * (steps + 1) * count, last = bottom - count;
  add({0, 0, -half.z}, {0, 0, -1}), add({0, 0, half.z}, {0, 0, 1});
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t next = (k + 1) % count;
    surface.triangles.push_back({bottom, next, k});
    surface.triangles.push_back({bottom + 1, last + k, last + next});
  }
  return surface;
}

}  // namespace mahlwerk::report
