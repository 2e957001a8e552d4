// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Torques of parts add up about one line only.
#include <gtest/gtest.h>

#include <algorithm>

#include "mahlwerk/geometry/solids.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "unit/results/fake.hpp"

namespace mahlwerk::results::part_loads_test {
namespace {

using kinematics::PartMotion;

/// A part that turns at 30 rad/s about the vertical line through (x, 0).
cases::MachinePart turning(double x) {
  cases::MachinePart part;
  part.body.solid = geometry::AnySolid{geometry::DiscSolid{}};
  part.body.motion.kind = PartMotion::Kind::turning;
  part.body.motion.speed = 30;
  part.body.motion.axis = {0, 0, 1};
  part.body.motion.pivot = {x, 0, 0};
  return part;
}

bool has_torque(const std::vector<cases::MachinePart>& parts) {
  cases::Case c = fake_outcome().mill_case;
  c.machine_parts = parts;
  const Measures all = measures(c);
  return std::ranges::find(all, "parts_torque", &Measure::name) != all.end();
}

TEST(TorqueOfParts, is_given_for_parts_on_one_shaft) {
  cases::MachinePart higher = turning(0), at_rest = turning(0.01), fixed;
  higher.body.motion.pivot.z = 0.03;  // a point of the same line
  at_rest.body.motion.speed = 0;
  fixed.body.solid = geometry::AnySolid{geometry::PlaneSolid{}};
  EXPECT_TRUE(has_torque({turning(0), higher, at_rest, fixed}));
  EXPECT_FALSE(has_torque({at_rest, fixed})) << "nothing turns";
  EXPECT_FALSE(has_torque({}));
}

TEST(TorqueOfParts, is_not_given_for_parts_on_different_shafts) {
  cases::MachinePart tilted = turning(0), faster = turning(0), opposite = turning(0),
                     outside = turning(0);
  tilted.body.motion.axis = {1, 0, 0};
  faster.body.motion.speed = 31;
  opposite.body.motion.axis = {0, 0, -1};
  outside.body.in_laboratory = true;
  EXPECT_FALSE(has_torque({turning(0), turning(0.02)})) << "parallel shafts";
  EXPECT_FALSE(has_torque({turning(0), tilted}));
  EXPECT_FALSE(has_torque({turning(0), faster}));
  EXPECT_FALSE(has_torque({turning(0), opposite}));
  EXPECT_FALSE(has_torque({turning(0), outside}));
}

}  // namespace
}  // namespace mahlwerk::results::part_loads_test
