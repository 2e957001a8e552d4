// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/start.hpp"

#include <algorithm>
#include <iterator>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/carrier.hpp"
#include "mahlwerk/kinematics/motions.hpp"

namespace mahlwerk::campaign {
namespace {

class NullObserver final : public scene::Observer {
  void collisions(std::span<const scene::Collision>) override {}
};

/// A part, standing still where it starts; the jar's centre is then at the origin.
void stop(scene::MachinePart& part, const Vec3& jar_centre) {
  const kinematics::Displacement d = part.motion.at(0);
  part.position = d.centre + d.rotation * (part.position - part.motion.pivot);
  if (part.in_laboratory) part.position -= jar_centre;
  part.axes = d.rotation * part.axes;
  part.motion = {};
}

/// The jar, standing still where its mill starts.
scene::Chamber at_rest(scene::Chamber jar) {
  for (scene::MachinePart& part : jar.parts)
    stop(part, kinematics::frame_motion(*jar.motion, 0).centre);
  jar.mount = kinematics::rotation(*jar.motion, 0) * jar.mount;
  jar.motion = kinematics::AnyMotion(kinematics::Still{});
  if (const auto* stirred = geometry::as<geometry::Attritor>(*jar.shape)) {
    geometry::Attritor still = *stirred;
    still.rotor_speed = 0;
    jar.shape = geometry::AnyShape(still);
  }
  return jar;
}

}  // namespace

std::vector<scene::Ball> balls_at_start(const cases::Case& mill_case, const scene::Chamber& mill,
                                        int replicate, const EngineMaker& make,
                                        const std::atomic<bool>* stop) {
  std::vector<scene::Ball> balls = cases::starting_balls(mill_case, replicate, stop);
  const cases::Run& run = mill_case.run;
  if (run.start_from.states && run.engine == cases::EngineName::event)
    cases::remove_overlaps(mill_case, balls, stop);
  if (run.settle_at_rest == 0) return balls;
  // Velocities are relative to the jar's centre, which moves once the mill has started.
  const Vec3 centre = kinematics::frame_motion(*mill.motion, 0).velocity;
  std::vector<scene::Ball> inside;
  std::ranges::copy_if(balls, std::back_inserter(inside),
                       [](const scene::Ball& b) { return !b.outside; });
  if (inside.empty()) return balls;
  for (scene::Ball& b : inside) b.velocity += centre;
  const auto engine = make(at_rest(mill), inside);
  engine->stop_on(stop);
  NullObserver nobody;
  engine->advance(run.settle_at_rest, nobody);
  if (stop != nullptr && *stop) throw Interrupted();
  inside = engine->balls();
  for (scene::Ball& b : inside) b.velocity -= centre;
  auto next = inside.begin();
  for (scene::Ball& b : balls)
    if (!b.outside) b = *next++;
  return balls;
}

std::vector<scene::Ball> seen_from_carrier(const cases::Case& mill_case,
                                           std::vector<scene::Ball> balls, double time) {
  const Rotation carrier = kinematics::carrier(*cases::chamber(mill_case).motion, time).rotation;
  const Quaternion q = quaternion_of(carrier), back{q.w, -q.x, -q.y, -q.z};
  for (scene::Ball& b : balls) {
    b.position = carrier.apply_inverse(b.position);
    b.velocity = carrier.apply_inverse(b.velocity);
    b.spin = carrier.apply_inverse(b.spin);
    b.orientation = back * b.orientation;
  }
  return balls;
}

}  // namespace mahlwerk::campaign
