// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

namespace mahlwerk::contact {

/// Normal restitution e_n: constant, or a function of the approach speed.
class Restitution {
 public:
  enum class Law { constant, viscoelastic, tabulated };
  using Points = std::vector<std::pair<double, double>>;  ///< speed [m/s] and e_n

  Restitution(double value) : value_(value) {}  // NOLINT: a number is a restitution

  /// Viscoelastic spheres with e_n = `value`, in (0, 1], at the speed `at_speed` [m/s] > 0
  /// (evt.20). Throws std::invalid_argument for other values.
  static Restitution viscoelastic(double value, double at_speed);
  /// Interpolates linearly in the logarithm of the speed, constant beyond the ends (evt.21). Throws
  /// std::invalid_argument unless there is a point, speeds are > 0 and increase, and values lie in
  /// [0, 1].
  static Restitution tabulated(Points speed_and_value);

  /// e_n of a collision at `approach` [m/s].
  double at(double approach) const {
    if (law_ == Law::constant) [[likely]]
      return value_;
    return speed_dependent(approach);
  }

  Law law() const { return law_; }
  double value() const { return value_; }  ///< constant: e_n; viscoelastic: e_n at speed()
  double speed() const { return speed_; }  ///< [m/s] viscoelastic: speed at which e_n is value()
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
