// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/liquid.hpp"

#include <algorithm>

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

LiquidLoad LiquidForces::on_ball(const LiquidMotion& motion, const Species& ball,
                                 const Vec3& position, const Vec3& velocity, const Vec3& spin,
                                 LiquidWork& work) const {
  const auto vec = [](const Vec3& a) { return Vec<double>{a.x, a.y, a.z}; };
  const LiquidLoads<double> load = on_balls<double>(motion, ball.radius, displaced_mass(ball),
                                                    vec(position), vec(velocity), vec(spin));
  work.lost += load.lost, work.wall += load.wall;
  return {{load.force.x, load.force.y, load.force.z},
          {load.torque.x, load.torque.y, load.torque.z}};
}

double LiquidForces::force_of(const SpeciesPair& pair, double gap, double approach) const {
  const double radius = pair.effective.radius;
  return contact::lubrication_force(liquid_, liquid_.resistance(radius), liquid_.gap_reach(radius),
                                    gap, approach, dt_);
}

Vec3 LiquidForces::between_balls(const SpeciesPair& pair, double radii, const Vec3& separation,
                                 const Vec3& velocity, double weight, LiquidWork& work) const {
  const double distance = norm(separation), gap = distance - radii;
  if (!(gap > 0)) return {};
  const Vec3 n = (1 / distance) * separation;
  const double approach = dot(velocity, n);
  const double force = force_of(pair, gap, approach);
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
  const double size = force_of(pair, free, approach);
  const Vec3 force = size * gap.inward;
  work.lost += dt_ * size * approach;
  work.wall += dt_ * dot(force, wall_velocity + jar_velocity);
  return force;
}

}  // namespace mahlwerk::soft
