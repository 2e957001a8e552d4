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

/// A ball's centre and velocity in the jar frame at an instant.
struct Passing {
  Vec3 position, velocity;  ///< [m], [m/s]
};

/// A wall as a ball meets it, in the jar frame.
struct Wall {
  double gap;     ///< [m] of the ball
  Vec3 inward;    ///< unit normal, into the jar
  Vec3 point;     ///< [m] of contact
  Vec3 velocity;  ///< [m/s] of the wall's material there
  double bend;    ///< [1/m] its largest curvature there, > 0 concave
};

/// A chamber whose shape is known when it is compiled, so that the search is straight arithmetic;
/// `M` has what a motion has (tests count how often it is asked).
///
/// A jar that does not turn, or turns about the axis it is symmetric to, looks the same at all
/// times: its geometry is that of the mounted jar, and only its wall moves along itself.
template <geometry::Shape S, class M = kinematics::ChosenMotion>
class Jar {
 public:
  Jar(const S& shape, const M& motion, const scene::Chamber& chamber)
      : shape_(shape), motion_(motion), mount_(chamber.mount), gravity_(chamber.gravity) {
    const Vec3 axis = motion.fixed_axis();
    const bool along = S::axisymmetric && norm(cross(axis, mount_.ez)) < 1e-12;
    limits_ = motion.bounds();
    looks_still_ = limits_.spin == 0 || along;
    aligned_ = mount_ == Rotation{};
    const Vec3 most = limits_.acceleration + magnitude(gravity_);
    const Rotation back{mount_.back({1, 0, 0}), mount_.back({0, 1, 0}), mount_.back({0, 0, 1})};
    pull_ = geometry::Pull(bound_of_rotated(back, most));
  }

  const S& shape() const { return shape_; }
  const M& motion() const { return motion_; }
  const Vec3& gravity() const { return gravity_; }
  const kinematics::Bounds& limits() const { return limits_; }
  bool looks_still() const { return looks_still_; }
  /// How fast its wall may come towards a ball at rest, by turning [m/s].
  double sweep() const { return looks_still_ ? 0 : limits_.spin * shape_.reach(); }

  /// Its own axes are always those of the jar frame.
  bool plain() const { return looks_still_ && aligned_; }
  /// Axes in which its geometry can be asked, from them to the jar frame's.
  Rotation axes(double t) const { return looks_still_ ? mount_ : turned(t); }
  /// From the jar's own axes to the jar frame's, at the mill's own time `t`.
  Rotation turned(double t) const { return motion_.turn(t) * mount_; }

  /// A vector of the jar frame in the jar's own turning axes.
  Vec3 own(const Vec3& a, double t) const {
    if (limits_.spin == 0) return aligned_ ? a : mount_.back(a);
    return turned(t).back(a);
  }

  /// What `face` can promise a passing ball. A jar that turns under the ball adds its own
  /// accelerations, so its promise is kept to a twentieth of a radian (evt.4).
  geometry::Outlook outlook(int face, const Passing& p, double t, double radius) const {
    if (looks_still_) {
      if (aligned_) return shape_.outlook(face, {p.position, p.velocity, pull_}, radius);
      const Vec3 place = mount_.back(p.position), velocity = mount_.back(p.velocity);
      return shape_.outlook(face, {place, velocity, pull_}, radius);
    }
    const double spin = limits_.spin, horizon = 0.05 / spin;
    const Rotation q = turned(t);
    const Vec3 place = q.back(p.position);
    const Vec3 velocity = q.back(p.velocity - cross(motion_.spin(t), p.position));
    const double speed = norm(p.velocity) + pull_.whole * horizon;
    const double most = pull_.whole + 2 * spin * (speed + spin * shape_.reach()) +
                        (spin * spin + limits_.spin_rate) * shape_.reach();
    geometry::Outlook look =
        shape_.outlook(face, {place, velocity, geometry::Pull({most, most, most})}, radius);
    look.time = std::min(look.time, horizon);
    return look;
  }

  /// The wall under a ball of `radius` at `position`.
  Wall wall(int face, const Vec3& position, double t, double radius) const {
    geometry::Gap gap;
    if (looks_still_ && aligned_) {
      gap = shape_.gap(face, position);
    } else {
      const Rotation q = looks_still_ ? mount_ : turned(t);
      gap = shape_.gap(face, q.back(position));
      gap.inward = q * gap.inward;
    }
    const Vec3 point = position - radius * gap.inward;
    return {gap.distance - radius, gap.inward, point, cross(motion_.spin(t), point), gap.curvature};
  }

  /// About when a ball that runs along `face` comes to where the wall's curvature is another [s].
  double until_crease(int face, const Passing& p, double t) const {
    const Rotation q = looks_still_ ? mount_ : turned(t);
    const Vec3 u = looks_still_ ? p.velocity : p.velocity - cross(motion_.spin(t), p.position);
    return shape_.until_crease(face, q.back(p.position), q.back(u));
  }

  /// How a wall holds a ball that stays on it.
  struct Hold {
    Vec3 inward;
    Vec3 inward_rate;  ///< [1/s]
    double bend;       ///< [m/s2] the inward acceleration that keeps the gap zero
  };
  Hold hold(int face, const Passing& p, double t) const {
    if (looks_still_ && aligned_) {
      const Vec3 rate = shape_.normal_rate(face, p.position, p.velocity);
      return {shape_.gap(face, p.position).inward, rate, -dot(p.velocity, rate)};
    }
    const Rotation q = looks_still_ ? mount_ : turned(t);
    const Vec3 place = q.back(p.position), inward = q * shape_.gap(face, place).inward;
    if (looks_still_) {
      const Vec3 rate = q * shape_.normal_rate(face, place, q.back(p.velocity));
      return {inward, rate, -dot(p.velocity, rate)};
    }
    const Vec3 w = motion_.spin(t), u = p.velocity - cross(w, p.position);
    const Vec3 rate = q * shape_.normal_rate(face, place, q.back(u));
    const Vec3 carried = cross(motion_.spin_rate(t), p.position) + cross(w, cross(w, p.position));
    return {inward, rate + cross(w, inward), dot(inward, carried + 2 * cross(w, u)) - dot(u, rate)};
  }

 private:
  S shape_;
  M motion_;
  Rotation mount_;
  Vec3 gravity_;
  kinematics::Bounds limits_;
  geometry::Pull pull_;  // on a ball in flight, in the jar frame, in the mounted jar's axes
  bool looks_still_ = true, aligned_ = true;
};

}  // namespace mahlwerk::scene
