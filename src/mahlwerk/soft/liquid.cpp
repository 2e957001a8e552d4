// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/liquid.hpp"

#include <algorithm>
#include <numbers>

namespace mahlwerk::soft {

double LiquidForces::gap_reach(std::span<const SpeciesPair> pairs) const {
  double reach = 0;
  for (const SpeciesPair& pair : pairs)
    reach = std::max(reach, liquid_.gap_reach(pair.effective.radius));
  return reach;
}

LiquidMotion LiquidForces::motion(const MovingWall& jar, const DriveSample& drive, double t) const {
  return {.jar_velocity = drive.velocity,
          .body_acceleration = drive.body_acceleration,
          .spin = drive.spin,
          .angular_acceleration = (0.5 / dt_) * (jar.spin(t + dt_) - jar.spin(t - dt_))};
}

LiquidLoad LiquidForces::on_ball(const LiquidMotion& liquid, const Species& ball,
                                 const Vec3& position, const Vec3& velocity, const Vec3& spin,
                                 LiquidWork& work) const {
  constexpr double pi = std::numbers::pi;
  const double radius = ball.radius, eta = liquid_.viscosity;
  const Vec3 flow = cross(liquid.spin, position), slip = velocity - flow;
  const double reynolds = liquid_.density * norm(slip) * 2 * radius / eta;
  const Vec3 drag = -(6 * pi * eta * radius * contact::drag_correction(reynolds)) * slip;
  const Vec3 acceleration = cross(liquid.angular_acceleration, position) + cross(liquid.spin, flow);
  const double displaced = ball.mass / ball.density * liquid_.density;  // [kg]
  const Vec3 pressure = displaced * (acceleration - liquid.body_acceleration);
  const Vec3 slip_spin = spin - liquid.spin;
  const Vec3 torque = -(8 * pi * eta * radius * radius * radius) * slip_spin;
  work.lost -= dt_ * (dot(drag, slip) + dot(torque, slip_spin));
  work.wall += dt_ * (dot(drag, flow + liquid.jar_velocity) + dot(torque, liquid.spin) +
                      dot(pressure, velocity + liquid.jar_velocity));
  return {drag + pressure, torque};
}

Vec3 LiquidForces::between_balls(const SpeciesPair& pair, double radii, const Vec3& separation,
                                 const Vec3& velocity, double weight, LiquidWork& work) const {
  const double distance = norm(separation), gap = distance - radii;
  if (!(gap > 0)) return {};
  const Vec3 n = (1 / distance) * separation;
  const double approach = dot(velocity, n);
  const double force =
      contact::lubrication_force(liquid_, pair.effective.radius, gap, approach, dt_);
  work.lost += weight * dt_ * force * approach;
  return -force * n;
}

Vec3 LiquidForces::at_wall(const SpeciesPair& pair, double radius, const geometry::Gap& gap,
                           const Vec3& position, const Vec3& velocity, const Vec3& turning,
                           const Vec3& jar_velocity, LiquidWork& work) const {
  const double free = gap.distance - radius;
  if (!(free > 0)) return {};
  const Vec3 wall_velocity = cross(turning, position - gap.distance * gap.inward);
  const double approach = -dot(velocity - wall_velocity, gap.inward);
  const double size =
      contact::lubrication_force(liquid_, pair.effective.radius, free, approach, dt_);
  const Vec3 force = size * gap.inward;
  work.lost += dt_ * size * approach;
  work.wall += dt_ * dot(force, wall_velocity + jar_velocity);
  return force;
}

}  // namespace mahlwerk::soft
