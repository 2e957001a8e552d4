// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "mahlwerk/geometry/shape.hpp"
#include "mahlwerk/kinematics/motion.hpp"
#include "mahlwerk/soft/kernel/ball_record.hpp"

namespace mahlwerk::soft {

/// The jar's motion sampled at one step, in the jar frame.
struct DriveSample {
  Vec3 body_acceleration;  ///< [m/s2] gravity less the acceleration of the jar's centre
  Vec3 velocity;           ///< [m/s] of the jar's centre
  Vec3 spin;               ///< [rad/s] of the jar
  Vec3 rotor_spin;         ///< [rad/s] of faces that turn by themselves
};

/// Of a radius: how far beyond touch a wall point is still found for balls that have just left it
/// (dem.36).
constexpr double past_touch = 0.01;

/// A ball near a face. Its wall point need not be found anew while the ball has moved by less than
/// `slack` since the neighbour list was built: the ball is then even farther from any point.
struct WallNeighbour {
  std::int32_t ball = 0, face = 0;
  double within = 0;  ///< [m] farther away it does not matter how far the face is
  double slack = 0;   ///< [m]
};

/// Columns of the balls' positions and of their wall points. A wall point is the point of a face
/// nearest to a ball's centre; it moves as the wall there does.
struct WallPointColumns {
  const double *x, *y, *z;  // [m] of the balls
  const double*
      displacement_squared;  // [m2] squared, since the list was built; null: every point is due
  double *px, *py, *pz;      // [m] of the wall points
  double *pu, *pv, *pw;      // [m/s]
  double *sx, *sy, *sz;      // [rad/s] spin of the wall
};

/// A jar on its mill with its types hidden. Times are the mill's own; positions and velocities
/// those of the jar frame.
class MovingWall {
 public:
  virtual ~MovingWall() = default;

  virtual void sample_drive(double start, double step, std::int64_t first,
                            std::span<DriveSample> out) const = 0;
  virtual kinematics::FrameMotion frame_motion(double t) const = 0;
  virtual Vec3 spin(double t) const = 0;
  /// Where a ball at `position` meets a face; any larger distance where it is not `within` [m].
  virtual geometry::Gap gap(int face, const Vec3& position, double t, double within) const = 0;
  /// How far `position` is from every face [m], any larger number where it is not `within`. At most
  /// the distance of gap(), and changes by no more than one moves.
  virtual void distances(const Vec3& position, double t, double within,
                         std::span<double> out) const = 0;
  virtual double distance(int face, const Vec3& position, double t, double within) const = 0;
  /// The wall points of the balls near a face.
  virtual void wall_points(std::span<const WallNeighbour> near, double t, const DriveSample& drive,
                           const WallPointColumns& positions) const = 0;
  /// The wall points of eight balls that touch a face each; faces matter up to `beyond` [m] from a
  /// ball's surface.
  virtual void wall_points(const BallRecord* rows, const std::array<std::int32_t, lanes>& balls,
                           const std::array<std::int32_t, lanes>& faces, const LaneMask& touching,
                           double t, double beyond, AlignedLanes (&points)[3]) const = 0;
  /// A time in which a ball in free flight certainly touches no wall [s].
  virtual double safe_time(const Vec3& position, const Vec3& velocity, double t,
                           double radius) const = 0;
  /// The wall's two principal curvatures where a ball's centre at `position` looks at it [1/m].
  virtual std::pair<double, double> curvatures(int face, const Vec3& position, double t) const = 0;
  /// A vector in the axes that a face turns with; of balls (face < 0) those of the jar.
  virtual Vec3 to_face_axes(const Vec3& a, double t, int face) const = 0;
  virtual bool meets(int face, double radius) const = 0;

  const Vec3& gravity() const { return gravity_; }
  int faces() const { return faces_; }
  int turning_from() const { return turning_from_; }  ///< faces that turn by themselves, if any
  double sweep() const { return sweep_; }  ///< [m/s] how fast its wall may come to a ball at rest
  double reach() const { return reach_; }  ///< [m]
  /// As fast as any point of the walls moves, or faster [m/s].
  double max_wall_speed(double t) const {
    const double turning = turning_from_ < faces_ ? sweep_ : 0;
    return norm(frame_motion(t).velocity) + norm(spin(t)) * reach_ + turning;
  }
  const Vec3& periods() const { return periods_; }  ///< [m] infinite where it does not repeat

 protected:
  Vec3 gravity_, periods_;
  int faces_ = 0, turning_from_ = 0;
  double sweep_ = 0, reach_ = 0;
};

}  // namespace mahlwerk::soft
