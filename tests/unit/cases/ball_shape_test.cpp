// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Balls of a case that are no spheres.
#include "mahlwerk/cases/ball_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/lammps/deck.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::ball_shape_test {
namespace {

using namespace sample;

const std::string mill = R"(title = "bodies"
[mill]
kind = "tumbling"
speed = "70 %"
[jar]
kind = "cylinder"
diameter = "200 mm"
height = "100 mm"
[[balls]]
shape = "cylpebs"
diameter = "12 mm"
length = "14 mm"
density = "7800 kg/m3"
count = 20
[contact]
restitution = 0.6
friction = 0.3
[run]
engine = "soft"
time = "1 s"
)";

std::string code_of(const std::vector<Override>& given) {
  const auto found = faults_of(mill, given);
  return found.size() == 1 ? found[0].code : std::to_string(found.size()) + " faults";
}
std::string engine_code(const std::vector<Override>& given) {
  const auto found = engine_faults(read_sample(mill, given));
  return found.size() == 1 ? found[0].code : std::to_string(found.size()) + " faults";
}

/// The sample with a clump of these members.
std::string clump_of(const std::string& members) {
  return with(with(with(mill, "shape", "shape = \"clump\""), "diameter = \"12", ""), "length",
              "members = " + members);
}

TEST(BallShape, mass_and_volume_are_those_of_the_body) {
  const Case c = read_sample(mill);
  const double volume = std::numbers::pi / 4 * 0.012 * 0.012 * 0.014;
  EXPECT_NEAR(ball_volume(c.balls[0]), volume, 1e-12 * volume);
  EXPECT_NEAR(c.balls[0].mass(), 7800 * volume, 1e-12);
  EXPECT_TRUE(has_bodies(c));
  const auto shapes = body_shapes(c);
  ASSERT_EQ(shapes.size(), 1U);
  // The spheres take the volume of the body: 4/3 pi in units of its equivalent radius.
  const double spheres =
      geometry::union_moments(shapes[0].spheres, 300, geometry::Hollows::filled).volume;
  EXPECT_NEAR(spheres, 4.0 / 3 * std::numbers::pi, 4.2e-3) << "100^-1.5 of it";
}

TEST(BallShape, each_name_is_read_and_written) {
  const std::vector<std::vector<Override>> all{
      {{"balls.shape", "rod"}, {"balls.length", "40 mm"}},
      {{"balls.shape", "ellipsoid"}, {"balls.spheres", "5"}},
      {{"balls.spheres", "40"}}};
  for (const auto& given : all) {
    const Case c = read_sample(mill, given);
    EXPECT_TRUE(read_text(write(c), "case.toml", catalogue()) == c) << write(c);
  }
  const std::string cube =
      with(with(with(mill, "shape", "shape = \"cube\""), "diameter = \"12", "edge = \"12 mm\""),
           "length", "rounding = \"2 mm\"");
  const Case c = read_sample(cube);
  EXPECT_EQ(c.balls[0].body.edge, 0.012);
  EXPECT_TRUE(read_text(write(c), "case.toml", catalogue()) == c) << write(c);
}

TEST(BallShape, convex_surface_is_read_and_written) {
  const Case c = read_sample(mill, {{"balls.surface", "convex"}});
  EXPECT_NEAR(c.balls[0].body.rounding, 0.0012, 1e-15) << "a tenth of the diameter";
  EXPECT_TRUE(body_shapes(c)[0].is_rounded());
  EXPECT_TRUE(read_text(write(c), "case.toml", catalogue()) == c) << write(c);
  const Case disc = read_sample(
      mill, {{"balls.surface", "convex"}, {"balls.length", "3 mm"}, {"balls.rounding", "0.5 mm"}});
  EXPECT_EQ(disc.balls[0].body.length, 0.003) << "flat discs need no spheres";
  EXPECT_EQ(code_of({{"balls.surface", "convex"}, {"balls.rounding", "6 mm"}}), "out-of-range");
  EXPECT_EQ(code_of({{"balls.surface", "convex"}, {"balls.spheres", "30"}}), "too-much");
  EXPECT_EQ(code_of({{"balls.rounding", "1 mm"}}), "too-much");
  EXPECT_EQ(code_of({{"balls.shape", "ellipsoid"}, {"balls.surface", "convex"}}), "too-much");
}

TEST(BallShape, numbers_of_spheres_that_cannot_be_are_one_fault_with_a_remedy) {
  EXPECT_EQ(code_of({{"balls.spheres", "1"}}), "out-of-range") << "said once";
  const auto found = faults_of(mill, {{"balls.diameter", "0.1 mm"}, {"balls.length", "19 mm"}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].what.starts_with("this shape needs at least")) << found[0].what;
  const auto bare = faults_of(clump_of(R"([[0, 0, 0, "5 mm"], ["6 mm", 0, 0, "4 mm"]])"));
  ASSERT_FALSE(bare.empty());
  EXPECT_TRUE(bare[0].remedy.ends_with("each sphere of a clump")) << bare[0].remedy;
}

TEST(BallShape, convex_body_is_one_row_and_is_drawn_as_spheres) {
  const Override convex{"balls.surface", "convex"};
  const Case spheres = read_sample(mill), body = read_sample(mill, {convex});
  EXPECT_EQ(body.balls[0].body.count(), 1);
  EXPECT_EQ(frame_bytes(body), frame_bytes(spheres));
}

TEST(BallShape, convex_surface_needs_a_jar_that_no_wall_bulges_into) {
  EXPECT_EQ(engine_code({{"balls.surface", "convex"}}), "0 faults");
  const Override convex{"balls.surface", "convex"};
  const std::string lifters =
      with(mill, "kind = \"cylinder\"",
           "kind = \"lifter-cylinder\"\nlifters = 4\nlifter_height = \"10 mm\"\n"
           "lifter_width = \"10 mm\"");
  const auto found = engine_faults(read_sample(lifters, {convex}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "not-with-bodies");
  EXPECT_TRUE(engine_faults(read_sample(lifters)).empty());
}

TEST(BallShape, clump_has_mass_and_inertia_of_the_union_of_its_members) {
  const Case c = read_sample(
      clump_of(R"([["1 mm", "2 mm", "3 mm", "6 mm"], ["7 mm", "2 mm", "3 mm", "6 mm"]])"));
  // Two spheres that overlap: both, less two caps of the height h = R - d/2 = 3 mm.
  const double r = 6e-3, h = 3e-3, pi = std::numbers::pi;
  const double volume = 8.0 / 3 * pi * r * r * r - 2 * pi * h * h * (3 * r - h) / 3;
  EXPECT_NEAR(ball_volume(c.balls[0]) / volume, 1, 1.25e-4) << "400^-1.5";
  EXPECT_NEAR(c.balls[0].mass() / (7800 * volume), 1, 1.25e-4);
  EXPECT_EQ(c.balls[0].body.scale(), 1);
  const auto shapes = body_shapes(c);
  ASSERT_EQ(shapes[0].spheres.size(), 2U);
  const double apart = norm(shapes[0].spheres[0].centre - shapes[0].spheres[1].centre);
  EXPECT_NEAR(apart * 0.5 * c.balls[0].diameter, 6e-3, 1e-12) << "about the centre of mass";
  EXPECT_TRUE(read_text(write(c), "case.toml", catalogue()) == c) << write(c);
}

TEST(BallShape, members_that_make_no_body_are_refused) {
  const auto fault = [](const std::string& members) {
    const auto found = faults_of(clump_of(members), {});
    return found.size() == 1 ? found[0].code + ": " + found[0].what
                             : std::to_string(found.size()) + " faults";
  };
  const auto says = [&](const std::string& members, const std::string& code,
                        const std::string& what) {
    const std::string found = fault(members);
    EXPECT_TRUE(found.starts_with(code)) << found;
    EXPECT_NE(found.find(what), std::string::npos) << found;
  };
  says("[]", "wrong-type", "must be a list of spheres");
  says("\"5 mm\"", "wrong-type", "must be a list of spheres");
  says(R"([["0 mm", "0 mm", "5 mm"]])", "wrong-type", "member 1 must have four numbers");
  says(R"([["0 mm", "0 mm", "0 mm", "5 mm"]])", "out-of-range", "at least two members");
  says(R"([["0 mm", "0 mm", "0 mm", "5 mm"], ["1 mm", "0 mm", "0 mm", "-1 mm"]])", "out-of-range",
       "");
  says(R"([["0 mm", "0 mm", "0 mm", "5 mm"], ["6 mm", "0 mm", "0 mm", "4 mm"],
           ["30 mm", "0 mm", "0 mm", "4 mm"]])",
       "out-of-range", "member 3 does not overlap");
  says(R"([["0 mm", "0 mm", "0 mm", "5 mm"], ["5 mm", "0 mm", "0 mm", "0.04 mm"]])", "out-of-range",
       "more than 100 times");
  EXPECT_EQ(code_of({{"balls.shape", "clump"}, {"balls.diameter", "12 mm"}}).substr(2), "faults")
      << "members are missing, diameter and length are too much";
}

TEST(BallShape, spheres_keep_their_case) {
  const Case c = read_sample(vial);
  EXPECT_FALSE(has_bodies(c));
  EXPECT_TRUE(body_shapes(c).empty());
  EXPECT_EQ(write(c).find("shape"), std::string::npos);
}

TEST(BallShape, numbers_that_make_no_body_are_refused) {
  EXPECT_EQ(code_of({{"balls.length", "5 mm"}}), "out-of-range");
  EXPECT_EQ(code_of({{"balls.shape", "rod"}, {"balls.length", "12 mm"}}), "out-of-range");
  EXPECT_EQ(code_of({{"balls.spheres", "3"}}), "out-of-range");
  EXPECT_EQ(code_of({{"balls.length", "1e200 m"}}), "out-of-range");
  EXPECT_EQ(code_of({{"balls.surface", "convex"}, {"balls.length", "1 nm"}}), "out-of-range");
  EXPECT_EQ(code_of({{"balls.edge", "3 mm"}}), "too-much");
  EXPECT_EQ(code_of({{"balls.wall_thickness", "3 mm"}}), "too-much");
}

TEST(BallShape, engines_that_compute_spheres_only_refuse_them) {
  EXPECT_EQ(engine_code({}), "0 faults");
  EXPECT_EQ(engine_code({{"run.engine", "auto"}}), "0 faults");
  EXPECT_EQ(engine_code({{"run.engine", "event"}}), "bodies-need-soft");
  EXPECT_EQ(engine_code({{"run.device", "gpu"}}), "not-with-bodies");
  EXPECT_EQ(engine_code({{"contact.curved_walls", "true"}}), "not-with-bodies");
  EXPECT_EQ(engine_code({{"observe.final_state", "true"}}), "not-with-bodies");
  const auto of_lammps = lammps::faults(read_sample(mill));
  EXPECT_TRUE(std::ranges::any_of(
      of_lammps, [](const Fault& f) { return f.what.find("no spheres") != std::string::npos; }));
}

TEST(BallShape, bodies_start_apart_in_random_orientations) {
  const Case c = read_sample(mill, {{"balls.count", "100"}});
  const std::vector<scene::Ball> balls = starting_balls(c, 0);
  const double reach = c.balls[0].reach();
  EXPECT_GT(reach, 1.1);
  double cosines = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Vec3 axis = rotation_of(balls[i].orientation).ez;
    EXPECT_NEAR(norm(axis), 1, 1e-12);
    cosines += axis.x * axis.x / static_cast<double>(balls.size());
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GE(norm(balls[i].position - balls[j].position),
                reach * (balls[i].radius + balls[j].radius));
  }
  EXPECT_NEAR(cosines, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / 100)) << "four standard deviations";
  EXPECT_EQ(drawn_spheres(c, balls).size(), 100 * body_shapes(c)[0].spheres.size());
}

}  // namespace
}  // namespace mahlwerk::cases::ball_shape_test
