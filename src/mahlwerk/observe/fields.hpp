// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/observe/packed_array.hpp"

namespace mahlwerk::observe {

/// Time-averaged density and velocity of the charge on a square grid in a plane (obs.5). A ball's
/// mass is distributed to the four cells with the nearest centres (cloud in cell). Uses fixed
/// memory.
class PlaneField {
 public:
  static constexpr int cells = 48;  ///< along each side

  PlaneField() = default;  ///< without mass and without memory; nothing may be added
  /// A grid from -`half` to `half` [m] in both directions.
  explicit PlaneField(double half) : half_size_(half), sums_(std::size_t{cells} * cells) {}

  /// Adds a ball of `mass` [kg] at (x, y) [m] with velocity (u, v) [m/s] in the plane and squared
  /// speed `speed2` [m2/s2], for a duration of `weight` [s].
  void add(double x, double y, double u, double v, double speed2, double mass, double weight);
  /// Adds `weight` [s] to the time. Call it after adding all balls of a sample.
  void add_time(double weight) { time_ += weight; }

  double half() const { return half_size_; }
  double time() const { return time_; }
  double cell_area() const { return 4 * half_size_ * half_size_ / (cells * cells); }  // [m2]
  /// Means over time of the cell in column `i` (x) and row `j` (y), per area of the plane. The
  /// velocity is the mean velocity of the mass there; 0 without mass.
  double density(int i, int j) const;         ///< [kg/m2]
  double velocity_x(int i, int j) const;      ///< [m/s]
  double velocity_y(int i, int j) const;      ///< [m/s]
  double kinetic_energy(int i, int j) const;  ///< [J/m2], translational

  void merge(const PlaneField& other);  ///< of the same size
  void pack() { sums_.pack(); }         ///< nothing is added from then on
  void let_go() { sums_.let_go(); }     ///< the sums of the cells are forgotten
  void serialize(Archive& archive) {
    sums_.serialize(archive);
    archive(time_);
  }

 private:
  struct Sum {
    double mass = 0, x = 0, y = 0, kinetic = 0;  // integrals over time
  };
  Sum at(int i, int j) const {
    if (sums_.size() == 0) return {};
    return sums_[static_cast<std::size_t>(j) * cells + static_cast<std::size_t>(i)];
  }
  double half_size_ = 1, time_ = 0;
  PackedArray<Sum> sums_;
};

}  // namespace mahlwerk::observe
