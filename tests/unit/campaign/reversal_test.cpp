// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Runs with a drive whose sense of rotation changes.
#include "mahlwerk/cases/reversal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "meshes.hpp"
#include "statement.hpp"
#include "unit/campaign/runs.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::reversal_test {
namespace {

using cases::sample::catalogue;
using tests::states;

const std::string mill = R"(title = "five balls"
seed = 3
[mill]
kind = "planetary"
orbit_radius = "60 mm"
speed = "400 rpm"
ratio = -2
[jar]
kind = "cylinder"
diameter = "40 mm"
height = "30 mm"
[[balls]]
count = 5
diameter = "8 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.6
friction = 0.3
softening = 1e-3
[run]
engine = "soft"
time = "0.1 s"
settle = "0 s"
replicates = 2
[milling]
reverse = true
)";

cases::Case case_with(const std::vector<cases::Override>& set = {}) {
  return cases::read_text(mill, "case.toml", catalogue(), set);
}

/// A prism without any plane of symmetry along its axis; `side` -1: its mirror image at y = 0.
geometry::Mesh skew_jar(double side) {
  std::vector<Vec3> corners{{0.020, -0.006, 0},
                            {0.012, 0.014, 0},
                            {-0.015, 0.019, 0},
                            {-0.021, -0.004, 0},
                            {0.002, -0.018, 0}};
  for (Vec3& p : corners) p.y *= side;
  if (side < 0) std::ranges::reverse(corners);  // anticlockwise
  return tests::mesh_of(tests::prism(corners, 0.03));
}

std::string note_of(const results::Outcome& outcome) {
  const auto found = std::ranges::find(outcome.notices, "reversed-drive", &Notice::code);
  return found == outcome.notices.end() ? "" : found->text;
}

TEST(ReversedDrive, the_second_replicate_of_an_unsymmetric_jar_has_the_bits_of_the_mirrored_mill) {
  const auto in_skew_jar = [](cases::Case c) {
    c.jar.shape = skew_jar(1);
    return c;
  };
  const results::Outcome both = run(in_skew_jar(case_with()), on(1));
  const std::vector<cases::Override> never{{"milling.reverse", "false"}};
  const std::vector<cases::Override> back{{"milling.reverse", "false"}, {"mill.speed", "-400 rpm"}};
  const std::vector<double> found = powers(both);
  EXPECT_EQ(found[0], powers(run(in_skew_jar(case_with(never)), on(1)))[0]);
  EXPECT_EQ(found[1], powers(run(in_skew_jar(case_with(back)), on(1)))[1]);
  EXPECT_NE(found[1], powers(run(in_skew_jar(case_with(never)), on(1)))[1]);
  EXPECT_EQ(found, powers(run(in_skew_jar(case_with()), on(2))));
  EXPECT_NE(note_of(both).find("means are those of both senses"), std::string::npos);
  EXPECT_FALSE(both.summary.two_states);
}

TEST(ReversedDrive, nothing_changes_in_a_jar_that_is_its_own_mirror_image) {
  const results::Outcome outcome = run(case_with(), on(1));
  EXPECT_EQ(powers(outcome), powers(run(case_with({{"milling.reverse", "false"}}), on(1))));
  EXPECT_NE(note_of(outcome).find("their own mirror image"), std::string::npos);
}

/// Two balls that are thrown in the mill, seen in the mirror at the plane of x and z if `side` is
/// -1: a position and a velocity are mirrored, a spin too, but as an axial vector.
results::Outcome thrown(double side, const std::string& speed, const geometry::AnyShape& jar) {
  cases::Case c = case_with({{"milling.reverse", "false"},
                             {"mill.speed", speed},
                             {"balls.1.count", "2"},
                             {"run.replicates", "1"}});
  c.balls[0].positions = {{0.004, side * 0.005, -0.002}, {-0.006, side * -0.004, 0.003}};
  c.balls[0].velocities = {{0.3, side * 0.4, 0.1}, {0.1, side * -0.2, -0.3}};
  c.balls[0].spins = {{side * 20, -10, side * 30}, {side * -5, 40, side * 10}};
  c.jar.shape = jar;
  return run(c, on(1));
}

void expect_equal(const results::Outcome& ahead, const results::Outcome& mirrored,
                  const std::string& name) {
  for (const char* quantity : {"dissipated_power", "collision_rate", "jar_lag", "airborne_share",
                               "toe_angle", "shoulder_angle"}) {
    const double expected = results::value_of(ahead, ahead.replicates[0], quantity);
    states(name + ": " + quantity, results::value_of(mirrored, mirrored.replicates[0], quantity),
           expected, 1e-9 * std::abs(expected),
           "the mirror image (kin.20); differences by rounding grow from bounce to bounce");
  }
  EXPECT_EQ(ahead.summary.regime, mirrored.summary.regime);
}

TEST(ReversedDrive, a_mill_that_turns_the_other_way_gives_the_mirror_image) {
  const geometry::AnyShape pot = geometry::Cylinder{0.04, 0.03};
  const results::Outcome round = thrown(1, "400 rpm", pot),
                         skew = thrown(1, "400 rpm", skew_jar(1));
  EXPECT_GT(round.replicates[0].tally.all.count, 10);
  expect_equal(round, thrown(-1, "-400 rpm", pot), "cylinder");
  expect_equal(skew, thrown(-1, "-400 rpm", skew_jar(-1)), "skew prism, mirrored");
}

}  // namespace
}  // namespace mahlwerk::campaign::reversal_test
