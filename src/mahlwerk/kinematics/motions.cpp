// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/kinematics/motions.hpp"

#include "mahlwerk/base/indirect_members.hpp"

template class mahlwerk::Indirect<mahlwerk::kinematics::AnyMotion>;

namespace mahlwerk::kinematics {

std::string_view name_of(const AnyMotion& motion) {
  return std::visit([](const auto& m) -> std::string_view { return m.name; }, motion);
}
Indirect<AnyMotion> programmed(const AnyMotion& motion, const SpeedProgram& program) {
  AnyMotion made = motion;
  made.program = program;
  return made;
}
Indirect<AnyMotion> driven(const AnyMotion& motion, const Motor& motor, double speed) {
  AnyMotion made = motion;
  made.drive = std::make_shared<Drive>(motor, speed);
  return made;
}
Drive* drive_of(const AnyMotion& motion) {
  return motion.drive.get();
}
bool speed_varies(const AnyMotion& motion) {
  return !motion.program.empty() || motion.drive;
}
Clock clock(const AnyMotion& motion, double t) {
  if (motion.drive) return motion.drive->clock(t);
  return motion.program.empty() ? Clock{t} : motion.program.clock(t);
}

double largest_rate(const AnyMotion& motion) {
  return motion.drive ? Drive::largest_rate : 1;
}

namespace {

/// Bounds of the running mill, widened so that they hold while a motor turns it.
Bounds driven_bounds(Bounds b, const Drive& drive) {
  const double rate = Drive::largest_rate, change = drive.acceleration_bound();
  b.acceleration = rate * rate * b.acceleration + b.speed * change * Vec3{1, 1, 1};
  b.angular_acceleration = rate * rate * b.angular_acceleration + b.spin * change;
  b.speed *= rate, b.spin *= rate;
  b.jerk *= rate * rate * rate;
  return b;
}

/// Derivatives with the time of the run of what has these with the time of the running mill.
Vec3 first(const Clock& at, const Vec3& rate) {
  return at.rate * rate;
}
Vec3 second(const Clock& at, const Vec3& rate, const Vec3& acceleration) {
  return at.rate * at.rate * acceleration + at.acceleration * rate;
}

Pose running_pose(const AnyMotion& motion, double t) {
  return std::visit(
      [t](const auto& m) {
        return Pose{m.frame_motion(t), m.rotation(t), m.spin(t), m.angular_acceleration(t)};
      },
      motion);
}

}  // namespace

Pose pose(const AnyMotion& motion, double t) {
  if (!speed_varies(motion)) return running_pose(motion, t);
  const Clock at = clock(motion, t);
  const Pose p = running_pose(motion, at.time);
  return {{p.frame.centre, first(at, p.frame.velocity),
           second(at, p.frame.velocity, p.frame.acceleration)},
          p.rotation,
          first(at, p.spin),
          second(at, p.spin, p.angular_acceleration)};
}
FrameMotion frame_motion(const AnyMotion& motion, double t) {
  if (speed_varies(motion)) return pose(motion, t).frame;
  return std::visit([t](const auto& m) { return m.frame_motion(t); }, motion);
}
Rotation rotation(const AnyMotion& motion, double t) {
  const double at = clock(motion, t).time;
  return std::visit([at](const auto& m) -> Rotation { return m.rotation(at); }, motion);
}
Vec3 spin(const AnyMotion& motion, double t) {
  if (speed_varies(motion)) return pose(motion, t).spin;
  return std::visit([t](const auto& m) -> Vec3 { return m.spin(t); }, motion);
}
Vec3 angular_acceleration(const AnyMotion& motion, double t) {
  if (speed_varies(motion)) return pose(motion, t).angular_acceleration;
  return std::visit([t](const auto& m) -> Vec3 { return m.angular_acceleration(t); }, motion);
}
Bounds bounds(const AnyMotion& motion) {
  const Bounds running = std::visit([](const auto& m) { return m.bounds(); }, motion);
  if (motion.drive) return driven_bounds(running, *motion.drive);
  return motion.program.bounds(running);
}
double period(const AnyMotion& motion) {
  if (speed_varies(motion)) return no_period;
  return std::visit([](const auto& m) -> double { return m.period(); }, motion);
}
Vec3 fixed_axis(const AnyMotion& motion) {
  return std::visit([](const auto& m) -> Vec3 { return m.fixed_axis(); }, motion);
}

const void* held(const AnyMotion& motion, const std::type_info& type) {
  return std::visit([&](const auto& m) -> const void* { return typeid(m) == type ? &m : nullptr; },
                    motion);
}

}  // namespace mahlwerk::kinematics
