// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/contact/law.hpp"
#include "mahlwerk/event/rules.hpp"
#include "mahlwerk/scene/typed_chamber.hpp"

// Equations of motion of a ball in sustained contact with the wall: rolling or sliding on one face,
// or creeping where two or three faces meet (evt.12 to evt.17). The state is that of the jar frame.
namespace mahlwerk::event {

/// State of a ball in sustained contact, with the work done on it and the energy lost, both
/// accumulated over time.
struct ContactState {
  Vec3 position, velocity, spin;
  double work = 0, lost = 0;  // [J]
};
inline ContactState operator+(const ContactState& a, const ContactState& b) {
  return {a.position + b.position, a.velocity + b.velocity, a.spin + b.spin, a.work + b.work,
          a.lost + b.lost};
}
inline ContactState operator*(double s, const ContactState& a) {
  return {s * a.position, s * a.velocity, s * a.spin, s * a.work, s * a.lost};
}

/// Creeping: regularised friction, because the slips at several faces cannot all vanish in general
/// (evt.17).
enum class FrictionState { rolling, sliding, creeping };

/// The one to three faces that support a ball, and the friction state: creeping on several faces,
/// and on the last of them until the others are clear.
struct SupportFaces {
  static constexpr std::size_t max_count = 3;
  std::size_t count = 0;
  std::array<int, max_count> face{};
  FrictionState friction_state = FrictionState::rolling;

  bool has(int which) const {
    for (std::size_t i = 0; i < count; ++i)
      if (face[i] == which) return true;
    return false;
  }
  void add(int which) {
    face[count++] = which;
    if (count > 1) friction_state = FrictionState::creeping;
  }
  void remove(std::size_t index) { face[index] = face[--count]; }
};

struct BallBody {
  double radius = 0, mass = 0, inertia = 0;
  double inertia_ratio = contact::solid_inertia_ratio;  ///< inertia / (mass radius^2)
  double slip_factor() const { return contact::slip_factor(inertia_ratio); }
  /// The ball and a face, for twisting friction.
  contact::EffectivePair twisting_pair(const Rules& rules, int face) const {
    return {rules.twisting->wall(0, face), radius, mass, slip_factor()};
  }
};

/// Forces at an instant.
struct ContactForces {
  std::array<double, SupportFaces::max_count>
      normal_force{};      ///< [m/s2] normal force per mass, < 0: the wall would have to pull
  Vec3 sticking_friction;  ///< [m/s2] friction per mass that would keep the slip constant
  Vec3 friction;           ///< [m/s2] friction per mass
  Vec3 slip;               ///< [m/s] of the touching surfaces

  /// Index in `support` of the face with the smallest normal force.
  std::size_t least(const SupportFaces& support) const {
    std::size_t index = 0;
    for (std::size_t i = 1; i < support.count; ++i)
      if (normal_force[i] < normal_force[index]) index = i;
    return index;
  }
  bool pulls(const SupportFaces& support) const { return normal_force[least(support)] < 0; }
};

/// Linear system of the normal forces: sum_j matrix_ij normal_force_j = rhs_i. The matrix is
/// diagonally dominant by columns (evt.23), so Gaussian elimination needs no pivoting.
struct NormalForceSystem {
  std::size_t count = 0;
  std::array<std::array<double, SupportFaces::max_count>, SupportFaces::max_count>
      matrix;  ///< the first `count` rows and columns are set
  std::array<double, SupportFaces::max_count> rhs{};

  std::array<double, SupportFaces::max_count> solve() {
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t i = k + 1; i < count; ++i) {
        const double factor = matrix[i][k] / matrix[k][k];
        for (std::size_t j = k; j < count; ++j) matrix[i][j] -= factor * matrix[k][j];
        rhs[i] -= factor * rhs[k];
      }
    for (std::size_t i = count; i-- > 0;) {
      for (std::size_t j = i + 1; j < count; ++j) rhs[i] -= matrix[i][j] * rhs[j];
      rhs[i] /= matrix[i][i];
    }
    return rhs;
  }
};

template <class J>
class SustainedContact {
 public:
  SustainedContact(const J& jar, const BallBody& ball, const Rules& rules)
      : jar_(&jar), ball_(ball), rules_(rules) {}

  /// Time derivative of the state at `t` [s]; writes the forces to `forces`. All calls inside are
  /// inlined, because this function is most of the cost of a contact. The function itself is not
  /// inlined into every Runge-Kutta stage.
  [[gnu::flatten, gnu::noinline]] ContactState rate(const SupportFaces& support, double t,
                                                    const ContactState& y,
                                                    ContactForces& forces) const {
    const kinematics::FrameMotion frame = jar_->motion().frame_motion(t);
    const Vec3 body_acceleration = jar_->gravity() - frame.acceleration;  // (evt.1)
    return support.friction_state == FrictionState::creeping
               ? in_edge(support, t, y, frame.velocity, body_acceleration, forces)
               : on_face(support, t, y, frame.velocity, body_acceleration, forces);
  }

  /// Normal force of the wall per mass [m/s2], < 0 if the ball leaves (evt.12).
  double normal_acceleration(int face, double t, const Vec3& position, const Vec3& velocity) const {
    const auto constraint = jar_->wall_constraint(face, {position, velocity}, t);
    const Vec3 body_acceleration = jar_->gravity() - jar_->motion().frame_motion(t).acceleration;
    return constraint.inward_acceleration - dot(body_acceleration, constraint.inward);
  }

  /// Slip of the touching surfaces [m/s].
  Vec3 slip(int face, double t, const ContactState& y) const {
    const Wall wall = jar_->wall(face, y.position, t, ball_.radius);
    return tangential_part(y.velocity - wall.velocity - ball_.radius * cross(y.spin, wall.inward),
                           wall.inward);
  }

  /// Projects the state onto the wall: no gap, no normal speed. A rolling ball gets no slip,
  /// either: the spin follows from the velocity of the centre.
  void project_onto_wall(const SupportFaces& support, double t, ContactState& y) const {
    for (std::size_t i = 0; i < support.count; ++i) {
      const Wall wall = jar_->wall(support.face[i], y.position, t, ball_.radius);
      y.position -= wall.gap * wall.inward;
      y.velocity -= dot(y.velocity - wall.velocity, wall.inward) * wall.inward;
    }
    if (support.friction_state == FrictionState::rolling && rules_.sustained_friction > 0) {
      const Wall wall = jar_->wall(support.face[0], y.position, t, ball_.radius);
      const Vec3 u = y.velocity - wall.velocity;
      // R w x n = u has the solution w = n x u / R across n; the spin about n is free.
      y.spin = dot(y.spin, wall.inward) * wall.inward + cross(wall.inward, u) / ball_.radius;
    }
  }

  /// Ends the remaining slip by an impulse of the wall, as a bounce with e_t = 0 does (evt.7).
  void stick(int face, double t, ContactState& y) const {
    const Wall wall = jar_->wall(face, y.position, t, ball_.radius);
    const Vec3 u = slip(face, t, y);
    const double before = energy(t, y), factor = ball_.slip_factor(), share = 1 / factor;
    const double work =
        -share * ball_.mass * dot(u, jar_->motion().frame_motion(t).velocity + wall.velocity);
    y.velocity -= share * u;
    y.spin += (factor - 1) / (factor * ball_.radius) * cross(wall.inward, u);
    y.work += work;
    y.lost += before + work - energy(t, y);
  }

  double energy(double t, const ContactState& y) const {  // [J] kinetic, laboratory axes
    const Vec3 v = y.velocity + jar_->motion().frame_motion(t).velocity;
    return 0.5 * ball_.mass * squared(v) + 0.5 * ball_.inertia * squared(y.spin);
  }

 private:
  // [m/s] friction is regularised below this slip: the direction of a vanishing slip is undefined
  // and would turn by any angle in one step.
  static constexpr double slip_regularisation = 1e-5;

  /// Unit direction of a slip; shorter where the slip is not fast against `slow` [m/s].
  static Vec3 along(const Vec3& slip, double slow) {
    return slip / std::sqrt(squared(slip) + slow * slow);
  }

  /// Torque over mass [m2/s2] of a face against the relative spin `turning` [rad/s]: rolling
  /// resistance by a constant directional torque (type A), and twisting friction; regularised where
  /// the ball hardly turns (evt.16, evt.27).
  Vec3 resisting_torque(int face, const Vec3& turning, const Vec3& inward,
                        double normal_force) const {
    constexpr double spin_regularisation = 0.1;  // [rad/s]
    const Vec3 w = tangential_part(turning, inward);
    const double limit = rules_.rolling_friction * ball_.radius * std::max(normal_force, 0.0);
    const Vec3 rolling =
        -(limit / std::sqrt(squared(w) + spin_regularisation * spin_regularisation)) * w;
    if (!rules_.twisting || !(normal_force > 0)) return rolling;
    const double spin = dot(turning, inward);
    const double most =
        2.0 / 3 * rules_.sustained_friction * contact_radius(face, normal_force) * normal_force;
    return rolling - most * spin /
                         std::sqrt(spin * spin + spin_regularisation * spin_regularisation) *
                         inward;
  }

  /// Hertz's contact radius [m] under a normal force over mass [m/s2] (evt.27).
  double contact_radius(int face, double normal_force) const {
    const contact::EffectivePair pair = ball_.twisting_pair(rules_, face);
    return math::cbrt(0.75 * ball_.mass * normal_force * pair.radius / pair.pair.modulus);
  }

  ContactState on_face(const SupportFaces& support, double t, const ContactState& y,
                       const Vec3& centre_velocity, const Vec3& body_acceleration,
                       ContactForces& forces) const {
    const double r = ball_.radius, spin_gain = 1 / ball_.inertia_ratio;
    const auto constraint = jar_->wall_constraint(support.face[0], {y.position, y.velocity}, t);
    const Vec3 n = constraint.inward, w = jar_->motion().spin(t), point = y.position - r * n;
    const Vec3 wall = cross(w, point);
    const double normal_force =
        constraint.inward_acceleration - dot(body_acceleration, n);  // (evt.12)
    const Vec3 slip = tangential_part(y.velocity - wall - r * cross(y.spin, n), n);
    const Vec3 torque = resisting_torque(support.face[0], y.spin - w, n, normal_force);

    // Friction per mass that keeps the slip constant: d(slip)/dt = 0 (evt.13).
    const Vec3 wall_rate = cross(jar_->motion().angular_acceleration(t), point) +
                           cross(w, y.velocity - r * constraint.inward_rate);
    const Vec3 sticking_friction =
        1 / ball_.slip_factor() *
        tangential_part(wall_rate + r * cross(y.spin, constraint.inward_rate) - body_acceleration +
                            spin_gain / r * cross(torque, n),
                        n);
    Vec3 friction = sticking_friction;
    if (support.friction_state == FrictionState::sliding)  // (evt.14)
      friction = -(rules_.sustained_friction * std::max(normal_force, 0.0)) *
                 along(slip, slip_regularisation);
    // Member by member: a whole object would be zeroed first.
    forces.normal_force = {normal_force, 0, 0};
    forces.sticking_friction = sticking_friction;
    forces.friction = friction;
    forces.slip = slip;
    const Vec3 wall_force = normal_force * n + friction;  // per mass
    return {y.velocity, body_acceleration + wall_force,
            spin_gain / (r * r) * (torque - r * cross(n, friction)),
            ball_.mass * (dot(wall_force, centre_velocity + wall) + dot(torque, w)),
            -ball_.mass * (dot(friction, slip) + dot(torque, y.spin - w))};
  }

  /// Two or three faces support the ball, or one face near another. Each face adds one unknown, its
  /// normal force, and one equation, no acceleration relative to the face along its normal.
  /// Friction is viscous below the creeping speed (evt.17).
  ContactState in_edge(const SupportFaces& support, double t, const ContactState& y,
                       const Vec3& centre_velocity, const Vec3& body_acceleration,
                       ContactForces& forces) const {
    constexpr double creeping_speed = 1e-3;  // [m/s] below it friction is viscous
    constexpr double max_friction = 0.7;     // above it normal forces are not unique (evt.23)
    const double r = ball_.radius, mu = std::min(rules_.sustained_friction, max_friction);
    const double spin_gain = 1 / ball_.inertia_ratio;
    const Vec3 w = jar_->motion().spin(t);
    std::array<Vec3, SupportFaces::max_count> n, wall, slip,
        friction_ratio;  // friction per normal force
    NormalForceSystem p;
    p.count = support.count;
    for (std::size_t i = 0; i < support.count; ++i) {
      const auto constraint = jar_->wall_constraint(support.face[i], {y.position, y.velocity}, t);
      n[i] = constraint.inward;
      p.rhs[i] = constraint.inward_acceleration - dot(body_acceleration, n[i]);
      wall[i] = cross(w, y.position - r * n[i]);
      slip[i] = tangential_part(y.velocity - wall[i] - r * cross(y.spin, n[i]), n[i]);
      friction_ratio[i] = -mu * along(slip[i], creeping_speed);
    }
    for (std::size_t i = 0; i < support.count; ++i)
      for (std::size_t j = 0; j < support.count; ++j)
        p.matrix[i][j] = i == j ? 1 : dot(n[i], n[j] + friction_ratio[j]);
    forces.normal_force = p.solve();
    forces.slip = slip[0];
    ContactState d{y.velocity, body_acceleration, {}, 0, 0};
    for (std::size_t i = 0; i < support.count; ++i) {
      const double normal_force = forces.normal_force[i];
      const Vec3 friction = std::max(normal_force, 0.0) * friction_ratio[i];
      const Vec3 torque = resisting_torque(support.face[i], y.spin - w, n[i], normal_force),
                 wall_force = normal_force * n[i] + friction;
      d.velocity += wall_force;
      d.spin += spin_gain / (r * r) * (torque - r * cross(n[i], friction));
      d.work += ball_.mass * (dot(wall_force, centre_velocity + wall[i]) + dot(torque, w));
      d.lost -= ball_.mass * (dot(friction, slip[i]) + dot(torque, y.spin - w));
    }
    return d;
  }

  const J* jar_;
  BallBody ball_;
  Rules rules_;
};

}  // namespace mahlwerk::event
