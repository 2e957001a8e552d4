// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "mahlwerk/event/search.hpp"

namespace mahlwerk::event {

/// What a ball may count on.
struct Sighting {
  double time = 0;  ///< [s] of the touch, or until when there is certainly none
  int face = -1;    ///< < 0: no touch
};

/// A jar on its mill with its types hidden: one call per question, for an engine of many balls.
/// Times are the mill's own; places and velocities those of the jar frame.
class Enclosure {
 public:
  virtual ~Enclosure() = default;

  virtual kinematics::Ride ride(double t) const = 0;
  /// Follows a ball that is `ball` at `t` and flies freely, until it touches, `until` is passed, or
  /// after most_search_steps; looks at least once.
  virtual Sighting look(const Passing& ball, double t, double until,
                        const Feeler& feeler) const = 0;
  virtual Wall wall(int face, const Vec3& position, double t, double radius) const = 0;
  virtual Vec3 own(const Vec3& a, double t) const = 0;

  const kinematics::Bounds& limits() const { return limits_; }
  const Vec3& gravity() const { return gravity_; }
  bool looks_still() const { return looks_still_; }
  int faces() const { return faces_; }
  double period() const { return period_; }         // [s] of the ride
  double reach() const { return reach_; }           // [m]
  double offset() const { return offset_; }         // [m] of the jar's centre at the start
  const Vec3& periods() const { return periods_; }  // [m] infinite where the shape does not repeat

 protected:
  kinematics::Bounds limits_;
  Vec3 gravity_, periods_;
  bool looks_still_ = true;
  int faces_ = 0;
  double period_ = 0, reach_ = 0, offset_ = 0;
};

template <class S, class M>
class Enclosed final : public Enclosure {
 public:
  explicit Enclosed(const Jar<S, M>& jar) : jar_(jar) {
    limits_ = jar.limits();
    gravity_ = jar.gravity();
    periods_ = geometry::periods_of(jar.shape());
    looks_still_ = jar.looks_still();
    faces_ = S::faces;
    period_ = jar.motion().period();
    reach_ = jar.shape().reach();
    offset_ = norm(jar.motion().ride(0).centre);
  }

  kinematics::Ride ride(double t) const override { return jar_.motion().ride(t); }
  Sighting look(const Passing& ball, double t, double until, const Feeler& feeler) const override {
    const Glance first = glance(jar_, {t, {}, ball}, feeler);
    if (first.face >= 0) return {t, first.face};
    const double step =
        std::max(first.clear, feeler.least_step(norm(ball.velocity) + jar_.sweep()));
    if (!(t + step < until)) return {std::max(t + step, std::nextafter(t, geometry::never)), -1};
    const kinematics::Ride ride = jar_.motion().ride(t);
    const Flight flight{t, ball.position + ride.centre, ball.velocity + ride.velocity};
    const Touch touch = next_touch(jar_, flight, {t, ride, ball}, until, feeler);
    return {touch.when.time, touch.face};
  }
  Wall wall(int face, const Vec3& position, double t, double radius) const override {
    return jar_.wall(face, position, t, radius);
  }
  Vec3 own(const Vec3& a, double t) const override { return jar_.own(a, t); }

 private:
  Jar<S, M> jar_;
};

}  // namespace mahlwerk::event
