// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/kinematics/speed_program.hpp"

// A mill that a motor turns (kin.24): its speed follows from the torques of motor and charge. Its
// motion is that of the mill at full speed, X(s), by a clock s(t), as with a speed over time.
namespace mahlwerk::kinematics {

/// The motor of a mill, and what it turns.
struct Motor {
  enum class Kind { linear, induction };
  Kind kind = Kind::linear;
  double inertia = 0;  ///< [kg m2] of jar and drive, about the axis of the mill, without balls
  /// [N m] linear: at standstill; induction: the largest (breakdown torque); 0: no motor
  double torque = 0;
  double breakdown_slip = 0.2;  ///< [1] of an induction motor: slip at the largest torque
  double start_speed = 0;       ///< [rad/s] of the mill when a run begins
  bool operator==(const Motor&) const = default;

  /// [N m] Torque at a share `rate` of the speed without load (kin.25).
  double torque_at(double rate) const;
};

/// A mill with a motor, in the course of a run. The engine that computes the balls advances it;
/// all who hold the motion of this run see it. Not thread-safe while it advances.
class Drive {
 public:
  static constexpr double largest_rate = 1.25;  ///< of the speed without load

  /// `speed` [rad/s] of the mill without load, not 0.
  Drive(const Motor& motor, double speed);

  /// Time of the mill at full speed, at the time `t` [s] of the run.
  Clock clock(double t) const;
  double acceleration_bound() const;  ///< [1/s] of the motor alone

  void restart(double time);
  /// Goes on to `time` [s]. `impulse` [N m s] is what the balls have given the mill about its axis
  /// since restart(); its mean torque since the last call acts until the next.
  /// `keep`: the state is kept for clock(); between kept ones it is interpolated.
  void advance(double time, double impulse, bool keep);

  // At a time not before the last advance().
  /// [rad/s], [rad] In the sense of the mill.
  double speed(double time) const { return std::abs(speed_) * now().at(time).rate; }
  double angle(double time) const { return std::abs(speed_) * now().at(time).time; }
  double kinetic(double time) const;     ///< [J] without balls
  double motor_work(double time) const;  ///< [J] since restart()
  /// [s] In which the motor alone would change the rate by 1 at most; infinite without a motor.
  double shortest_time() const;
  bool too_fast() const;  ///< beyond largest_rate
  const Motor& motor() const { return motor_; }

  void serialize(Archive& archive);

 private:
  struct State {
    double time = 0, clock = 0, rate = 0, acceleration = 0;  // [s], [s], [1], [1/s]
    Clock at(double t) const {
      const double dt = t - time;
      return {clock + (rate + 0.5 * acceleration * dt) * dt, rate + acceleration * dt,
              acceleration};
    }
  };
  const State& now() const { return recent_.back(); }
  /// [1/s] of the rate over the next `step` [s], under the torque `load` [N m] of the balls.
  double acceleration(double rate, double load, double step) const;

  Motor motor_;
  double speed_;               // [rad/s]
  std::vector<State> kept_;    // up to the first of recent_
  std::vector<State> recent_;  // all since then, at least one
  double impulse_ = 0;         // [N m s] at the last advance()
  double motor_work_ = 0;      // [J] until then
};

}  // namespace mahlwerk::kinematics
