// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/walls/part_wall.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "mahlwerk/geometry/safe_time.hpp"
#include "mahlwerk/geometry/solids.hpp"

namespace mahlwerk::soft {
namespace {

/// A motion that parts have in common.
struct SharedMotion {
  kinematics::PartMotion motion;
  bool in_laboratory = false;
  bool operator==(const SharedMotion&) const = default;
};

/// A part as its faces need it.
struct Part {
  geometry::AnySolid solid;
  Rotation axes;  // from its own axes to those of its frame before the motion
  Vec3 position;  // [m] of its origin there
  std::size_t motion = 0;
  double reach = 0;    // [m] from its origin; infinite for a plane
  double opening = 0;  // [m]
  // Of the torque of its load, in its frame before the motion: that of its motion, or its own.
  Vec3 load_axis, load_centre;
  bool turns_with_jar = false, on_shaft = false;
};

/// Whether the geometry of a part stays as it is while it moves, because it turns about its own
/// axis of revolution.
bool keeps_its_place(const scene::MachinePart& part) {
  const kinematics::PartMotion& m = part.motion;
  if (!m.moves()) return true;
  const bool turns = m.kind == kinematics::PartMotion::Kind::turning ||
                     m.kind == kinematics::PartMotion::Kind::swinging;
  const bool round = std::visit(
      []<class S>(const S&) {
        return requires(const S s) {
          s.frustum();
        };
      },
      *part.solid);
  const bool flat = std::holds_alternative<geometry::PlaneSolid>(*part.solid);
  constexpr double rounding = 1e-12;
  if (!turns || !(round || flat) || norm(cross(part.axes.ez, m.axis)) > rounding) return false;
  const Vec3 off = part.position - m.pivot;
  return flat || norm(off - dot(off, m.axis) * m.axis) < rounding * (1 + norm(off));
}

class WallWithParts final : public MovingWall {
 public:
  WallWithParts(std::unique_ptr<const MovingWall> jar, const scene::Chamber& chamber)
      : jar_(std::move(jar)), motion_(chamber.motion), mount_(chamber.mount) {
    gravity_ = jar_->gravity();
    periods_ = jar_->periods();
    reach_ = jar_->reach();
    first_rotor_face_ = jar_->first_rotor_face();
    first_part_face_ = jar_->faces();
    faces_ = first_part_face_;
    max_wall_speed_ = jar_->max_wall_speed();
    stands_still_ = false;  // the loads of parts grow even while all is at rest
    keeps_near_facets_ = jar_->keeps_near_facets();
    const Vec3 turns = kinematics::fixed_axis(*motion_);
    jar_turns_ = norm(turns) > 0;
    drive_axis_ = jar_turns_ ? turns : mount_.ez;
    for (const scene::MachinePart& part : chamber.parts) add(part);
  }

  void sample_drive(double start, double step, std::int64_t first,
                    std::span<DriveSample> out) const override {
    jar_->sample_drive(start, step, first, out);
  }
  kinematics::FrameMotion frame_motion(double t) const override { return jar_->frame_motion(t); }
  Vec3 spin(double t) const override { return jar_->spin(t); }
  WallAxes axes(double t) const override {
    WallAxes found = jar_->axes(t);
    for (std::size_t k = 0; k < motions_.size(); ++k) found.parts[k] = pose(k, t);
    return found;
  }

  geometry::Gap gap(int face, const Vec3& position, const WallAxes& axes, double within,
                    geometry::NearFacets* facets) const override {
    if (face < first_part_face_) return jar_->gap(face, position, axes, within, facets);
    return part_gap(face, position, axes.parts[part_motion_of(face)], within);
  }
  double gap_distance(int face, const Vec3& position, const WallAxes& axes, double within,
                      geometry::NearFacets* facets) const override {
    if (face < first_part_face_) return jar_->gap_distance(face, position, axes, within, facets);
    return part_gap(face, position, axes.parts[part_motion_of(face)], within).distance;
  }
  void distances(const Vec3& position, const WallAxes& axes, double within,
                 std::span<double> out) const override {
    jar_->distances(position, axes, within, out.first(static_cast<std::size_t>(first_part_face_)));
    for (int face = first_part_face_; face < faces_; ++face)
      out[static_cast<std::size_t>(face)] = distance(face, position, axes, within);
  }
  double distance(int face, const Vec3& position, const WallAxes& axes,
                  double within) const override {
    if (face < first_part_face_) return jar_->distance(face, position, axes, within);
    const Face& f = of(face);
    const Vec3 p = in_own_axes(f, position, axes.parts[part_motion_of(face)]);
    const Part& part = parts_[f.part];
    if (squared(p) > (part.reach + within) * (part.reach + within)) return geometry::not_near;
    return std::visit([&](const auto& s) { return s.distance(f.own, p, within); }, part.solid);
  }

  void wall_points(std::span<WallNeighbour> near, std::span<const WallPointLanes> near_lanes,
                   double t, const DriveSample& drive, const BodyBlock* bodies,
                   const BallBlock* balls, BodyBlock* points, bool all,
                   geometry::NearFacets* facets) const override {
    if (first_part_face_ > 0)
      jar_->wall_points(near, near_lanes, t, drive, bodies, balls, points, all, facets);
    std::array<scene::PartPose, max_part_motions> poses;
    for (std::size_t k = 0; k < motions_.size(); ++k) poses[k] = pose(k, t);
    for (std::size_t k = 0; k < near.size(); ++k) {
      if (near[k].face < first_part_face_) continue;
      const auto b = static_cast<std::size_t>(near[k].ball) / lanes,
                 l = static_cast<std::size_t>(near[k].ball) % lanes;
      const scene::PartPose& at = poses[part_motion_of(near[k].face)];
      const Vec3 position = get_lane(bodies[b].position, l);
      const geometry::Gap gap = part_gap(near[k].face, position, at, near[k].within);
      // A face that is not near has any normal: along a period its point would be an image near by.
      const bool beyond = is_periodic(periods_) && !(gap.distance < geometry::not_near);
      const Vec3 point = beyond ? position + out_of_reach() : position - gap.distance * gap.inward;
      BodyBlock& block = points[k / lanes];
      set_lane(block.position, k % lanes, point);
      set_lane(block.velocity, k % lanes, at.velocity_at(point));
      set_lane(block.angular_velocity, k % lanes, at.spin);
    }
  }
  void wall_points(const BallRecord* rows, const std::array<std::int32_t, lanes>& balls,
                   const std::array<std::int32_t, lanes>& faces, std::uint32_t touching,
                   const WallAxes& axes, double beyond, Vec<Lanes>& points,
                   geometry::NearFacets* facets) const override {
    std::array<std::int32_t, lanes> of_jar = faces;
    std::uint32_t at_jar = touching;
    for (std::size_t k = 0; k < lanes; ++k)
      if (faces[k] >= first_part_face_) of_jar[k] = 0, at_jar &= ~(1U << k);
    if (at_jar != 0)
      jar_->wall_points(rows, balls, of_jar, at_jar, axes, beyond, points, facets);
    else
      points = {};
    for (std::size_t k = 0; k < lanes; ++k) {
      if (faces[k] < first_part_face_ || (touching >> k & 1) == 0) continue;
      const BallRecord& ball = rows[balls[k]];
      const Vec3 position = ball.position();
      const geometry::Gap gap = part_gap(faces[k], position, axes.parts[part_motion_of(faces[k])],
                                         (1 + past_touch) * ball.radius + beyond);
      set_lane(points, k, position - gap.distance * gap.inward);
    }
  }

  double safe_time(const Vec3& position, const Vec3& velocity, double t,
                   double radius) const override {
    double least = jar_->safe_time(position, velocity, t, radius);
    const WallAxes at = axes(t);
    for (int face = first_part_face_; face < faces_; ++face) {
      if (!can_touch(face, radius)) continue;
      const double gap = distance(face, position, at, geometry::not_near) - radius;
      least = std::min(least,
                       geometry::plane_safe_time(gap, norm(velocity) + max_wall_speed_, max_pull_));
    }
    return least;
  }
  std::pair<double, double> curvatures(int face, const Vec3& position, double t) const override {
    if (face < first_part_face_) return jar_->curvatures(face, position, t);
    const Face& f = of(face);
    const Vec3 p = in_own_axes(f, position, pose(part_motion_of(face), t));
    return std::visit(
        [&](const auto& s) -> std::pair<double, double> {
          const geometry::Gap gap = s.gap(f.own, p, geometry::not_near);
          const Vec3 n = gap.inward, side = std::abs(n.z) < 0.6 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
          const Vec3 a0 = cross(n, side), a = a0 / norm(a0);  // across the axis of a round part
          const double k = -dot(a, s.normal_rate(f.own, p, a));
          return {0, k / (1 + k * gap.distance)};
        },
        parts_[f.part].solid);
  }
  Vec3 to_face_axes(const Vec3& a, double t, int face) const override {
    if (face < first_part_face_) return jar_->to_face_axes(a, t, face);
    return parts_[of(face).part].axes.apply_inverse(
        pose(part_motion_of(face), t).axes.apply_inverse(a));
  }
  Vec3 to_face_point(const Vec3& p, double t, int face) const override {
    if (face < first_part_face_) return jar_->to_face_point(p, t, face);
    return in_own_axes(of(face), p, pose(part_motion_of(face), t));
  }
  std::size_t load_count() const override { return 1 + parts_.size(); }
  kinematics::Drive* drive() const override { return kinematics::drive_of(*motion_); }
  void add_load(std::span<scene::WallLoad> loads, const WallForce& force, const WallAxes& axes,
                const DriveSample& drive, double dt) const override {
    const FaceMotion motion = face_motion(force.face, drive, axes);
    const bool of_jar = force.face < first_part_face_;
    const Part* part = of_jar ? nullptr : &parts_[of(force.face).part];
    const Rotation frame = of_jar ? axes.own : axes.parts[part->motion].axes;
    const Vec3 axis = of_jar ? drive_axis_ : frame * part->load_axis;
    const Vec3 centre =
        of_jar ? Vec3{} : axes.parts[part->motion].origin + frame * part->load_centre;
    const Vec3 velocity = motion.velocity + cross(motion.spin, force.point) + drive.velocity;
    scene::WallLoad& load = loads[of_jar ? 0 : 1 + of(force.face).part];
    load.impulse += dt * frame.apply_inverse(force.force);
    load.angular_impulse += dt * dot(axis, cross(force.point - centre, force.force) - force.torque);
    load.work += dt * (dot(force.force, velocity) - dot(force.torque, motion.spin));
    if (!is_driven(force.face, part)) return;
    const Vec3 lever = force.point - (jar_turns_ ? Vec3{} : centre);
    loads[0].about_mill_axis +=
        dt * dot(jar_turns_ ? drive_axis_ : axis, cross(lever, force.force) - force.torque);
  }
  bool can_touch(int face, double radius) const override {
    if (face < first_part_face_) return jar_->can_touch(face, radius);
    return 2 * radius >= parts_[of(face).part].opening;
  }

 private:
  /// Whether a motor of the mill turns the face: of the jar and what is fixed to it; in a jar at
  /// rest of its stirrer, or of the parts on its shaft.
  bool is_driven(int face, const Part* part) const {
    if (jar_turns_) return part == nullptr || part->turns_with_jar;
    return part == nullptr ? face >= first_rotor_face_ : part->on_shaft;
  }

  struct Face {
    std::size_t part = 0;
    int own = 0;  // number among the faces of its part
  };

  void add(const scene::MachinePart& part) {
    const SharedMotion motion{part.motion, part.in_laboratory};
    const auto known = std::ranges::find(motions_, motion);
    const auto index = static_cast<std::size_t>(known - motions_.begin());
    if (known == motions_.end()) motions_.push_back(motion);
    if (motions_.size() > max_part_motions)
      throw std::invalid_argument("too many different motions of parts");
    const double reach = std::visit([](const auto& s) { return s.reach(); }, *part.solid);
    const auto faces =
        std::visit([](const auto& s) { return static_cast<int>(s.faces); }, *part.solid);
    for (int face = 0; face < faces; ++face) {
      faces_of_parts_.push_back({parts_.size(), face});
      motion_of_part_face_.push_back(index);
    }
    faces_ += faces;
    const bool turns = part.motion.spin_bound() > 0;
    parts_.push_back({*part.solid, part.axes, part.position, index, reach, part.opening,
                      turns ? part.motion.axis : part.axes.ez,
                      turns ? part.motion.pivot : part.position,
                      !part.in_laboratory && !part.motion.moves(), part.motion.turns()});
    bound_speeds(part, reach);
  }

  /// What touches a part is inside the jar, so that no lever is longer than the jar allows.
  void bound_speeds(const scene::MachinePart& part, double reach) {
    const kinematics::Bounds& jar = kinematics::bounds(*motion_);
    const kinematics::PartMotion& m = part.motion;
    const double within = part.in_laboratory ? reach_ + jar_centre_reach() : reach_;
    const double lever = std::min(norm(part.position - m.pivot) + reach, within + norm(m.pivot));
    const double own =
        kinematics::largest_rate(*motion_) * (m.speed_bound() + m.spin_bound() * lever);
    const double carried = part.in_laboratory ? jar.speed : jar.spin * reach_;
    part_speed_ = std::max(part_speed_, own + carried);
    const bool still = keeps_its_place(part) && carried == 0;
    if (!still) max_wall_speed_ = std::max(max_wall_speed_, own + carried);
    const double acceleration = norm(jar.acceleration) + norm(gravity_);
    max_pull_ = std::max(max_pull_, acceleration);
  }
  /// [m] Bound of the distance of the jar's centre from the mill's origin in one period.
  double jar_centre_reach() const {
    const double period = kinematics::period(*motion_);
    double most = norm(kinematics::frame_motion(*motion_, 0).centre);
    if (std::isfinite(period)) most += 0.5 * kinematics::bounds(*motion_).speed * period;
    return most;
  }

  const Face& of(int face) const {
    return faces_of_parts_[static_cast<std::size_t>(face - first_part_face_)];
  }
  scene::PartPose pose(std::size_t motion, double t) const {
    const SharedMotion& m = motions_[motion];
    return scene::part_pose(m.motion, m.in_laboratory, *motion_, mount_, t);
  }
  /// [m] From a ball to a point that it does not touch, nor does an image of it.
  Vec3 out_of_reach() const {
    const auto far = [](double period) {
      return std::isfinite(period) ? 0.5 * period : geometry::not_near;
    };
    return {far(periods_.x), far(periods_.y), far(periods_.z)};
  }
  /// A position in the own axes of a part, in a periodic jar that of the nearest image.
  Vec3 in_own_axes(const Face& face, const Vec3& position, const scene::PartPose& pose) const {
    const Part& part = parts_[face.part];
    Vec3 away = position - pose.origin - pose.axes * part.position;
    if (is_periodic(periods_)) away = nearest_image(away, periods_);
    return part.axes.apply_inverse(pose.axes.apply_inverse(away));
  }
  geometry::Gap part_gap(int face, const Vec3& position, const scene::PartPose& pose,
                         double within) const {
    const Face& f = of(face);
    const Part& part = parts_[f.part];
    const Vec3 p = in_own_axes(f, position, pose);
    geometry::Gap found =
        std::visit([&](const auto& s) { return s.gap(f.own, p, within); }, part.solid);
    found.inward = pose.axes * (part.axes * found.inward);
    return found;
  }

  std::unique_ptr<const MovingWall> jar_;
  Indirect<kinematics::AnyMotion> motion_;
  Rotation mount_;
  std::vector<SharedMotion> motions_;
  std::vector<Part> parts_;
  std::vector<Face> faces_of_parts_;
  Vec3 drive_axis_;  // of the torque of the jar's load
  bool jar_turns_ = false;
  double max_pull_ = 0;  // [m/s2] on a ball in flight, in the jar frame
};

}  // namespace

std::unique_ptr<const MovingWall> wall_with_parts(std::unique_ptr<const MovingWall> jar,
                                                  const scene::Chamber& chamber) {
  return std::make_unique<WallWithParts>(std::move(jar), chamber);
}

}  // namespace mahlwerk::soft
