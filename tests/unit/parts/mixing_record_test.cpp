// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The samples of [mixing], of lattices of balls.
#include "mahlwerk/parts/mixing/mixing_record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/geometry/solids.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "statement.hpp"

namespace mahlwerk::parts::mixing::mixing_record_test {
namespace {

using tests::states;

/// A box of 14 x 14 x 14 m with balls of diameter 1 on a cubic lattice, but where a bar is.
struct Filled {
  scene::Chamber mill{geometry::Box{14, 14, 14}, kinematics::Still{}, {}};
  std::vector<scene::Ball> balls;

  explicit Filled(bool bar) {
    geometry::CylinderSolid solid;
    solid.diameter = 3, solid.length = 13.9;
    if (bar)
      mill.parts.push_back(
          {.solid = geometry::AnySolid{solid}, .axes = {}, .position = {}, .motion = {}});
    for (double x = -6.5; x < 7; ++x)
      for (double y = -6.5; y < 7; ++y)
        for (double z = -6.5; z < 7; ++z)
          if (!bar || std::hypot(x, y) > 2) balls.push_back({0.5, 1, {x, y, z}, {}, {}, z < 0});
  }
  MixingRecord record() const {
    MixingRecord made(
        {.section = {}, .mill = mill, .interval = 1, .cell = 3, .reach = 1.2, .diameter = 1});
    made.begin(0);
    made.take_balls({.time = 0}, 0, balls);
    return made;
  }
};

TEST(MixingRecord, has_the_packing_of_the_lattice_and_a_profile_of_it) {
  const MixingRecord record = Filled(false).record();
  ASSERT_EQ(record.samples().size(), 1U);
  const double packing = record.samples()[0].packing;
  // The waves of the lattice that the grid does not average out (packing_test.cpp).
  states("packing fraction", packing, std::numbers::pi / 6, 0.005, "cubic lattice");
  double sum = 0, points = 0;
  ASSERT_FALSE(record.profile().empty());
  for (const PackingAtHeight& one : record.profile()) {
    sum += one.sum, points += one.points;
    const double height = (one.layer + 0.5) * record.layer_height();
    EXPECT_GT(height, 1.5 - record.layer_height());  // a sphere above the floor
    EXPECT_LT(height, 14 - 1.5 + record.layer_height());
  }
  states("mean of the profile", sum / points, packing, 1e-12, "the same points");
}

double points_of(const MixingRecord& record) {
  double points = 0;
  for (const PackingAtHeight& one : record.profile()) points += one.points;
  return points;
}

TEST(MixingRecord, counts_a_part_as_a_wall) {
  const MixingRecord with = Filled(true).record(), without = Filled(false).record();
  // The points are in 11 x 11 diameters, without a circle of the radii of the bar and of a sphere.
  // About 30 of 300 points in a plane are at the edge of the circle: sqrt(30)/300. Were the bar a
  // hole, where other balls fit, the circle would be of the radius 4.2.
  states("share of points", points_of(with) / points_of(without),
         1 - std::numbers::pi * 3 * 3 / (11 * 11), 0.04, "a radius from the bar");
  // Lines of the grid beside the bar are a third as long as those of the whole box.
  states("packing fraction", with.samples()[0].packing, std::numbers::pi / 6, 3 * 0.005,
         "cubic lattice");
}

TEST(MixingRecord, tells_segregation_along_the_axis_as_across) {
  // The first colour, kind 0, is the upper half: 3.5 above the middle, over the deviation of
  // fourteen layers, sqrt((14^2 - 1)/12).
  const MixingSample s = Filled(false).record().samples()[0];
  const double expected = 3.5 / std::sqrt(195.0 / 12);
  states("along the axis", s.axial, expected, 1e-12, "counted");
  states("upwards", s.vertical, expected, 1e-12, "the axis is upright");
}

TEST(MixingRecord, of_a_periodic_axis_has_no_segregation_along_it) {
  Filled filled(false);
  filled.mill.shape = geometry::PeriodicBox{14, 14, 14};
  const MixingSample s = filled.record().samples()[0];
  EXPECT_TRUE(std::isnan(s.axial));
  // A grid of 23 points on 14 cells resolves all waves that matter.
  states("packing fraction", s.packing, std::numbers::pi / 6, 1e-4, "no walls");
}

}  // namespace
}  // namespace mahlwerk::parts::mixing::mixing_record_test
