// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/contact/any_law.hpp"
#include "mahlwerk/contact/law.hpp"

namespace mahlwerk::lammps {

/// The undisturbed collision of a pair, by which the speed at first touch follows from what LAMMPS
/// tells of a contact (lmp.8, lmp.9). With the dampers of hertz-mindlin and linear-spring, all
/// collisions of a pair are one curve of overlap and its rate, in units that the speed sets.
/// Computed once, by Runge-Kutta steps of order 4.
class Impact {
 public:
  /// The law must be hertz-mindlin or linear-spring.
  Impact(const contact::AnyLaw& law, const contact::EffectivePair& pair);

  /// [m/s] Speed at first touch of a collision with this largest overlap [m] (lmp.8).
  double speed_of_largest(double overlap) const;

  /// A collision, found from one instant of it.
  struct Found {
    double speed = 0;  ///< [m/s] at first touch
    double since = 0;  ///< [s] since first touch
    double lasts = 0;  ///< [s] whole collision
  };
  /// From an overlap > 0 [m] and its rate [m/s], > 0 while the bodies approach (lmp.9).
  Found found(double overlap, double rate) const;

  /// [s] Duration of a collision at `speed` > 0 [m/s].
  double duration(double speed) const;

  double mass() const { return mass_; }  ///< [kg] m*
  double restitution() const { return restitution_; }
  double friction() const { return friction_; }
  /// [1] Tangential over normal force soon after first touch, for a sliding speed equal to the
  /// approach.
  double spring_ratio() const { return spring_ratio_; }

 private:
  /// [m/s] Speed whose collision has the overlap `x` where this one has 1.
  double scale(double overlap, double x) const;

  struct Instant {
    double time, overlap, rate;
    double phase;  ///< rate / overlap^exponent, which falls all the time
  };
  std::vector<Instant> curve_;
  double exponent_;   ///< speed ~ overlap^exponent
  double frequency_;  ///< speed / overlap^exponent in units of the curve
  double largest_ = 0;
  double mass_, restitution_, friction_, spring_ratio_;
};

}  // namespace mahlwerk::lammps
