// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/event/lift_limit.hpp"
#include "mahlwerk/event/search.hpp"
#include "mahlwerk/event/sustained_contact.hpp"

// Time integration of a sustained contact: the embedded Runge-Kutta pair of Dormand and Prince of
// orders 5 and 4, with step-size control (evt.18).
namespace mahlwerk::event {

struct IntegrationStep {
  ContactState end, rate;  ///< state at the end of the step, and its derivative
  ContactForces forces;    ///< at the end
  double error = 0;        ///< relative to the tolerance; the step is accepted up to 1
};

/// One step of `h` [s] from the state `y` at `t` [s]. `rate(t, y, forces)` is the derivative,
/// `first` its value at the start; `radius` [m] of the ball; `energy` [J] that of a ball as fast as
/// the wall, the scale of errors of the work. A ball at rest on a wall that moves up and down has
/// no other error.
template <class Rate>
IntegrationStep dormand_prince_step(const Rate& rate, double t, const ContactState& y,
                                    const ContactState& first, double h, double radius,
                                    double energy) {
  const ContactState& k1 = first;
  ContactForces forces;
  const ContactState k2 = rate(t + h / 5, y + h / 5 * k1, forces);
  const ContactState k3 = rate(t + 3 * h / 10, y + h * (3.0 / 40 * k1 + 9.0 / 40 * k2), forces);
  const ContactState k4 =
      rate(t + 4 * h / 5, y + h * (44.0 / 45 * k1 + -56.0 / 15 * k2 + 32.0 / 9 * k3), forces);
  const ContactState k5 = rate(t + 8 * h / 9,
                               y + h * (19372.0 / 6561 * k1 + -25360.0 / 2187 * k2 +
                                        64448.0 / 6561 * k3 + -212.0 / 729 * k4),
                               forces);
  const ContactState k6 =
      rate(t + h,
           y + h * (9017.0 / 3168 * k1 + -355.0 / 33 * k2 + 46732.0 / 5247 * k3 + 49.0 / 176 * k4 +
                    -5103.0 / 18656 * k5),
           forces);
  const ContactState end = y + h * (35.0 / 384 * k1 + 500.0 / 1113 * k3 + 125.0 / 192 * k4 +
                                    -2187.0 / 6784 * k5 + 11.0 / 84 * k6);
  const ContactState k7 = rate(t + h, end, forces);
  const ContactState error_estimate =
      h * (71.0 / 57600 * k1 + -71.0 / 16695 * k3 + 71.0 / 1920 * k4 + -17253.0 / 339200 * k5 +
           22.0 / 525 * k6 + -1.0 / 40 * k7);
  constexpr double relative_tolerance = 1e-8;
  const double speed = norm(end.velocity) + radius * norm(end.spin) + 1e-3;  // [m/s] floor
  const double error = std::max({norm(error_estimate.position) / (relative_tolerance * radius),
                                 norm(error_estimate.velocity) / (relative_tolerance * speed),
                                 radius * norm(error_estimate.spin) / (relative_tolerance * speed),
                                 std::abs(error_estimate.work) / (relative_tolerance * energy)});
  return {end, k7, forces, error};
}

/// Integrates the motion of a ball in sustained contact with the wall.
template <class J>
class SustainedContactIntegrator {
 public:
  enum class Status { in_contact, released, touched };

  SustainedContactIntegrator(const J& jar, const BallBody& ball, const Rules& rules,
                             const TouchTolerance& tolerance)
      : jar_(&jar), contact_(jar, ball, rules), ball_(ball), rules_(rules), tolerance_(tolerance) {
    constexpr double least_speed = 1e-3;  // [m/s]
    const double speed = jar.motion_bounds().speed + jar.max_wall_speed() + least_speed;
    wall_energy_ = ball.mass * speed * speed;
  }

  /// Begins at `t` [s] with the ball on the faces of `support`. On a single face the ball rolls or
  /// slides, depending on its slip.
  void begin(SupportFaces support, double t, const ContactState& y) {
    support_ = support;
    state_ = y;
    step_ = 1e-5;
    rate_known_ = false;
    if (support_.count == 1) choose_friction_state(t);
    last_step_ = {t, 0, state_, {}, support_, 0, 0};
  }

  /// Takes one step from `t` [s] and sets `t` to its end. `state()` is the state after the step.
  /// Returns whether the ball is still in contact, was released by the wall, or touched another
  /// face fast enough to bounce.
  Status advance(double& t) {
    const auto rate = [this](double at, const ContactState& y, ContactForces& forces) {
      return contact_.rate(support_, at, y, forces);
    };
    if (support_.count == 1 && support_.friction_state == FrictionState::creeping &&
        clear_of_others(t))
      begin(support_, t, state_);
    if (!rate_known_) rate_ = rate(t, state_, forces_);
    if (support_.friction_state != FrictionState::creeping && update_friction_state(t))
      rate_ = rate(t, state_, forces_);
    if (release_pulling_faces(t)) return Status::released;

    const double curvature_jump_time = time_to_curvature_jump(t);
    const double wanted =
        lift_limit(*jar_, support_, forces_, state_.position, ball_.radius, t,
                   std::min({step_, slide_limit(), safe_time_of_others(t), curvature_jump_time}));
    double h = wanted;
    IntegrationStep s = dormand_prince_step(rate, t, state_, rate_, h, ball_.radius, wall_energy_);
    while (!(s.error <= 1)) {
      h *= s.error > 1 ? std::clamp(0.9 * math::pow(s.error, -0.2), 0.1, 0.9) : 0.1;
      s = dormand_prince_step(rate, t, state_, rate_, h, ball_.radius, wall_energy_);
    }
    // A step shortened for other reasons says nothing about the error.
    if (h < wanted || wanted == step_)
      step_ = h * std::clamp(0.9 * math::pow(s.error + 1e-12, -0.2), 0.2, 3.0);
    if (leaves_wall(t + h, s)) {
      h = bisect_release_time(rate, t, h);
      s = dormand_prince_step(rate, t, state_, rate_, h, ball_.radius, wall_energy_);
    }
    last_step_ = {t, h, state_, rate_, support_, 0, 0};
    t += h;
    state_ = s.end;
    rate_ = s.rate;
    forces_ = s.forces;
    rate_known_ = h < curvature_jump_time;  // beyond it the derivative differs
    contact_.project_onto_wall(support_, t, state_);
    const Status status = resolve_other_touches(t) ? Status::touched : Status::in_contact;
    last_step_.work = state_.work;
    last_step_.lost = state_.lost;
    return status;
  }

  /// The state `ahead` [s] before the end of the last step of advance(), by a shorter step from
  /// its beginning. Work and loss are what the last step adds after it, with the opposite sign.
  ContactState state_before_end(double ahead) const {
    if (!(ahead > 0)) return state_;
    const LastStep& last = last_step_;
    const auto rate = [&](double at, const ContactState& y, ContactForces& forces) {
      return contact_.rate(last.support, at, y, forces);
    };
    const double h = std::max(last.length - ahead, 0.0);
    ContactState y =
        dormand_prince_step(rate, last.begin, last.state, last.rate, h, ball_.radius, wall_energy_)
            .end;
    contact_.project_onto_wall(last.support, last.begin + h, y);
    y.work -= last.work;
    y.lost -= last.lost;
    return y;
  }

  void serialize(Archive& archive) {
    archive(support_)(state_)(rate_)(forces_)(rate_known_)(step_)(last_step_);
    if (support_.count > SupportFaces::max_count ||
        last_step_.support.count > SupportFaces::max_count)
      throw Archive::broken();
  }

  const ContactState& state() const { return state_; }
  ContactState& state() { return state_; }
  const SupportFaces& support() const { return support_; }
  const SustainedContact<J>& contact() const { return contact_; }

 private:
  static constexpr double sticking_speed = 1e-4;  // [m/s] a slower slip may come to rest
  static constexpr double insignificant_time =
      3e-5;  // [s] the body acceleration of no mill changes much in it

  void choose_friction_state(double t) {
    const double mu = rules_.sustained_friction;
    const bool slips = norm(contact_.slip(support_.face[0], t, state_)) > sticking_speed;
    support_.friction_state =
        mu == 0 || (slips && std::isfinite(mu)) ? FrictionState::sliding : FrictionState::rolling;
    if (support_.friction_state == FrictionState::rolling)
      contact_.stick(support_.face[0], t, state_);
    contact_.project_onto_wall(support_, t, state_);
  }

  /// A rolling ball that needs more friction than the Coulomb limit begins to slide. A sliding ball
  /// whose slip has come to rest begins to roll. Returns whether the state changed.
  bool update_friction_state(double t) {
    const double mu = rules_.sustained_friction;
    if (mu == 0 || std::isinf(mu)) return false;
    const double most = mu * std::max(forces_.normal_force[0], 0.0),
                 needed = norm(forces_.sticking_friction);
    if (support_.friction_state == FrictionState::rolling && needed > most) {
      support_.friction_state = FrictionState::sliding;
      return true;
    }
    if (support_.friction_state == FrictionState::sliding && needed <= most &&
        norm(forces_.slip) <= sticking_speed) {
      support_.friction_state = FrictionState::rolling;
      contact_.stick(support_.face[0], t, state_);
      contact_.project_onto_wall(support_, t, state_);
      return true;
    }
    return false;
  }

  /// Longest step [s] for a ball whose slip is coming to rest: it ends before that moment (evt.14).
  double slide_limit() const {
    if (support_.friction_state != FrictionState::sliding) return geometry::never;
    const double speed = norm(forces_.slip);
    if (speed <= sticking_speed) return geometry::never;
    const double slowing = ball_.slip_factor() *
                           dot(forces_.sticking_friction - forces_.friction, forces_.slip) /
                           speed;  // [m/s2]
    return slowing > 0 ? 0.9 * speed / slowing : geometry::never;
  }

  /// Longest step [s] up to a jump of the wall's curvature, which no Runge-Kutta step should
  /// straddle. Steps cover nine tenths of the way until less than `short_way` is left; one more
  /// step then crosses the jump.
  double time_to_curvature_jump(double t) const {
    constexpr double short_way = 1e-8;  // [s]
    double earliest = geometry::never;
    for (std::size_t i = 0; i < support_.count; ++i) {
      const int face = support_.face[i];
      double time = jar_->time_to_curvature_jump(face, {state_.position, state_.velocity}, t);
      if (time < step_)  // again with the mean velocity on the way
        time = jar_->time_to_curvature_jump(
            face, {state_.position, state_.velocity + 0.5 * time * rate_.velocity}, t);
      earliest = std::min(earliest, time > short_way ? 0.9 * time : time + min_step());
    }
    return std::max(earliest, min_step());
  }

  double min_step() const {
    return tolerance_.min_step(norm(state_.velocity) + jar_->max_wall_speed());
  }

  /// Calls `visit(face)` for every face that the ball could touch but does not rest on.
  template <class Visit>
  void for_each_other(const Visit& visit) const {
    for (int face = 0; face < jar_->shape().faces; ++face)
      if (!support_.has(face) && jar_->shape().can_touch(face, ball_.radius)) visit(face);
  }

  /// Step [s] in which no other face is touched fast enough to bounce. A touch too slow to bounce
  /// is allowed, because a ball that has just left a face or lies next to it would else advance in
  /// tiny steps.
  double safe_time_of_others(double t) const {
    double clear = geometry::never;
    for_each_other([&](int face) {
      double time = std::max(safe_time(face, t, state_).time, min_step());
      if (time < insignificant_time) time = std::max(time, slow_approach_time(face, t));
      clear = std::min(clear, time);
    });
    return clear;
  }

  /// Time [s] in which the ball gains less than `sustained_speed` towards a face at twice its
  /// present acceleration relative to the face, at most insignificant_time.
  double slow_approach_time(int face, double t) const {
    const auto constraint = jar_->wall_constraint(face, {state_.position, state_.velocity}, t);
    const double relative_acceleration =
        std::abs(dot(rate_.velocity, constraint.inward) - constraint.inward_acceleration);
    return rules_.sustained_speed /
           (2 * relative_acceleration + rules_.sustained_speed / insignificant_time);
  }

  /// Whether the ball is so far from all other faces that it no longer has to creep.
  bool clear_of_others(double t) const {
    bool apart = true;
    for_each_other(
        [&](int face) { apart = apart && safe_time(face, t, state_).gap > 1e-3 * ball_.radius; });
    return apart;
  }

  /// Whether another face is touched fast enough to bounce. A face that is touched more slowly
  /// joins the support. It is released again as soon as its normal force turns out to be negative.
  bool resolve_other_touches(double t) {
    bool bounces = false;
    for_each_other([&](int face) {
      const geometry::SafeTime safe = safe_time(face, t, state_);
      if (safe.gap <= 2 * tolerance_.margin && safe.closing > 0 && !try_join_support(face, t))
        bounces = true;
    });
    return bounces;
  }

  /// Adds a touched face to the support if the ball approaches it slowly; the remaining normal
  /// speed is lost. Returns whether the face joined.
  bool try_join_support(int face, double t) {
    const Wall wall = jar_->wall(face, state_.position, t, ball_.radius);
    const double closing = dot(wall.velocity - state_.velocity, wall.inward);
    if (closing >= rules_.sustained_speed || support_.count == SupportFaces::max_count)
      return false;
    const Vec3 change = closing * wall.inward;
    const double before = contact_.energy(t, state_);
    const double work =
        ball_.mass * dot(change, jar_->motion().frame_motion(t).velocity + wall.velocity);
    state_.velocity += change;
    state_.work += work;
    state_.lost += before + work - contact_.energy(t, state_);
    support_.add(face);
    rate_known_ = false;
    return true;
  }
  geometry::SafeTime safe_time(int face, double t, const ContactState& y) const {
    return jar_->safe_time(face, {y.position, y.velocity}, t, ball_.radius - tolerance_.margin);
  }

  /// Releases faces that would have to pull, the one that would pull most first; the ball may stay
  /// on the others. Returns true if the ball leaves the last face.
  bool release_pulling_faces(double t) {
    while (forces_.pulls(support_)) {
      if (support_.count == 1) return true;
      support_.remove(forces_.least(support_));
      rate_ = contact_.rate(support_, t, state_, forces_);
    }
    return false;
  }

  /// Whether a step ends with a face that pulls or with the ball beyond another face.
  bool leaves_wall(double t, const IntegrationStep& s) const {
    bool through = false;
    for_each_other([&](int face) {
      const geometry::SafeTime safe = safe_time(face, t, s.end);
      through = through || (safe.gap < 0 && safe.closing > 0);
    });
    return through || s.forces.pulls(support_);
  }

  /// Shortest step [s] at whose end leaves_wall() holds. By bisection, because leaves_wall() is not
  /// a smooth function.
  template <class Rate>
  double bisect_release_time(const Rate& rate, double t, double h) const {
    double holds = 0, leaves = h;
    for (int i = 0; i < 60 && leaves - holds > min_step(); ++i) {
      const double middle = 0.5 * (holds + leaves);
      const IntegrationStep s =
          dormand_prince_step(rate, t, state_, rate_, middle, ball_.radius, wall_energy_);
      (leaves_wall(t + middle, s) ? leaves : holds) = middle;
    }
    return leaves;
  }

  /// What the last step began with, and its length.
  struct LastStep {
    double begin = 0, length = 0;  // [s]
    ContactState state, rate;
    SupportFaces support;
    double work = 0, lost = 0;  // [J] at its end
  };

  const J* jar_;
  SustainedContact<J> contact_;
  BallBody ball_;
  Rules rules_;
  TouchTolerance tolerance_;
  SupportFaces support_;
  ContactState state_;
  ContactState rate_;  // derivative of now_, and the forces in it, if rate_known_
  ContactForces forces_;
  bool rate_known_ = false;
  double step_ = 1e-5;  // [s] from the step-size control
  LastStep last_step_;
  double wall_energy_ = 0;  // [J]
};

}  // namespace mahlwerk::event
