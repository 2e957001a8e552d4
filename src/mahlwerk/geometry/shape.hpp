// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <span>
#include <string_view>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/field.hpp"
#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/geometry/near_facets.hpp"

// A jar's inner wall, in the jar's own axes: origin in the middle, z along the jar's axis. The wall
// is a set of smooth faces. A wall that is smooth throughout is one face with one C1 gap (geo.1).
namespace mahlwerk::geometry {

/// Position of a point relative to one face.
struct Gap {
  double distance = 0;   ///< [m] from the wall, > 0 inside; |grad distance| = 1
  Vec3 inward;           ///< unit normal of the wall, pointing into the jar: grad distance
  double curvature = 0;  ///< [1/m] the wall's largest principal curvature there, > 0 concave
};

/// Bounds on an acceleration [m/s2], by component and combined as the faces need them.
struct AccelerationBound {
  Vec3 components;         ///< on the magnitudes of the components
  double total = 0;        ///< on its magnitude
  double across_axis = 0;  ///< on the magnitude of its part across z

  AccelerationBound() = default;
  explicit AccelerationBound(const Vec3& bounds)
      : components(bounds), total(norm(bounds)), across_axis(math::hypot(bounds.x, bounds.y)) {}
};

/// State of a ball's centre for a safe-time query, in the jar's own axes.
struct SafeTimeQuery {
  const Vec3& position;                       ///< [m]
  const Vec3& velocity;                       ///< [m/s]
  const AccelerationBound& max_acceleration;  ///< bounds from now on
};

/// Result of a safe-time query: a time in which the ball does not touch the face.
struct SafeTime {
  double gap = 0;      ///< [m] between ball and face; a lower bound, exact as it closes
  double closing = 0;  ///< > 0 if the gap shrinks; only the sign counts
  double time = 0;     ///< [s] no touch is possible in it, whatever the acceleration within bounds
};

/// How the inner diameter and height of a jar are presented, with the value of a new case.
constexpr UsualRange jar_heights{"2 mm", "500 mm", true};
constexpr Presentation diameter_of_jar(std::string_view start) {
  return {
      .label = "jar diameter", .symbol = "$D$", .start = start, .usual = {"5 mm", "500 mm", true}};
}
constexpr Presentation height_of_jar(std::string_view start) {
  return {.label = "jar height", .start = start, .usual = jar_heights};
}

/// A jar shape. `normal_rate(face, p, v)` is d(inward)/dt [1/s] at a point that passes p at v; its
/// product with -v is the inward acceleration of a point that moves along the parallel surface
/// (geo.2). `time_to_curvature_jump(face, p, v)` [s] is the time until a point on a straight line
/// crosses a jump of the wall's curvature, infinite if it does not. `safe_time(face, query,
/// radius)` serves the touch search by conservative advancement (geo.4 to geo.6). `can_touch(face,
/// radius)` says whether a ball of that radius can touch the face at all.
template <class S>
concept Shape = requires(const S s, int face, double radius, Vec3 p, SafeTimeQuery query) {
  { S::name } -> std::convertible_to<std::string_view>;
  { S::about } -> std::convertible_to<std::string_view>;
  { s.faces } -> std::convertible_to<int>;  // constant, except for some shapes such as a mesh
  { S::axisymmetric } -> std::convertible_to<bool>;
  { S::face_name(face) } -> std::convertible_to<std::string_view>;
  { s.gap(face, p) } -> std::same_as<Gap>;
  { s.normal_rate(face, p, p) } -> std::same_as<Vec3>;
  { s.time_to_curvature_jump(face, p, p) } -> std::same_as<double>;
  { s.safe_time(face, query, radius) } -> std::same_as<SafeTime>;
  { s.can_touch(face, radius) } -> std::same_as<bool>;
  { s.volume() } -> std::same_as<double>;  // [m3]
  { s.reach() } -> std::same_as<double>;   // [m] radius of a sphere about the origin that holds it
  { s.inradius() } -> std::same_as<double>;  // [m] radius of the largest ball it holds
};

constexpr double never = std::numeric_limits<double>::infinity();

/// Periods along each axis [m], the distances between the images of a ball; infinite for a shape
/// that has no member `periods()`.
template <class S>
Vec3 periods_of(const S& shape) {
  if constexpr (requires { shape.periods(); })
    return shape.periods();
  else
    return {never, never, never};
}

/// Radius of the jar about its axis [m], for the critical speed: what the shape says, half of its
/// diameter, or the radius of the largest ball.
template <class S>
double radius_about_axis_of(const S& shape) {
  if constexpr (requires { shape.radius_about_axis(); })
    return shape.radius_about_axis();
  else if constexpr (requires { shape.diameter; })
    return 0.5 * shape.diameter;
  else
    return shape.inradius();
}

/// Speed of a stirrer's tips relative to the shape [m/s]; 0 for a shape without a stirrer.
template <class S>
double rotor_tip_speed_of(const S& shape) {
  if constexpr (requires { shape.rotor_speed; })
    return std::abs(shape.rotor_speed) * shape.rotor_reach();
  else
    return 0;
}

/// [m] stands for a distance beyond the range of the query; finite.
constexpr double not_near = 1e3;

// Queries that shapes of many faces answer for near faces only.

/// The gap to a face where `p` is within `within` [m] of it; any larger gap elsewhere.
template <class S>
Gap gap_near(const S& shape, int face, const Vec3& p, double within) {
  if constexpr (requires { shape.gap(face, p, within); })
    return shape.gap(face, p, within);
  else
    return shape.gap(face, p);
}

/// A shape whose gap() is faster with the facets that the last query of a ball has left.
template <class S>
concept KeepsNearFacets = requires(const S s, NearFacets near) {
  s.gap(0, Vec3{}, 0.0, near);
};

/// Writes the distance of each face [m] to `out`; any larger number for faces beyond `within` [m].
template <class S>
void distances(const S& shape, const Vec3& p, double within, std::span<double> out) {
  if constexpr (requires { shape.distances(p, within, out); })
    shape.distances(p, within, out);
  else
    for (int face = 0; face < shape.faces; ++face)
      out[static_cast<std::size_t>(face)] = gap_near(shape, face, p, within).distance;
}

/// Distance of one face [m], as distances().
template <class S>
double distance(const S& shape, int face, const Vec3& p, double within) {
  if constexpr (requires { shape.distance(face, p, within); })
    return shape.distance(face, p, within);
  else
    return gap_near(shape, face, p, within).distance;
}

/// Calls `f(face, gap)` for the faces that a ball of `radius` [m] at `p` can touch: at least for
/// all within `within` [m], and for one face if p is outside the jar.
template <class S, class F>
void for_each_near_face(const S& shape, const Vec3& p, double radius, double within, F f) {
  if constexpr (requires { shape.near(p, within, f); })
    shape.near(p, within, f);
  else
    for (int face = 0; face < shape.faces; ++face)
      if (shape.can_touch(face, radius)) f(face, shape.gap(face, p));
}

}  // namespace mahlwerk::geometry
