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

/// A jar of four lattices of balls side by side in x: halves of two sets, of which some are
/// outside.
struct Flowing {
  scene::Chamber mill{geometry::Box{14, 14, 14}, kinematics::Still{}, {}, {0, 0, -9.81}};
  std::vector<scene::Ball> balls;

  Flowing() {
    for (double x = -6.5; x < 7; ++x)
      for (double y = -6.5; y < 7; ++y)
        for (double z = -6.5; z < 7; ++z) balls.push_back({0.5, 1, {x, y, z}, {}, {}, x > 0});
  }
  MixingRecord record(Mixing::Colour colour, bool flows) const {
    MixingRecord made({.section = {.colour = colour},
                       .mill = mill,
                       .interval = 1,
                       .cell = 3,
                       .reach = 1.2,
                       .diameter = 1,
                       .flows = flows});
    made.begin(0);
    return made;
  }
};

MixingSample last_of(const MixingRecord& record) {
  return record.samples().back();
}

/// What is outside does not count: the sample is that of the balls inside alone.
TEST(MixingWithFlow, is_that_of_the_balls_in_the_jar) {
  Flowing jar;
  std::vector<scene::Ball> inside;
  for (scene::Ball& b : jar.balls) {
    b.outside = b.position.z > 0 || (b.position.x > 3 && b.position.y > 0);
    if (!b.outside) inside.push_back(b);
  }
  MixingRecord flowing = jar.record(Mixing::Colour::sets, true),
               alone = jar.record(Mixing::Colour::sets, false);
  flowing.take_balls({.time = 0}, 0, jar.balls);
  alone.take_balls({.time = 0}, 0, inside);
  const MixingSample found = last_of(flowing), expected = last_of(alone);
  states("Lacey's index", found.lacey, expected.lacey, 0, "of the balls inside alone");
  states("neighbours", found.neighbours, expected.neighbours, 0, "likewise");
  states("segregation, vertical", found.vertical, expected.vertical, 0, "likewise");
  states("packing fraction", found.packing, expected.packing, 0, "likewise");
  states("height of the bed", found.bed_height, expected.bed_height, 0, "likewise");
  EXPECT_TRUE(std::isnan(found.axial_spread)) << "balls that leave have no way along the axis";
}

/// A set is a label: balls that come in later have it. A half is not: they are left out.
TEST(MixingWithFlow, balls_that_come_in_later_have_the_colour_of_their_set_and_none_of_a_half) {
  Flowing jar;
  for (const Mixing::Colour colour : {Mixing::Colour::sets, Mixing::Colour::height}) {
    std::vector<scene::Ball> balls = jar.balls;
    for (scene::Ball& b : balls) b.outside = b.position.y > 0;
    MixingRecord flowing = jar.record(colour, true);
    flowing.take_balls({.time = 0}, 0, balls);
    const MixingSample before = last_of(flowing);
    for (scene::Ball& b : balls) b.outside = false;
    flowing.take_balls({.time = 1}, 1, balls);
    const MixingSample after = last_of(flowing);
    if (colour == Mixing::Colour::sets) {
      MixingRecord whole = jar.record(colour, false);
      whole.take_balls({.time = 0}, 0, balls);
      states("Lacey's index", after.lacey, last_of(whole).lacey, 0, "of all balls, by their sets");
    } else {
      states("Lacey's index", after.lacey, before.lacey, 0, "of those that have a colour");
    }
    EXPECT_GT(after.bed_height, 13) << "of all balls in the jar";
  }
}

TEST(MixingWithFlow, of_an_empty_jar_has_no_numbers) {
  Flowing jar;
  for (scene::Ball& b : jar.balls) b.outside = true;
  for (const Mixing::Colour colour : {Mixing::Colour::sets, Mixing::Colour::height}) {
    MixingRecord flowing = jar.record(colour, true);
    flowing.take_balls({.time = 0}, 0, jar.balls);
    const MixingSample found = last_of(flowing);
    for (const double value : {found.lacey, found.neighbours, found.radial, found.vertical,
                               found.axial, found.packing, found.bed_height})
      EXPECT_TRUE(std::isnan(value));
  }
}

}  // namespace
}  // namespace mahlwerk::parts::mixing::mixing_record_test
