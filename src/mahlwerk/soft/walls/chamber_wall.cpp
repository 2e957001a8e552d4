// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/walls/chamber_wall.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/geometry/safe_time.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/chosen_motion.hpp"
#include "mahlwerk/scene/typed_chamber.hpp"
#include "mahlwerk/soft/walls/part_wall.hpp"
#include "mahlwerk/soft/walls/wall_point_loop.hpp"

namespace mahlwerk::soft {
namespace {

/// Periods along the axes of the jar frame. The jar's own z axis may lie along any of them; a case
/// ensures that it stays there.
template <class S>
Vec3 laboratory_periods(const scene::TypedChamber<S>& jar) {
  const Vec3 own = geometry::periods_of(jar.shape());
  if (own.x < geometry::never || !(own.z < geometry::never)) return own;
  const Vec3 axis = componentwise_abs(jar.axes(0).ez);
  return {axis.x > 0.5 ? own.z : geometry::never, axis.y > 0.5 ? own.z : geometry::never,
          axis.z > 0.5 ? own.z : geometry::never};
}

template <class S>
class ChamberWall final : public MovingWall {
  static constexpr bool has_rotor = requires(const S s) { s.rotor_speed; };
  static constexpr bool has_facets = geometry::KeepsNearFacets<S>;
  static constexpr bool in_registers = HasLaneGaps<S> && !has_rotor;

 public:
  explicit ChamberWall(const scene::TypedChamber<S>& jar) : jar_(jar) {
    gravity_ = jar.gravity();
    periods_ = laboratory_periods(jar);
    faces_ = first_rotor_face_ = first_part_face_ = jar.shape().faces;
    max_wall_speed_ = jar.max_wall_speed();
    if constexpr (has_rotor) {
      first_rotor_face_ = S::first_rotor_face;
      max_wall_speed_ += jar.motion().largest_rate() * geometry::rotor_tip_speed_of(jar.shape());
    }
    const kinematics::Bounds& moves = jar.motion_bounds();
    stands_still_ = norm(moves.acceleration) + moves.spin + max_wall_speed_ == 0;
    reach_ = jar.shape().reach();
    keeps_near_facets_ = has_facets;
    if constexpr (in_registers) {
      wall_points_ = Multiversioned<WallPointLoop<S>, PointFunction>::best();
      packet_points_ = Multiversioned<PacketPointLoop<S>, PacketPointFunction>::best();
    }
  }

  void sample_drive(double start, double step, std::int64_t first,
                    std::span<DriveSample> out) const override {
    for (std::size_t k = 0; k < out.size(); ++k) {
      const double t = start + static_cast<double>(first + static_cast<std::int64_t>(k)) * step;
      const kinematics::FrameMotion frame = jar_.motion().frame_motion(t);
      const Vec3 spin = jar_.motion().spin(t);
      out[k] = {jar_.gravity() - frame.acceleration, frame.velocity, spin, spin};
      if constexpr (has_rotor)
        out[k].rotor_spin +=
            jar_.motion().clock(t).rate * jar_.shape().rotor_speed * jar_.axes(t).ez;
    }
  }
  kinematics::FrameMotion frame_motion(double t) const override {
    return jar_.motion().frame_motion(t);
  }
  Vec3 spin(double t) const override { return jar_.motion().spin(t); }

  WallAxes axes(double t) const override { return {jar_axes(t), {}}; }

  geometry::Gap gap(int face, const Vec3& position, const WallAxes& axes, double within,
                    geometry::NearFacets* facets) const override {
    const Rotation& q = of_face(axes, face);
    geometry::Gap found = gap_near(face, q.apply_inverse(position), within, facets);
    found.inward = q * found.inward;
    return found;
  }
  double gap_distance(int face, const Vec3& position, const WallAxes& axes, double within,
                      geometry::NearFacets* facets) const override {
    return gap_near(face, of_face(axes, face).apply_inverse(position), within, facets).distance;
  }
  void distances(const Vec3& position, const WallAxes& axes, double within,
                 std::span<double> out) const override {
    const Vec3 p = jar_.axis_aligned() ? position : axes.own.apply_inverse(position);
    geometry::distances(jar_.shape(), p, within, out);
    if constexpr (has_rotor)
      for (int face = S::first_rotor_face; face < faces_; ++face)
        out[static_cast<std::size_t>(face)] = gap(face, position, axes, within, nullptr).distance;
  }
  double distance(int face, const Vec3& position, const WallAxes& axes,
                  double within) const override {
    const Vec3 p = of_face(axes, face).apply_inverse(position);
    return geometry::distance(jar_.shape(), face, p, within);
  }
  void wall_points(std::span<WallNeighbour> near, std::span<const WallPointLanes> near_lanes,
                   double t, const DriveSample& drive, const BodyBlock* bodies,
                   const BallBlock* balls, BodyBlock* points, bool all,
                   geometry::NearFacets* facets) const override {
    const bool plain = jar_.axis_aligned() && !has_rotor;
    const JarAxes at = plain ? JarAxes{} : jar_axes(t);
    if constexpr (in_registers)
      return wall_points_(
          {jar_.shape(), near_lanes, plain ? nullptr : &at.own, drive.spin, points});
    for (std::size_t k = 0; k < near.size(); ++k) {
      if (near[k].face >= faces_) continue;  // of a part
      const auto b = static_cast<std::size_t>(near[k].ball) / lanes,
                 l = static_cast<std::size_t>(near[k].ball) % lanes;
      double& slack = near[k].slack;
      if (!all && slack > 0) {
        if (balls[b].displacement_squared[l] < slack * slack) continue;
        slack = 0;  // it may touch from now on: also after it has come back
      }
      const Vec3 position = get_lane(bodies[b].position, l);
      const bool turns = near[k].face >= first_rotor_face_;
      const Rotation& q = turns ? at.rotor : at.own;
      const Vec3& spin = turns ? drive.rotor_spin : drive.spin;
      geometry::Gap gap = gap_near(near[k].face, plain ? position : q.apply_inverse(position),
                                   near[k].within, facets, k);
      if (!plain) gap.inward = q * gap.inward;
      const Vec3 point = position - gap.distance * gap.inward, velocity = cross(spin, point);
      BodyBlock& block = points[k / lanes];
      set_lane(block.position, k % lanes, point);
      set_lane(block.velocity, k % lanes, velocity);
      set_lane(block.angular_velocity, k % lanes, spin);
    }
  }
  void wall_points(const BallRecord* rows, const std::array<std::int32_t, lanes>& balls,
                   const std::array<std::int32_t, lanes>& faces, std::uint32_t touching,
                   const WallAxes& axes, double beyond, Vec<Lanes>& points,
                   geometry::NearFacets* facets) const override {
    const bool plain = jar_.axis_aligned() && !has_rotor;
    if constexpr (in_registers)
      return packet_points_(
          {jar_.shape(), rows, balls, faces, plain ? nullptr : &axes.own, points});
    for (std::size_t k = 0; k < lanes; ++k) {
      const BallRecord& ball = rows[balls[k]];
      const Vec3 position = ball.position();
      const Rotation& q = of_face(axes, faces[k]);
      const double within = (touching >> k & 1) != 0 ? (1 + past_touch) * ball.radius + beyond : 0;
      geometry::Gap gap =
          gap_near(faces[k], plain ? position : q.apply_inverse(position), within, facets, k);
      if (!plain) gap.inward = q * gap.inward;
      const Vec3 point = position - gap.distance * gap.inward;
      points.x[k] = point.x, points.y[k] = point.y, points.z[k] = point.z;
    }
  }
  double safe_time(const Vec3& position, const Vec3& velocity, double t,
                   double radius) const override {
    double least = geometry::never;
    const int asked = requires {
      S::whole_wall_safe_time;
    }
    ? 1 : jar_.shape().faces;
    for (int face = 0; face < std::min(asked, first_rotor_face_); ++face)
      if (jar_.shape().can_touch(face, radius))
        least = std::min(least, jar_.safe_time(face, {position, velocity}, t, radius).time);
    for (int face = first_rotor_face_; face < faces_; ++face) {
      const double gap_to_wall =
          gap(face, position, axes(t), geometry::never, nullptr).distance - radius;
      const double closing = norm(velocity) + max_wall_speed_;
      const double pull = norm(jar_.gravity()) + norm(jar_.motion_bounds().acceleration);
      least = std::min(least, geometry::plane_safe_time(gap_to_wall, closing, pull));
    }
    return least;
  }
  /// From the derivative of the normal along the parallel surface through the ball's centre.
  std::pair<double, double> curvatures(int face, const Vec3& position, double t) const override {
    const JarAxes at = jar_axes(t);
    const Vec3 p = of_face(at, face).apply_inverse(position);
    const geometry::Gap gap = jar_.shape().gap(face, p);
    const Vec3 n = gap.inward;
    const Vec3 side = std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 a0 = cross(n, side), a = a0 / norm(a0), b = cross(n, a);
    const Vec3 along = jar_.shape().normal_rate(face, p, a);
    const Vec3 across = jar_.shape().normal_rate(face, p, b);
    const double aa = -dot(a, along), bb = -dot(b, across), ab = -dot(a, across);
    const double middle = 0.5 * (aa + bb), half = math::hypot(0.5 * (aa - bb), ab);
    const auto at_wall = [&](double k) { return k / (1 + k * gap.distance); };
    return {at_wall(middle + half), at_wall(middle - half)};
  }
  Vec3 to_face_axes(const Vec3& a, double t, int face) const override {
    return face >= first_rotor_face_ ? jar_axes(t).rotor.apply_inverse(a) : jar_.to_jar_axes(a, t);
  }
  bool can_touch(int face, double radius) const override {
    return jar_.shape().can_touch(face, radius);
  }

 private:
  JarAxes jar_axes(double t) const {
    const Rotation own = jar_.axes(t);
    if constexpr (has_rotor)
      return {own, own * rotation_about({0, 0, 1},
                                        jar_.shape().rotor_speed * jar_.motion().clock(t).time)};
    return {own, own};
  }
  /// With the facets that element `k` of `facets` keeps; null: none.
  geometry::Gap gap_near(int face, const Vec3& p, double within, geometry::NearFacets* facets,
                         std::size_t k = 0) const {
    if constexpr (has_facets)
      if (facets != nullptr) return jar_.shape().gap(face, p, within, facets[k]);
    return geometry::gap_near(jar_.shape(), face, p, within);
  }
  const Rotation& of_face(const JarAxes& axes, int face) const {
    return has_rotor && face >= first_rotor_face_ ? axes.rotor : axes.own;
  }

  scene::TypedChamber<S> jar_;
  using PointFunction = void (*)(const WallPointLoop<S>&);
  using PacketPointFunction = void (*)(const PacketPointLoop<S>&);
  // For the instruction set of this machine.
  PointFunction wall_points_ = nullptr;
  PacketPointFunction packet_points_ = nullptr;
};

}  // namespace

std::unique_ptr<const MovingWall> moving_wall(const scene::Chamber& chamber) {
  auto jar = std::visit(
      [&]<class S>(const S& shape) -> std::unique_ptr<const MovingWall> {
        const kinematics::ChosenMotion motion(chamber.motion);
        return std::make_unique<ChamberWall<S>>(scene::TypedChamber<S>(shape, motion, chamber));
      },
      *chamber.shape);
  // What turns a mill needs the loads, too.
  const bool plain = chamber.parts.empty() && kinematics::drive_of(*chamber.motion) == nullptr;
  return plain ? std::move(jar) : wall_with_parts(std::move(jar), chamber);
}

}  // namespace mahlwerk::soft
