// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

namespace mahlwerk::contact {

/// Normal restitution e_n: one number, or one that depends on the speed of approach.
class Restitution {
 public:
  enum class Law { constant, viscoelastic, tabulated };
  using Points = std::vector<std::pair<double, double>>;  ///< speed [m/s] and e_n

  Restitution(double value) : value_(value) {}  // NOLINT: a number is a restitution

  /// Viscoelastic spheres with e_n = `value`, in (0, 1], at the speed `at_speed` [m/s] (evt.20).
  static Restitution viscoelastic(double value, double at_speed);
  /// Linear in the logarithm of the speed between points, constant beyond the ends (evt.21). Speeds
  /// are above 0 and rise, values lie in [0, 1], or it throws std::invalid_argument.
  static Restitution tabulated(Points speed_and_value);

  /// e_n of a collision at `approach` [m/s].
  double at(double approach) const {
    if (law_ == Law::constant) [[likely]]
      return value_;
    return speed_dependent(approach);
  }

  Law law() const { return law_; }
  double value() const { return value_; }           ///< constant; viscoelastic: at speed()
  double speed() const { return speed_; }           ///< [m/s] viscoelastic: where value() holds
  const Points& points() const { return points_; }  ///< tabulated
  bool operator==(const Restitution&) const = default;

 private:
  double speed_dependent(double approach) const;

  Law law_ = Law::constant;
  double value_ = 1, speed_ = 0;
  double scale_ = 0;  // [(s/m)^(1/5)] viscoelastic: beta
  Points points_;
};

}  // namespace mahlwerk::contact
