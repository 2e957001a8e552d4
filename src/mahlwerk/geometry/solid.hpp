// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/geometry/shape.hpp"

// Solid bodies in a jar, as balls outside of them see them, in the body's own axes. Each has one
// face: all but the ring are convex, and a ball touches them at one point (geo.19). `gap` and
// `distance` are those of a shape (geometry/shape.hpp), `clearance` is the distance from the whole
// body, negative inside.
namespace mahlwerk::geometry {

constexpr UsualRange part_sizes{"1 mm", "1 m", true};

/// All below z = 0: a floor, a piston, a wall that moves.
struct PlaneSolid {
  static constexpr std::string_view name = "plane";
  static constexpr std::string_view about =
      "a plane without end, square to its axis; balls are on the side to which the axis points";
  static constexpr int faces = 1;
  static constexpr auto fields() { return std::array<Field<PlaneSolid>, 0>{}; }

  Gap gap(int, const Vec3& p, double) const { return {p.z, {0, 0, 1}, 0}; }
  double distance(int, const Vec3& p, double) const { return p.z; }
  double clearance(const Vec3& p) const { return p.z; }
  Vec3 normal_rate(int, const Vec3&, const Vec3&) const { return {}; }
  double reach() const { return never; }
  bool operator==(const PlaneSolid&) const = default;
};

/// The outside of a frustum about z, with its middle at the origin.
struct Frustum {
  double low_radius = 0, high_radius = 0, length = 0;  // [m]

  /// Where a point lies in the half plane of radius and height.
  struct Nearest {
    double distance = 0;     ///< [m] < 0 inside
    double out = 0, up = 1;  ///< components of the unit normal
    bool on_side = false;    ///< the nearest point is on the cone, not on an edge or end
  };
  Nearest nearest(double r, double z) const {
    const double half = 0.5 * length, slant = math::hypot(high_radius - low_radius, length);
    const double n_r = length / slant, n_z = (low_radius - high_radius) / slant;
    const double from_side = n_r * (r - low_radius) + n_z * (z + half);
    const double along = (-n_z * (r - low_radius) + n_r * (z + half)) / slant;
    const double above = z - half, below = -half - z;
    if (std::max({from_side, above, below}) <= 0) {  // inside
      if (from_side >= above && from_side >= below) return {from_side, n_r, n_z, true};
      return above >= below ? Nearest{above, 0, 1} : Nearest{below, 0, -1};
    }
    if (above >= 0 && r <= high_radius) return {above, 0, 1};
    if (below >= 0 && r <= low_radius) return {below, 0, -1};
    if (from_side > 0 && along >= 0 && along <= 1) return {from_side, n_r, n_z, true};
    const bool high = along > 0.5;
    const double dr = r - (high ? high_radius : low_radius), dz = high ? above : -below;
    const double far = math::hypot(dr, dz);
    return far > 0 ? Nearest{far, dr / far, dz / far} : Nearest{0, n_r, n_z, true};
  }
  Gap gap(const Vec3& p) const {
    const double r = math::hypot(p.x, p.y);
    const Nearest found = nearest(r, p.z);
    const Vec3 out = r > 0 ? Vec3{p.x / r, p.y / r, 0} : Vec3{1, 0, 0};
    return {found.distance, found.out * out + Vec3{0, 0, found.up}, 0};
  }
  /// Edges count as flat, as those of all shapes.
  Vec3 normal_rate(const Vec3& p, const Vec3& v) const {
    const double r = math::hypot(p.x, p.y);
    const Nearest found = nearest(r, p.z);
    if (!found.on_side || !(r > 0)) return {};
    const Vec3 out{p.x / r, p.y / r, 0};
    const Vec3 across = Vec3{v.x, v.y, 0} - dot(out, v) * out;
    return found.out / r * across;
  }
  double reach() const { return math::hypot(std::max(low_radius, high_radius), 0.5 * length); }
};

/// What the solids of revolution share; `S` has `frustum()`.
template <class S>
struct RoundSolid {
  static constexpr int faces = 1;
  Gap gap(int, const Vec3& p, double) const { return self().frustum().gap(p); }
  double distance(int, const Vec3& p, double) const { return clearance(p); }
  double clearance(const Vec3& p) const { return self().frustum().gap(p).distance; }
  Vec3 normal_rate(int, const Vec3& p, const Vec3& v) const {
    return self().frustum().normal_rate(p, v);
  }
  double reach() const { return self().frustum().reach(); }
  bool operator==(const RoundSolid&) const = default;

 private:
  const S& self() const { return static_cast<const S&>(*this); }
};

struct DiscSolid : RoundSolid<DiscSolid> {
  double diameter = 0, thickness = 0;  // [m]
  static constexpr std::string_view name = "disc";
  static constexpr std::string_view about = "a round disc about its axis";
  static constexpr auto fields() {
    using D = DiscSolid;
    return std::array{Field<D>{"diameter", "m", &D::diameter, positive, "outer diameter"}.with(
                          {.start = "60 mm", .usual = part_sizes}),
                      Field<D>{"thickness", "m", &D::thickness, positive, "along the axis"}.with(
                          {.start = "5 mm", .usual = part_sizes})};
  }
  Frustum frustum() const { return {0.5 * diameter, 0.5 * diameter, thickness}; }
  bool operator==(const DiscSolid&) const = default;
};

struct CylinderSolid : RoundSolid<CylinderSolid> {
  double diameter = 0, length = 0;  // [m]
  static constexpr std::string_view name = "cylinder";
  static constexpr std::string_view about = "a round bar about its axis: a shaft, a pin";
  static constexpr auto fields() {
    using C = CylinderSolid;
    return std::array{Field<C>{"diameter", "m", &C::diameter, positive, "diameter"}.with(
                          {.start = "15 mm", .usual = part_sizes}),
                      Field<C>{"length", "m", &C::length, positive, "along the axis"}.with(
                          {.start = "60 mm", .usual = part_sizes})};
  }
  Frustum frustum() const { return {0.5 * diameter, 0.5 * diameter, length}; }
  bool operator==(const CylinderSolid&) const = default;
};

struct ConeSolid : RoundSolid<ConeSolid> {
  double diameter = 0, top_diameter = 0, length = 0;  // [m]
  static constexpr std::string_view name = "cone";
  static constexpr std::string_view about = "a cone or frustum about its axis";
  static constexpr auto fields() {
    using C = ConeSolid;
    return std::array{
        Field<C>{"diameter", "m", &C::diameter, positive, "diameter at the foot"}.with(
            {.start = "40 mm", .usual = part_sizes}),
        Field<C>{"top_diameter", "m", &C::top_diameter, not_negative, "diameter at the top", 0.0,
                 "a cone with a tip"},
        Field<C>{"length", "m", &C::length, positive, "from the foot to the top, along the axis"}
            .with({.start = "40 mm", .usual = part_sizes})};
  }
  Frustum frustum() const { return {0.5 * diameter, 0.5 * top_diameter, length}; }
  bool operator==(const ConeSolid&) const = default;
};

/// A disc with a round hole. A ball smaller than the hole touches it at one point; a larger one on
/// the hole lies on that point of the rim which is nearest.
struct RingSolid {
  double diameter = 0, hole = 0, thickness = 0;  // [m]
  static constexpr std::string_view name = "ring";
  static constexpr std::string_view about =
      "a disc with a round hole: a floor with an orifice, an annular baffle";
  static constexpr int faces = 1;
  static constexpr auto fields() {
    using R = RingSolid;
    return std::array{Field<R>{"diameter", "m", &R::diameter, positive, "outer diameter"}.with(
                          {.start = "60 mm", .usual = part_sizes}),
                      Field<R>{"hole", "m", &R::hole, positive, "diameter of the hole"}.with(
                          {.start = "20 mm", .usual = part_sizes}),
                      Field<R>{"thickness", "m", &R::thickness, positive, "along the axis"}.with(
                          {.start = "5 mm", .usual = part_sizes})};
  }
  /// Beyond the rectangle of radius and height, in radius (signed outwards) and in height.
  struct Beyond {
    double radius = 0, height = 0;  ///< [m] > 0 outside
    bool in_hole = false;           ///< the inner side is the nearer one
  };
  Beyond beyond(double r, double z) const {
    const double inner = 0.5 * hole - r, outer = r - 0.5 * diameter;
    return {std::max(inner, outer), std::abs(z) - 0.5 * thickness, inner > outer};
  }
  Gap gap(int, const Vec3& p, double) const {
    const double r = math::hypot(p.x, p.y);
    const Beyond b = beyond(r, p.z);
    const Vec3 radial = r > 0 ? Vec3{p.x / r, p.y / r, 0} : Vec3{1, 0, 0};
    const Vec3 out = b.in_hole ? -radial : radial, up{0, 0, p.z < 0 ? -1.0 : 1.0};
    if (b.radius > 0 && b.height > 0) {
      const double far = math::hypot(b.radius, b.height);
      return {far, b.radius / far * out + b.height / far * up, 0};
    }
    return b.radius > b.height ? Gap{b.radius, out, 0} : Gap{b.height, up, 0};
  }
  double distance(int, const Vec3& p, double) const { return clearance(p); }
  double clearance(const Vec3& p) const { return gap(0, p, never).distance; }
  /// Edges count as flat, as those of all shapes.
  Vec3 normal_rate(int, const Vec3& p, const Vec3& v) const {
    const double r = math::hypot(p.x, p.y);
    const Beyond b = beyond(r, p.z);
    if (!(r > 0) || !(b.radius > b.height) || (b.radius > 0 && b.height > 0)) return {};
    const Vec3 radial{p.x / r, p.y / r, 0};
    const Vec3 rate = (Vec3{v.x, v.y, 0} - dot(radial, v) * radial) / r;
    return b.in_hole ? -rate : rate;
  }
  double reach() const { return math::hypot(0.5 * diameter, 0.5 * thickness); }
  bool operator==(const RingSolid&) const = default;
};

/// A cuboid with its middle at the origin.
struct BladeSolid {
  double length = 0, thickness = 0, height = 0;  // [m] along x, y and z
  static constexpr std::string_view name = "blade";
  static constexpr std::string_view about = "a straight blade, a cuboid: a paddle, a bar, a baffle";
  static constexpr int faces = 1;
  static constexpr auto fields() {
    using B = BladeSolid;
    return std::array{Field<B>{"length", "m", &B::length, positive, "along the part's own x"}.with(
                          {.start = "60 mm", .usual = part_sizes}),
                      Field<B>{"thickness", "m", &B::thickness, positive, "along its own y"}.with(
                          {.start = "5 mm", .usual = part_sizes}),
                      Field<B>{"height", "m", &B::height, positive, "along its axis"}.with(
                          {.start = "20 mm", .usual = part_sizes})};
  }
  Gap gap(int, const Vec3& p, double) const {
    const std::array<double, 3> at{p.x, p.y, p.z},
        half{0.5 * length, 0.5 * thickness, 0.5 * height};
    std::array<double, 3> beyond{}, n{};
    double squares = 0;
    std::size_t nearest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      beyond[k] = std::abs(at[k]) - half[k];
      if (beyond[k] > 0) squares += beyond[k] * beyond[k];
      if (beyond[k] > beyond[nearest]) nearest = k;
    }
    const double far = std::sqrt(squares);
    const bool outside = beyond[nearest] > 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double side = at[k] < 0 ? -1 : 1;
      if (outside)
        n[k] = beyond[k] > 0 ? side * beyond[k] / far : 0;
      else
        n[k] = k == nearest ? side : 0;
    }
    return {outside ? far : beyond[nearest], {n[0], n[1], n[2]}, 0};
  }
  double distance(int, const Vec3& p, double) const { return clearance(p); }
  double clearance(const Vec3& p) const { return gap(0, p, never).distance; }
  Vec3 normal_rate(int, const Vec3&, const Vec3&) const { return {}; }
  double reach() const { return 0.5 * norm(Vec3{length, thickness, height}); }
  bool operator==(const BladeSolid&) const = default;
};

}  // namespace mahlwerk::geometry
