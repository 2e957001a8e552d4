// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "mahlwerk/kinematics/motion.hpp"

namespace mahlwerk::kinematics {

/// One sample of a measured motion.
struct Sample {
  double time = 0;   ///< [s]
  Vec3 centre;       ///< [m]
  double angle = 0;  ///< [rad] rotation about the jar's axis
  bool operator==(const Sample&) const = default;
};

/// A measured motion, repeated periodically: the twice continuously differentiable periodic cubic
/// spline through its samples. The last sample closes the period; its centre equals that of the
/// first, its angle may differ (kin.8).
class Tabulated {
 public:
  static constexpr std::string_view name = "tabulated";
  static constexpr std::string_view about = "a measured motion, repeated for ever";
  static constexpr Vec3 jar_axis = upright;
  static constexpr auto fields() { return std::array<Field<Tabulated>, 0>{}; }

  Tabulated() = default;
  /// Needs at least four samples with increasing times. Throws std::invalid_argument that names the
  /// faulty sample. The angle turns the jar about its mounted axis `axis` (unit vector).
  explicit Tabulated(std::vector<Sample> samples, Vec3 axis = upright);

  FrameMotion frame_motion(double t) const;
  Rotation rotation(double t) const;
  Vec3 spin(double t) const;
  Vec3 angular_acceleration(double t) const;
  Vec3 fixed_axis() const { return turns_ ? axis_ : Vec3{}; }
  Bounds bounds() const { return bounds_; }
  double period() const { return period_; }
  const std::vector<Sample>& samples() const { return samples_; }
  bool operator==(const Tabulated& o) const { return samples_ == o.samples_ && axis_ == o.axis_; }

 private:
  static constexpr int channels = 4;  // x, y, z, angle
  struct Piece {  // value + slope s + second s^2/2 + third s^3/6, s since its knot
    std::array<double, channels> value, slope, second, third;
  };
  struct SplinePoint {
    const Piece* piece;
    double since;  // [s] since the knot of the piece
    double cycle;  // number of whole periods before
  };
  SplinePoint find(double t) const;
  double at(const SplinePoint& p, int channel, int order) const;
  void compute_bounds();

  std::vector<Sample> samples_;
  std::vector<double> knots_;
  std::vector<Piece> pieces_;
  Bounds bounds_;
  Vec3 axis_ = upright;
  double period_ = no_period, angle_per_period_ = 0;
  bool turns_ = false;
};

}  // namespace mahlwerk::kinematics
