// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/charge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/carrier.hpp"
#include "mahlwerk/kinematics/planetary.hpp"
#include "mahlwerk/kinematics/tumbling.hpp"
#include "mahlwerk/observe/bed.hpp"

namespace mahlwerk::observe {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;
constexpr double near_wall = 0.01;  // gap over a ball's radius below which it is at the wall

int angle_slot(double x, double y) {
  const double angle = math::atan2(y, x);
  return static_cast<int>((angle < 0 ? angle + full_turn : angle) / full_turn * Charge::angles) %
         Charge::angles;
}

}  // namespace

Charge::Charge(const scene::Chamber& mill, double radius, std::vector<bool> with_axis)
    : mass_by_angle(angles), mill_(mill), radius_(radius), with_axis_(std::move(with_axis)) {
  const Vec3 normal = kinematics::plane_normal(*mill.motion);
  const bool along =
      norm(cross(normal, mill.mount.ez)) < 1e-9;  // the plane is normal to the jar's axis
  const double reach = geometry::reach(*mill.shape);
  in_jar = in_carrier = PlaneField(along ? radius : reach);
  const Vec3 z{0, 0, 1}, x{1, 0, 0};
  const bool flat = std::abs(normal.z) > 0.9;  // horizontal plane, else upright
  right_ = flat ? x : cross(z, normal) * (1 / norm(cross(z, normal)));
  if (flat && normal.z < 0) right_ = -x;
  up_ = cross(normal, right_);
}

void Charge::sample(double time, const std::vector<scene::Ball>& balls, double weight) {
  if (mass_by_angle.empty()) return;
  const kinematics::Carrier carrier = kinematics::carrier(*mill_.motion, time);
  const kinematics::Pose jar = kinematics::pose(*mill_.motion, time);
  const Rotation own = jar.rotation * mill_.mount;
  const auto add = [&](PlaneField& field, const scene::Ball& b, const Rotation& axes,
                       const Vec3& turns) {
    const Vec3 e = axes * right_, f = axes * up_;
    const Vec3 v = b.velocity - cross(turns, b.position);
    field.add(dot(b.position, e), dot(b.position, f), dot(v, e), dot(v, f), squared(v), b.mass(),
              weight);
    return b.mass() * squared(v);
  };
  double mass = 0, seen_from_jar = 0;
  for (const scene::Ball& b : balls) {
    mass += b.mass();
    seen_from_jar += add(in_jar, b, jar.rotation, jar.spin);
    add(in_carrier, b, carrier.rotation, carrier.spin);
    const double x = dot(b.position, carrier.rotation * right_);
    const double y = dot(b.position, carrier.rotation * up_);
    mass_by_angle[static_cast<std::size_t>(angle_slot(x, y))] += weight * b.mass();
    mass_total += weight * b.mass();
    spin_squared += weight * b.mass() * squared(b.spin);
    add_wall_contact(b, own, jar.spin, weight);
    if (!with_axis_.empty()) add_axis(b, carrier.rotation, own.ez, weight);
  }
  find_bed(balls, own, weight);
  if (mass > 0) jar_speed_fourth += weight * (seen_from_jar / mass) * (seen_from_jar / mass);
  in_jar.add_time(weight);
  in_carrier.add_time(weight);
}

void Charge::add_axis(const scene::Ball& ball, const Rotation& carrier, const Vec3& jar_axis,
                      double weight) {
  if (!with_axis_[static_cast<std::size_t>(ball.kind)]) return;
  const Vec3 axis = rotation_of(ball.orientation).ez;
  alignment.add(carrier.apply_inverse(axis), dot(axis, jar_axis), weight);
}

/// Does nothing for a mesh, whose many faces take too long to test, and for an attritor.
void Charge::add_wall_contact(const scene::Ball& ball, const Rotation& own, const Vec3& spin,
                              double weight) {
  std::visit(
      [&]<class S>(const S& shape) {
        if constexpr (!std::is_same_v<S, geometry::Mesh> &&
                      !std::is_same_v<S, geometry::Attritor>) {
          for (int face = 0; face < shape.faces; ++face) {
            const geometry::Gap gap = shape.gap(face, own.apply_inverse(ball.position));
            if (!(gap.distance - ball.radius < near_wall * ball.radius)) continue;
            const Vec3 n = own * gap.inward, arm = -ball.radius * n;
            const Vec3 slip =
                ball.velocity + cross(ball.spin, arm) - cross(spin, ball.position + arm);
            mass_at_wall += weight * ball.mass();
            wall_slip += weight * ball.mass() * norm(tangential_part(slip, n));
            return;
          }
        }
      },
      *mill_.shape);
}

void Charge::find_bed(const std::vector<scene::Ball>& balls, const Rotation& own, double weight) {
  constexpr std::int64_t each = 4;  // neighbours cost more than the rest of a sample
  const bool has_bed = kinematics::as<kinematics::Tumbling>(*mill_.motion) != nullptr ||
                       kinematics::as<kinematics::Planetary>(*mill_.motion) != nullptr;
  if (samples_++ % each != 0 || !has_bed) return;
  mass_outside += weight * mass_outside_bed(balls, *mill_.shape, own, radius_);
  for (const scene::Ball& b : balls) mass_sought += weight * b.mass();
}

void Charge::merge(const Charge& other) {
  if (mass_by_angle.empty()) {
    *this = other;
    return;
  }
  if (other.mass_by_angle.empty()) return;
  in_jar.merge(other.in_jar);
  in_carrier.merge(other.in_carrier);
  for (std::size_t i = 0; i < mass_by_angle.size(); ++i) mass_by_angle[i] += other.mass_by_angle[i];
  mass_at_wall += other.mass_at_wall;
  wall_slip += other.wall_slip;
  mass_total += other.mass_total;
  spin_squared += other.spin_squared;
  jar_speed_fourth += other.jar_speed_fourth;
  mass_outside += other.mass_outside;
  mass_sought += other.mass_sought;
  alignment.merge(other.alignment);
}

void Charge::pack() {
  in_jar.pack();
  in_carrier.pack();
}

void Charge::let_go() {
  in_jar.let_go();
  in_carrier.let_go();
}

void Charge::serialize(Archive& archive) {
  in_jar.serialize(archive);
  in_carrier.serialize(archive);
  archive(mass_by_angle)(mass_at_wall)(
      wall_slip)(mass_total)(spin_squared)(jar_speed_fourth)(mass_outside)(mass_sought)(samples_);
  alignment.serialize(archive);
}

}  // namespace mahlwerk::observe
