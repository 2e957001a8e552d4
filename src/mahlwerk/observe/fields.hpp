// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::observe {

/// Where the charge is on average, and how it moves there, on a square grid in a plane (obs.5):
/// each ball's mass is shared out among the four cells whose middles are nearest. In fixed memory.
class PlaneField {
 public:
  static constexpr int cells = 48;  ///< along each side

  /// From -`half` to `half` [m] both ways.
  explicit PlaneField(double half = 1) : half_(half), sums_(std::size_t{cells} * cells) {}

  /// A ball of `mass` [kg] at (x, y) [m] that moves with (u, v) [m/s] in the plane and whose
  /// squared speed is `speed2`; `weight` [s] is the time it stands for.
  void add(double x, double y, double u, double v, double speed2, double mass, double weight);
  /// Those of one time have been added: `weight` [s] more of time.
  void add_time(double weight) { time_ += weight; }

  double half() const { return half_; }
  double time() const { return time_; }
  double cell_area() const { return 4 * half_ * half_ / (cells * cells); }  // [m2]
  /// Means over time of the cell in column `i` (x) and row `j` (y), of what is above each area of
  /// the plane; velocity is that of the mass there, 0 without any.
  double density(int i, int j) const;         ///< [kg/m2]
  double velocity_x(int i, int j) const;      ///< [m/s]
  double velocity_y(int i, int j) const;      ///< [m/s]
  double kinetic_energy(int i, int j) const;  ///< [J/m2], of the balls' flight

  void merge(const PlaneField& other);  ///< of the same size
  void serialize(Archive& archive) { archive(sums_)(time_); }

 private:
  struct Sum {
    double mass = 0, x = 0, y = 0, kinetic = 0;  // times s
  };
  const Sum& at(int i, int j) const {
    return sums_[static_cast<std::size_t>(j) * cells + static_cast<std::size_t>(i)];
  }
  double half_, time_ = 0;
  std::vector<Sum> sums_;
};

}  // namespace mahlwerk::observe
