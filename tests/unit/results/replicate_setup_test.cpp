// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What a replicate begins with, and the windows of a run that goes on.
#include "mahlwerk/results/quantities/replicate_setup.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mahlwerk/parts/accelerometer/accelerometer.hpp"
#include "mahlwerk/parts/accelerometer/impact_record.hpp"
#include "meshes.hpp"
#include "statement.hpp"
#include "unit/results/fake.hpp"

namespace mahlwerk::results::replicate_setup_test {
namespace {

using parts::accelerometer::Accelerometer;
using parts::accelerometer::ImpactRecord;
using tests::states;

cases::Case with_accelerometer(Accelerometer::Axis axis) {
  cases::Case c = fake_outcome().mill_case;
  c.parts.set(Accelerometer{
      .axis = axis, .mass = {}, .bandwidth = 1e3, .sample_rate = 5e3, .duration = 0.02});
  return c;
}
ImpactRecord record_of(const cases::Case& c) {
  return *empty_replicate(c).recorders.find<ImpactRecord>();
}

TEST(ReplicateSetup, the_accelerometer_measures_along_the_axis_of_the_case) {
  const auto axis = [](Accelerometer::Axis of) { return record_of(with_accelerometer(of)).axis(); };
  EXPECT_EQ(axis(Accelerometer::Axis::x), (Vec3{1, 0, 0}));
  EXPECT_EQ(axis(Accelerometer::Axis::y), (Vec3{0, 1, 0}));
  EXPECT_EQ(axis(Accelerometer::Axis::z), (Vec3{0, 0, 1}));
}

TEST(ReplicateSetup, the_record_of_impacts_has_quarters_of_samples_and_ends_with_the_run) {
  cases::Case c = with_accelerometer(Accelerometer::Axis::z);
  const ImpactRecord whole = record_of(c);
  states("step [s]", whole.step(), 5e-5, 1e-18, "a quarter of 1/5 kHz");
  EXPECT_EQ(whole.impulses().size(), 400U) << "0.02 s";
  c.run.time = 0.005;
  EXPECT_EQ(record_of(c).impulses().size(), 100U) << "0.005 s";
  c.run.time = 1e-9;
  EXPECT_EQ(record_of(c).impulses().size(), 4U) << "one sample";
}

TEST(ReplicateSetup, a_replicate_that_counted_nothing_has_no_signal) {
  Outcome o;
  o.mill_case = with_accelerometer(Accelerometer::Axis::z);
  o.replicates.push_back(empty_replicate(o.mill_case));
  const Summary summary = summarise(o);
  for (const char* name : {"acceleration_rms", "acceleration_rms_of_impacts", "acceleration_peak"})
    EXPECT_TRUE(std::isnan(named(summary.quantities, name).value)) << name;
  ASSERT_EQ(summary.by_replicate.size(), 1U);
}

TEST(ReplicateSetup, faces_are_told_apart_unless_they_are_many) {
  const auto faces = [](const geometry::AnyShape& shape) {
    cases::Case c = fake_outcome().mill_case;
    c.jar.shape = shape;
    return empty_replicate(c).tally.by_pair.faces();
  };
  EXPECT_EQ(faces(geometry::Box{0.04, 0.05, 0.06}), 6);
  const std::vector<int> corners{10, 11};  // faces of a prism, with its ends: 12 and 13
  EXPECT_EQ(faces(tests::mesh_of(tests::cylinder(corners[0], 0.05, 0.05))), 12);
  EXPECT_EQ(faces(tests::mesh_of(tests::cylinder(corners[1], 0.05, 0.05))), 1);
}

TEST(ReplicateSetup, the_grid_of_the_wall_holds_the_jar) {
  cases::Case c = fake_outcome().mill_case;
  c.jar.shape = geometry::Cylinder{0.05, 0.08};
  const observe::WallGrid grid = empty_replicate(c).tally.wall_map.grid();
  states("radius [m]", grid.radius, 0.025, 1e-15, "half of the diameter");
  states("bottom [m]", grid.bottom, -0.04, 1e-15, "half of the height");
  states("top [m]", grid.top, 0.04, 1e-15, "half of the height");
}

TEST(Windows, two_together_have_the_sums_of_both_and_the_state_at_their_end) {
  std::vector<Window> windows;
  for (int i = 1; i <= 5; ++i)
    windows.push_back({.time = 0.1 * i,
                       .length = 0.1,
                       .collisions = 10.0 * i,
                       .above = 7.0 * i,
                       .energy_normal = 1.0 * i,
                       .energy_contact_point = 2.0 * i,
                       .lost = 3.0 * i,
                       .wall_work = 4.0 * i,
                       .contact_time = 0.01 * i,
                       .kinetic = 5.0 * i});
  const std::vector<Window> merged = merge_window_pairs(windows);
  ASSERT_EQ(merged.size(), 2U) << "the fifth is left out";
  for (std::size_t i = 0; i < 2; ++i) {
    const double sum = i == 0 ? 3 : 7, last = i == 0 ? 2 : 4;  // 1 + 2, 3 + 4
    const Window& w = merged[i];
    states("end [s]", w.time, 0.1 * last, 1e-15, "that of the later");
    states("length [s]", w.length, 0.2, 1e-15, "of both");
    states("collisions", w.collisions, 10 * sum, 0, "of both");
    states("above the threshold", w.above, 7 * sum, 0, "of both");
    states("normal energy [J]", w.energy_normal, sum, 0, "of both");
    states("energy of contact points [J]", w.energy_contact_point, 2 * sum, 0, "of both");
    states("losses [J]", w.lost, 3 * sum, 0, "of both");
    states("work of the jar [J]", w.wall_work, 4 * sum, 0, "of both");
    states("time in contact [s]", w.contact_time, 0.01 * sum, 1e-15, "of both");
    states("kinetic energy [J]", w.kinetic, 5 * last, 0, "at the end");
  }
}

}  // namespace
}  // namespace mahlwerk::results::replicate_setup_test
