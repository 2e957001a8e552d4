// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"

// Short cases of every kind, which every test of observers can run to the end.
namespace mahlwerk::campaign {

struct Kind {
  std::string name;
  cases::Case mill_case;
};

/// `count` balls of 6 mm in a shaken cylinder. They are so soft that few steps are needed. The run
/// is observed for 0.2 s after 0.05 s.
inline cases::Case shaken(const std::string& engine, std::int64_t count) {
  cases::Case c;
  kinematics::Vibration motion;
  motion.frequency = 20;
  motion.amplitude = 0.005;
  motion.tilt = 0.5;
  c.mill.motion = motion;
  c.jar.shape = geometry::Cylinder{0.04, 0.04};
  c.jar.elastic = {70e6, 0.3};
  c.balls = {{count, 6e-3, 7850, "", {70e6, 0.3}}};
  c.contact.rule = {.restitution = 0.7, .tangential_restitution = 0.2, .friction = 0.3};
  c.contact.lasting_friction = 0.3;
  c.contact.rolling_friction = 0.02;
  c.contact.lasting_speed = 1e-4;
  c.contact.contact_time = 1e-4;
  if (count > 1) c.contact.lasting = cases::SustainedContactModel::tc;
  c.run.engine = cases::to_enum<cases::EngineName>(engine, cases::engines());
  c.run.settle = 0.05;
  c.run.time = 0.2;
  c.observe.threshold = 0.1;
  return c;
}

/// One ball, shaken so gently that it rolls for most of the time.
inline cases::Case rolling_ball() {
  cases::Case c = shaken("event", 1);
  std::get<kinematics::Vibration>(*c.mill.motion).frequency = 6;
  std::get<kinematics::Vibration>(*c.mill.motion).amplitude = 0.012;
  c.contact.rule.restitution = 0.4;
  c.run.time = 4;
  c.run.settle = 0.5;
  return c;
}

/// Many balls that lie on each other: the TC rule returns a considerable part of what bounces lose.
inline cases::Case dense() {
  cases::Case c = shaken("event", 30);
  std::get<kinematics::Vibration>(*c.mill.motion).amplitude = 8e-4;
  c.jar.shape = geometry::Cylinder{0.025, 0.04};
  return c;
}

/// Five balls that lie on the floor and hit each other.
inline cases::Case lying_balls() {
  cases::Case c = shaken("soft", 5);
  std::get<kinematics::Vibration>(*c.mill.motion).amplitude = 8e-4;
  std::get<kinematics::Vibration>(*c.mill.motion).tilt = 1.2;
  c.run.settle = 0.3;
  return c;
}

/// Both engines, each with both of its solvers. The many-body solver has more than 32 balls.
inline std::vector<Kind> kinds() {
  return {{"event, one ball", rolling_ball()},
          {"event, 30 balls", dense()},
          {"soft, 5 balls", lying_balls()},
          {"soft, crowd of 40", shaken("soft", 40)}};
}

inline ReplicateRun& to_the_end(ReplicateRun& replica) {
  while (!replica.done()) replica.run_slice();
  return replica;
}

}  // namespace mahlwerk::campaign
