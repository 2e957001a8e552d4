// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "mahlwerk/geometry/near_facets.hpp"
#include "mahlwerk/geometry/shape.hpp"
#include "mahlwerk/kinematics/any_motion.hpp"
#include "mahlwerk/kinematics/motion.hpp"
#include "mahlwerk/scene/wall_load.hpp"
#include "mahlwerk/soft/kernel/ball_record.hpp"
#include "mahlwerk/soft/kernel/body_blocks.hpp"
#include "mahlwerk/soft/kernel/periodic.hpp"
#include "mahlwerk/soft/walls/drive_sample.hpp"

namespace mahlwerk::soft {

/// A ball near a face. The wall point is not updated while the ball has moved by less than `slack`
/// since the neighbour list was built: until then the ball cannot touch the face.
struct WallNeighbour {
  std::int32_t ball = 0, face = 0;
  double within = 0;  ///< [m] cutoff: larger distances need not be exact
  double slack = 0;   ///< [m]
};

/// Eight wall contact points: faces, and where the numbers of their balls are, as in GatherMap.
/// Derived from WallNeighbour.
struct alignas(64) WallPointLanes {
  std::array<const double*, lanes> ball{};  ///< address of BodyBlock::position.x
  Lanes face{};
};

/// Wall for the soft engines (that of the event engine is event::MovingWall): a jar on its mill,
/// with shape and motion types erased. Times are mill times [s], positions [m] and velocities [m/s]
/// those of the jar frame.
class MovingWall {
 public:
  virtual ~MovingWall() = default;

  virtual void sample_drive(double start, double step, std::int64_t first,
                            std::span<DriveSample> out) const = 0;
  virtual kinematics::FrameMotion frame_motion(double t) const = 0;
  virtual Vec3 spin(double t) const = 0;
  virtual WallAxes axes(double t) const = 0;
  /// Distance and inward normal of a face at `position`. A distance above `within` [m] may be
  /// overestimated. `facets` may be those that the last query of the ball has left.
  virtual geometry::Gap gap(int face, const Vec3& position, const WallAxes& axes, double within,
                            geometry::NearFacets* facets = nullptr) const = 0;
  /// The distance of gap() alone.
  virtual double gap_distance(int face, const Vec3& position, const WallAxes& axes, double within,
                              geometry::NearFacets* facets) const = 0;
  /// Distances of `position` from every face [m]. Up to `within`, each is a lower bound of the
  /// distance of gap() and Lipschitz continuous with constant 1; a greater distance may give any
  /// number above `within`.
  virtual void distances(const Vec3& position, const WallAxes& axes, double within,
                         std::span<double> out) const = 0;
  virtual double distance(int face, const Vec3& position, const WallAxes& axes,
                          double within) const = 0;
  /// Updates the wall contact points of balls near a face, in the order of `near`, with the
  /// velocity and spin of the wall there; those of balls that cannot touch yet possibly only if
  /// `all`. A wall contact point is the point of a face nearest to a ball's centre. `near_lanes`
  /// are the same neighbours in blocks of eight. `facets` has one element for each if
  /// keeps_near_facets(); otherwise it is not read.
  virtual void wall_points(std::span<WallNeighbour> near,
                           std::span<const WallPointLanes> near_lanes, double t,
                           const DriveSample& drive, const BodyBlock* bodies,
                           const BallBlock* balls, BodyBlock* points, bool all,
                           geometry::NearFacets* facets) const = 0;
  /// Wall points of eight balls, for the lanes in `touching` (bits); other lanes may be inexact.
  /// Exact for gaps up to `beyond` [m]. `facets` as above, eight of them.
  virtual void wall_points(const BallRecord* rows, const std::array<std::int32_t, lanes>& balls,
                           const std::array<std::int32_t, lanes>& faces, std::uint32_t touching,
                           const WallAxes& axes, double beyond, Vec<Lanes>& points,
                           geometry::NearFacets* facets) const = 0;
  /// Safe time [s] of a ball in free flight: a duration from `t` in which it touches no face.
  virtual double safe_time(const Vec3& position, const Vec3& velocity, double t,
                           double radius) const = 0;
  /// The two principal curvatures of a face at the wall point of a ball at `position` [1/m], larger
  /// one first.
  virtual std::pair<double, double> curvatures(int face, const Vec3& position, double t) const = 0;
  /// Transforms a vector to the axes that turn with a face; to the jar axes if face < 0 (two
  /// balls).
  virtual Vec3 to_face_axes(const Vec3& a, double t, int face) const = 0;
  /// The same for a point of the jar frame [m]; the axes of a part have their origin in the part.
  virtual Vec3 to_face_point(const Vec3& p, double t, int face) const {
    return to_face_axes(p, t, face);
  }
  /// Motion of the material of a face: its velocity at the origin of the jar frame [m/s], and its
  /// spin [rad/s].
  struct FaceMotion {
    Vec3 velocity, spin;
  };
  FaceMotion face_motion(int face, const DriveSample& drive, const WallAxes& axes) const {
    if (face >= first_part_face_) {
      const scene::PartPose& pose = axes.parts[part_motion_of(face)];
      return {pose.velocity, pose.spin};
    }
    return {{}, face < first_rotor_face_ ? drive.spin : drive.rotor_spin};
  }
  virtual bool can_touch(int face, double radius) const = 0;

  /// A contact force at a wall in one step.
  struct WallForce {
    int face = 0;
    Vec3 point;   ///< [m] of contact
    Vec3 force;   ///< [N] on the ball
    Vec3 torque;  ///< [N m] on the wall, that of its zero radius aside
  };
  /// Number of bodies whose loads are summed: the jar and its parts; 0: none.
  virtual std::size_t load_count() const { return 0; }
  /// Adds a force that acts for `dt` [s] to the loads.
  virtual void add_load(std::span<scene::WallLoad> /*loads*/, const WallForce& /*force*/,
                        const WallAxes& /*axes*/, const DriveSample& /*drive*/,
                        double /*dt*/) const {}

  /// The drive of the mill, which the engine advances; null if the speed of the mill is given.
  virtual kinematics::Drive* drive() const { return nullptr; }

  const Vec3& gravity() const { return gravity_; }
  int faces() const { return faces_; }
  int first_rotor_face() const { return first_rotor_face_; }  ///< first face of the rotor, if any
  /// First face of the parts in the jar; without parts the number of faces.
  int first_part_face() const { return first_part_face_; }
  /// Largest speed at which the wall may approach a ball at rest in the jar frame [m/s].
  double max_wall_speed() const { return max_wall_speed_; }
  double reach() const { return reach_; }  ///< [m] largest distance of the wall from the centre
  /// Whether nothing of the jar moves, at any time.
  bool stands_still() const { return stands_still_; }
  /// Upper bound of the speed of the wall in the laboratory frame [m/s].
  double max_lab_wall_speed(double t) const {
    const double turning = first_rotor_face_ < faces_ ? std::max(max_wall_speed_, part_speed_) : 0;
    return norm(frame_motion(t).velocity) + norm(spin(t)) * reach_ + turning;
  }
  /// Whether wall points need less time if facets are kept for each ball and face.
  bool keeps_near_facets() const { return keeps_near_facets_; }
  const Vec3& periods() const { return periods_; }  ///< [m] infinite where not periodic
  /// The image of a position within half a period of the middle of a jar with walls. In a periodic
  /// box without walls positions stay as they are.
  Vec3 within_period(const Vec3& position) const {
    return faces_ > 0 && is_periodic(periods_) ? nearest_image(position, periods_) : position;
  }

 protected:
  std::size_t part_motion_of(int face) const {
    return motion_of_part_face_[static_cast<std::size_t>(face - first_part_face_)];
  }

  Vec3 gravity_, periods_;
  int faces_ = 0, first_rotor_face_ = 0, first_part_face_ = 0;
  double max_wall_speed_ = 0, reach_ = 0;
  double part_speed_ = 0;  // [m/s] bound of the speed of the parts in the jar frame
  std::vector<std::size_t> motion_of_part_face_;  // index of WallAxes::parts
  bool keeps_near_facets_ = false, stands_still_ = false;
};

}  // namespace mahlwerk::soft
