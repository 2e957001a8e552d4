// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "mahlwerk/geometry/shape.hpp"
#include "mahlwerk/kinematics/chosen_motion.hpp"
#include "mahlwerk/scene/chamber.hpp"

namespace mahlwerk::scene {

/// Position and velocity of a ball's centre in the jar frame at an instant.
struct BallState {
  Vec3 position, velocity;  ///< [m], [m/s]
};

/// The wall at its contact with a ball, in the jar frame.
struct Wall {
  double gap;        ///< [m] between ball and wall
  Vec3 inward;       ///< unit normal, into the jar
  Vec3 point;        ///< [m] of contact
  Vec3 velocity;     ///< [m/s] of the wall's material there
  double curvature;  ///< [1/m] its largest curvature there, > 0 concave
};

/// A chamber whose shape is known at compile time, so that the search inlines. `M` has the
/// interface of a motion (tests pass one that counts its calls).
///
/// A jar that does not rotate, or rotates about its axis of symmetry, has a static geometry: that
/// of the mounted jar. Only the material of its wall moves, along the wall.
template <geometry::Shape S, class M = kinematics::ChosenMotion>
class TypedChamber {
 public:
  TypedChamber(const S& shape, const M& motion, const scene::Chamber& chamber)
      : shape_(shape), motion_(motion), mount_(chamber.mount), gravity_(chamber.gravity) {
    const Vec3 axis = motion.fixed_axis();
    const bool along = S::axisymmetric && norm(cross(axis, mount_.ez)) < 1e-12;
    motion_bounds_ = motion.bounds();
    static_geometry_ = motion_bounds_.spin == 0 || along;
    aligned_ = mount_ == Rotation{};
    const Vec3 most = motion_bounds_.acceleration + componentwise_abs(gravity_);
    const Rotation back{mount_.apply_inverse({1, 0, 0}), mount_.apply_inverse({0, 1, 0}),
                        mount_.apply_inverse({0, 0, 1})};
    max_acceleration_ = geometry::AccelerationBound(bound_of_rotated(back, most));
  }

  const S& shape() const { return shape_; }
  const M& motion() const { return motion_; }
  const Vec3& gravity() const { return gravity_; }
  const kinematics::Bounds& motion_bounds() const { return motion_bounds_; }
  bool static_geometry() const { return static_geometry_; }
  /// Largest speed at which the rotating wall may approach a ball at rest in the jar frame [m/s].
  double max_wall_speed() const {
    return static_geometry_ ? 0 : motion_bounds_.spin * shape_.reach();
  }

  /// Whether its own axes are always those of the jar frame.
  bool axis_aligned() const { return static_geometry_ && aligned_; }
  /// Rotation from the axes in which the geometry is evaluated to those of the jar frame.
  Rotation axes(double t) const { return static_geometry_ ? mount_ : orientation(t); }
  /// Rotation from the jar's own axes to those of the jar frame, at mill time `t` [s].
  Rotation orientation(double t) const { return motion_.rotation(t) * mount_; }

  /// Transforms a vector from the jar frame to the jar's own, rotating axes.
  Vec3 to_jar_axes(const Vec3& a, double t) const {
    if (motion_bounds_.spin == 0) return aligned_ ? a : mount_.apply_inverse(a);
    return orientation(t).apply_inverse(a);
  }

  /// Safe time of a ball with respect to `face` (conservative advancement). A jar that rotates
  /// under the ball adds its own accelerations, so the safe time is limited to a rotation of a
  /// twentieth of a radian (evt.4).
  geometry::SafeTime safe_time(int face, const BallState& p, double t, double radius) const {
    if (static_geometry_) {
      if (aligned_)
        return shape_.safe_time(face, {p.position, p.velocity, max_acceleration_}, radius);
      const Vec3 position = mount_.apply_inverse(p.position),
                 velocity = mount_.apply_inverse(p.velocity);
      return shape_.safe_time(face, {position, velocity, max_acceleration_}, radius);
    }
    const double spin = motion_bounds_.spin, horizon = 0.05 / spin;
    const Rotation q = orientation(t);
    const Vec3 position = q.apply_inverse(p.position);
    const Vec3 velocity = q.apply_inverse(p.velocity - cross(motion_.spin(t), p.position));
    const double speed = norm(p.velocity) + max_acceleration_.total * horizon;
    const double most = max_acceleration_.total + 2 * spin * (speed + spin * shape_.reach()) +
                        (spin * spin + motion_bounds_.angular_acceleration) * shape_.reach();
    geometry::SafeTime safe = shape_.safe_time(
        face, {position, velocity, geometry::AccelerationBound({most, most, most})}, radius);
    safe.time = std::min(safe.time, horizon);
    return safe;
  }

  /// The wall at a ball of `radius` [m] at `position` [m].
  Wall wall(int face, const Vec3& position, double t, double radius) const {
    geometry::Gap gap;
    if (static_geometry_ && aligned_) {
      gap = shape_.gap(face, position);
    } else {
      const Rotation q = static_geometry_ ? mount_ : orientation(t);
      gap = shape_.gap(face, q.apply_inverse(position));
      gap.inward = q * gap.inward;
    }
    const Vec3 point = position - radius * gap.inward;
    return {gap.distance - radius, gap.inward, point, cross(motion_.spin(t), point), gap.curvature};
  }

  /// Approximate time [s] until a ball that moves along `face` reaches a jump of its curvature.
  double time_to_curvature_jump(int face, const BallState& p, double t) const {
    const Rotation q = static_geometry_ ? mount_ : orientation(t);
    const Vec3 u = static_geometry_ ? p.velocity : p.velocity - cross(motion_.spin(t), p.position);
    return shape_.time_to_curvature_jump(face, q.apply_inverse(p.position), q.apply_inverse(u));
  }

  /// Kinematic constraint of a ball that stays on the wall.
  struct WallConstraint {
    Vec3 inward;
    Vec3 inward_rate;            ///< [1/s] derivative of `inward`
    double inward_acceleration;  ///< [m/s2] the inward acceleration that keeps the gap zero
  };
  WallConstraint wall_constraint(int face, const BallState& p, double t) const {
    if (static_geometry_ && aligned_) {
      const Vec3 rate = shape_.normal_rate(face, p.position, p.velocity);
      return {shape_.gap(face, p.position).inward, rate, -dot(p.velocity, rate)};
    }
    const Rotation q = static_geometry_ ? mount_ : orientation(t);
    const Vec3 position = q.apply_inverse(p.position),
               inward = q * shape_.gap(face, position).inward;
    if (static_geometry_) {
      const Vec3 rate = q * shape_.normal_rate(face, position, q.apply_inverse(p.velocity));
      return {inward, rate, -dot(p.velocity, rate)};
    }
    const Vec3 w = motion_.spin(t), u = p.velocity - cross(w, p.position);
    const Vec3 rate = q * shape_.normal_rate(face, position, q.apply_inverse(u));
    const Vec3 carried =
        cross(motion_.angular_acceleration(t), p.position) + cross(w, cross(w, p.position));
    return {inward, rate + cross(w, inward), dot(inward, carried + 2 * cross(w, u)) - dot(u, rate)};
  }

 private:
  S shape_;
  M motion_;
  Rotation mount_;
  Vec3 gravity_;
  kinematics::Bounds motion_bounds_;
  // Of a ball in flight, in the jar frame, by components in the mounted jar's axes.
  geometry::AccelerationBound max_acceleration_;
  bool static_geometry_ = true, aligned_ = true;
};

}  // namespace mahlwerk::scene
