// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/kinematics/drive.hpp"

#include <algorithm>
#include <cmath>

namespace mahlwerk::kinematics {
namespace {

/// Cubic through two states with their rates.
template <class State>
Clock between(const State& a, const State& b, double t) {
  const double h = b.time - a.time, u = (t - a.time) / h, d = (b.clock - a.clock) / h;
  const double second = 3 * d - 2 * a.rate - b.rate, third = a.rate + b.rate - 2 * d;
  return {a.clock + h * u * (a.rate + u * (second + u * third)),
          a.rate + u * (2 * second + 3 * u * third), (2 * second + 6 * u * third) / h};
}

}  // namespace

double Motor::torque_at(double rate) const {
  if (kind == Kind::linear) return torque * (1 - rate);
  const double slip = 1 - rate, k = breakdown_slip;
  return torque * 2 * slip * k / (slip * slip + k * k);
}

Drive::Drive(const Motor& motor, double speed) : motor_(motor), speed_(speed) {
  restart(0);
}

double Drive::acceleration_bound() const {
  return 1 / shortest_time();
}

void Drive::restart(double time) {
  kept_.clear();
  recent_.assign(1, {.time = time, .rate = motor_.start_speed / std::abs(speed_)});
  recent_.back().acceleration = acceleration(recent_.back().rate, 0, 0);
  impulse_ = motor_work_ = 0;
}

Clock Drive::clock(double t) const {
  if (t >= recent_.front().time || kept_.empty()) {
    auto state = recent_.end() - 1;
    while (state != recent_.begin() && t < state->time) --state;
    return state->at(t);
  }
  const auto later = std::ranges::upper_bound(kept_, t, {}, &State::time);
  if (later == kept_.begin()) return later->at(t);
  return between(*(later - 1), later == kept_.end() ? recent_.front() : *later, t);
}

/// The torque of the motor is that in the middle of the step.
double Drive::acceleration(double rate, double load, double step) const {
  const double momentum = motor_.inertia * std::abs(speed_);
  double found = (motor_.torque_at(rate) + load) / momentum;
  for (int again = 0; again < 3; ++again)
    found = (motor_.torque_at(rate + 0.5 * step * found) + load) / momentum;
  return found;
}

void Drive::advance(double time, double impulse, bool keep) {
  const State& from = now();
  const double step = time - from.time;
  if (!(step > 0)) return;
  const Clock at = from.at(time);
  motor_work_ = motor_work(time);
  const double load = std::copysign((impulse - impulse_) / step, speed_ * (impulse - impulse_));
  impulse_ = impulse;
  const State next{time, at.time, at.rate, acceleration(at.rate, load, step)};
  if (keep) {
    kept_.push_back(recent_.front());
    recent_.clear();
  }
  recent_.push_back(next);
}

double Drive::kinetic(double time) const {
  return 0.5 * motor_.inertia * speed(time) * speed(time);
}

double Drive::motor_work(double time) const {
  const double step = time - now().time, middle = now().rate + 0.5 * step * now().acceleration;
  return motor_work_ + motor_.torque_at(middle) * middle * std::abs(speed_) * step;
}

double Drive::shortest_time() const {
  // Largest slope of the torque over the rate: linear, or of Kloss at the speed without load.
  const double slope = motor_.kind == Motor::Kind::linear ? 1 : 2 / motor_.breakdown_slip;
  return motor_.inertia * std::abs(speed_) / (std::max(slope, largest_rate) * motor_.torque);
}

bool Drive::too_fast() const {
  return !(std::abs(now().rate) <= largest_rate);
}

void Drive::serialize(Archive& archive) {
  archive(kept_)(recent_)(impulse_)(motor_work_);
  if (recent_.empty()) throw Archive::broken();
}

}  // namespace mahlwerk::kinematics
