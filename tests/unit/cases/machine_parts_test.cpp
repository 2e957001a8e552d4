// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Faults of [[parts]], the bodies of the mill in the jar.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/setup/fill.hpp"
#include "mahlwerk/cases/setup/grid.hpp"
#include "mahlwerk/cases/setup/obstacles.hpp"
#include "mahlwerk/cases/setup/push_apart.hpp"
#include "mahlwerk/geometry/any_shape.hpp"
#include "meshes.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::machine_parts_test {
namespace {

using namespace sample;

/// A vessel with the parts of `parts`.
std::string vessel(const std::string& parts) {
  return R"(title = "Vessel"
[mill]
kind = "still"
[jar]
kind = "cylinder"
diameter = "100 mm"
height = "100 mm"
[[balls]]
diameter = "10 mm"
density = "7800 kg/m3"
count = 20
[run]
time = "1 s"
engine = "soft"
)" + parts;
}

const std::string disc = R"([[parts]]
name = "disc"
kind = "disc"
diameter = "60 mm"
thickness = "5 mm"
motion = "turning"
speed = "300 rpm"
)";

/// "code: what|remedy" of each fault.
std::vector<std::string> told(const std::string& text, const std::vector<Override>& set = {}) {
  std::vector<std::string> all;
  for (const Fault& f : faults_of(text, set))
    all.push_back(f.where + "|" + f.code + "|" + f.what + "|" + f.remedy);
  return all;
}

TEST(MachineParts, that_a_change_names_and_the_case_lacks_are_counted) {
  const std::string remedy =
      "|name a value of a part by the number of its [[parts]] in the case, from 1: parts.1.speed; "
      "a further part needs a [[parts]] of its own in the case file";
  EXPECT_TRUE(told(vessel(disc), {{"parts.1.speed", "200 rpm"}}).empty());
  EXPECT_EQ(told(vessel(disc), {{"parts.3.speed", "200 rpm"}}),
            std::vector<std::string>{"--set parts.3.speed|unknown-key|\"parts.3.speed\" names "
                                     "nothing in the case; parts in the case: 1" +
                                     remedy});
  EXPECT_EQ(told(vessel(disc), {{"parts.stirrer.speed", "200 rpm"}}),
            std::vector<std::string>{"--set parts.stirrer.speed|unknown-key|"
                                     "\"parts.stirrer.speed\" names nothing in the case; parts in "
                                     "the case: 1" +
                                     remedy});
  EXPECT_EQ(told(vessel(""), {{"parts.1.speed", "200 rpm"}}),
            std::vector<std::string>{"--set parts.1.speed|unknown-key|\"parts.1.speed\" names "
                                     "nothing in the case; parts in the case: 0" +
                                     remedy});
}

/// The table says where the part is: without one nothing is known of it.
TEST(MachineParts, with_a_bad_motion_file_have_this_fault_alone) {
  const auto faults_with = [](const std::string& table) {
    const Folder folder;
    if (!table.empty()) folder.write("motion.csv", table);
    folder.write("case.toml", vessel(R"([[parts]]
name = "piston"
kind = "disc"
diameter = "60 mm"
thickness = "5 mm"
position = ["0 mm", "0 mm", "500 mm"]
motion = "tabulated"
motion_file = "motion.csv"
)"));
    std::vector<std::string> codes;
    try {
      read(folder.path() / "case.toml", catalogue());
    } catch (const InputError& error) {
      for (const Fault& f : error.faults()) codes.push_back(f.code);
    }
    return codes;
  };
  using Codes = std::vector<std::string>;
  EXPECT_EQ(faults_with(""), Codes{"no-such-file"});
  EXPECT_EQ(faults_with("nonsense\n"), Codes{"bad-motion-file"});
  EXPECT_EQ(faults_with("time_s,x_m,y_m,z_m\n0,0,0,0\n1,0,0,0\n"), Codes{"bad-motion-file"});
  EXPECT_EQ(
      faults_with("time_s,x_m,y_m,z_m\n0,0,0,0\n1,0,0,0.001\n2,0,0,0\n3,0,0,0.001\n4,0,0,0\n"),
      Codes{"bad-part"})
      << "a sound table that keeps the part outside the jar";
}

// A slice of a drum, periodic along its axis z.

std::string slice(const std::string& part, const std::string& length = "100 mm") {
  return R"(title = "Slice"
[mill]
kind = "tumbling"
speed = "60 rpm"
[jar]
kind = "periodic-cylinder"
diameter = "400 mm"
length = ")" +
         length + R"("
[[balls]]
diameter = "20 mm"
density = "7800 kg/m3"
count = 20
[run]
time = "1 s"
engine = "soft"
[[parts]]
name = "bar"
)" + part;
}

/// The codes of all faults, and whether the first tells this.
::testing::AssertionResult refused(const std::string& text, const std::string& what) {
  const std::vector<Fault> found = faults_of(text);
  const bool as_told = found.size() == 1 && found[0].code == "bad-part" &&
                       found[0].what.find(what) != std::string::npos && !found[0].remedy.empty();
  if (as_told) return ::testing::AssertionSuccess();
  std::string all;
  for (const std::string& one : told(text)) all += one + "\n";
  return ::testing::AssertionFailure() << found.size() << " faults: " << all;
}

/// Balls of 20 mm in a period of 100 mm: a part fits with its images if it reaches 40 mm, or if it
/// is a bar without an end.
TEST(MachineParts, in_a_periodic_jar_leave_room_for_a_ball_between_their_images) {
  const auto bar = [](const std::string& length) {
    return "kind = \"cylinder\"\ndiameter = \"30 mm\"\nlength = \"" + length + "\"\n";
  };
  EXPECT_TRUE(told(slice(bar("80 mm"))).empty());
  EXPECT_TRUE(refused(slice(bar("81 mm")),
                      "reaches 40.5 mm from its position along the axis z of a period of 100 mm: a "
                      "ball of 20 mm"));
  EXPECT_TRUE(refused(slice(bar("99.9 mm")), "and its periodic image at once"));
  EXPECT_TRUE(told(slice(bar("100 mm"))).empty()) << "with its images one bar without end";
  EXPECT_TRUE(told(slice(bar("300 mm"))).empty());
  EXPECT_TRUE(refused(slice(bar("100 mm") + "axis = [0.1, 0, 1]\n"), "at once")) << "not along z";
  EXPECT_TRUE(told(slice(bar("200 mm") + "axis = [1, 0, 0]\n")).empty()) << "across z";
  EXPECT_TRUE(told(slice(bar("81 mm"), "200 mm")).empty()) << "in a longer slice";
  const std::string cone =
      "kind = \"cone\"\ndiameter = \"30 mm\"\ntop_diameter = \"20 mm\"\nlength = \"100 mm\"\n";
  EXPECT_TRUE(refused(slice(cone), "at once")) << "its ends differ";
  const auto blade = [](const std::string& axis) {
    return "kind = \"blade\"\nlength = \"60 mm\"\nthickness = \"10 mm\"\nheight = \"110 mm\"\n" +
           axis;
  };
  EXPECT_TRUE(told(slice(blade(""))).empty());
  EXPECT_TRUE(told(slice(blade("axis = [0, 1, 0]\n"))).empty());
  EXPECT_TRUE(refused(slice(blade("axis = [0, 1, 1]\n")), "at once"));
}

TEST(MachineParts, that_are_planes_in_a_periodic_jar_lie_along_its_axis) {
  EXPECT_TRUE(refused(slice("kind = \"plane\"\nposition = [\"0 mm\", \"0 mm\", \"-40 mm\"]\n"),
                      "the plane bar lies across the axis z"));
  EXPECT_TRUE(refused(slice("kind = \"plane\"\naxis = [1, 0, 0.01]\n"), "lies across the axis z"));
  EXPECT_TRUE(told(slice("kind = \"plane\"\naxis = [1, 0, 0]\nposition = [\"-150 mm\", \"0 mm\", "
                         "\"0 mm\"]\n"))
                  .empty());
}

/// The case `text` beside the file bar.stl of these triangles.
std::vector<Fault> faults_with_mesh(const std::string& text, const tests::Triangles& triangles) {
  const Folder folder;
  folder.write("bar.stl", tests::binary_stl(triangles));
  folder.write("case.toml", text);
  try {
    read(folder.path() / "case.toml", catalogue());
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}
const std::string mesh = "kind = \"mesh\"\nfile = \"bar.stl\"\nunit = \"mm\"\n";

TEST(MachineParts, of_triangles_in_a_periodic_jar_are_short_or_bars_that_span_it) {
  EXPECT_TRUE(faults_with_mesh(slice(mesh), tests::box(0.03, 0.02, 0.08)).empty());
  EXPECT_EQ(faults_with_mesh(slice(mesh), tests::box(0.03, 0.02, 0.09)).size(), 1U);
  EXPECT_TRUE(faults_with_mesh(slice(mesh), tests::box(0.03, 0.02, 0.1)).empty());
  tests::Triangles tapered = tests::box(0.03, 0.02, 0.1);
  for (geometry::Corners& c : tapered)
    for (Vec3& p : c)
      if (p.z > 0) p.x *= 0.9;
  EXPECT_EQ(faults_with_mesh(slice(mesh), tapered).size(), 1U) << "no bar: its ends differ";
}

// Balls that start in parts.

std::string vessel_with_ball_at(const std::string& place, const std::string& parts) {
  return with(vessel(parts), "count", "positions = [" + place + "]");
}

TEST(MachineParts, do_not_hold_balls_of_given_positions) {
  const auto fault = [](const std::string& place) {
    const std::vector<std::string> all = told(vessel_with_ball_at(place, disc));
    return all.empty() ? std::string() : all.size() == 1 ? all[0] : "several";
  };
  EXPECT_NE(
      fault("[\"0 mm\", \"0 mm\", \"1 mm\"]").find("ball 1 of balls.1 starts inside the part disc"),
      std::string::npos);
  EXPECT_NE(fault("[\"0 mm\", \"0 mm\", \"7 mm\"]").find("reaches 0.5 mm into the part disc"),
            std::string::npos);
  EXPECT_EQ(fault("[\"0 mm\", \"0 mm\", \"7.5 mm\"]"), "") << "touches it";
  EXPECT_TRUE(told(vessel_with_ball_at("[\"0 mm\", \"0 mm\", \"1 mm\"]",
                                       disc + "opening = \"12 mm\"\n[[balls]]\ndiameter = \"12 "
                                              "mm\"\ndensity = \"7800 kg/m3\"\ncount = 1\n"))
                  .empty())
      << "the ball passes its opening";
}

TEST(MachineParts, of_triangles_do_not_hold_balls_of_given_positions) {
  const tests::Triangles block = tests::box(0.06, 0.06, 0.04);
  const std::string part = "[[parts]]\nname = \"block\"\n" + mesh;
  const auto codes = [&](const std::string& z) {
    std::string all;
    for (const Fault& f :
         faults_with_mesh(vessel_with_ball_at("[\"0 mm\", \"0 mm\", \"" + z + "\"]", part), block))
      all += f.code + ": " + f.what + "\n";
    return all;
  };
  EXPECT_EQ(codes("0 mm"), "ball-in-part: ball 1 of balls.1 starts inside the part block\n");
  EXPECT_EQ(codes("24 mm"), "ball-in-part: ball 1 of balls.1 reaches 1 mm into the part block\n");
  EXPECT_EQ(codes("25.001 mm"), "");
}

/// [m] Smallest distance of a ball from the parts, less its radius.
double least_clearance(const Case& c, const std::vector<scene::Ball>& balls) {
  const Obstacles obstacles(c);
  double least = 1;
  for (const scene::Ball& b : balls)
    least = std::min(least, obstacles.clearance(b.position, b.radius) - b.radius);
  return least;
}

TEST(MachineParts, are_free_of_balls_that_are_placed_at_random) {
  const Folder folder;
  folder.write("bar.stl", tests::binary_stl(tests::box(0.06, 0.06, 0.04)));
  // 520 balls of 10 mm fill half of what the block leaves of the vessel: they are pushed apart.
  folder.write("case.toml",
               with(vessel("[[parts]]\nname = \"block\"\n" + mesh), "count", "count = 640"));
  const Case c = read(folder.path() / "case.toml", catalogue());
  Random random(1, 0);
  const Obstacles obstacles(c);
  const auto balls = fill(*c.jar.shape, c.balls, random, nullptr, nullptr, &obstacles);
  EXPECT_EQ(balls.size(), 640U);
  EXPECT_GT(least_clearance(c, balls), 0);
}

/// No face of a mesh is in front of a centre inside it: the way out is that to its nearest point.
/// The gap between the rim of the disc and the wall is as wide as a ball, so that others push some
/// balls into it and none pushes them out.
TEST(MachineParts, have_no_balls_wedged_between_them_and_the_wall) {
  std::string text = with(vessel(disc), "diameter = \"100", "diameter = \"40 mm\"");
  text =
      with(with(text, "height", "height = \"20 mm\""), "diameter = \"60", "diameter = \"30 mm\"");
  text = with(with(text, "thickness", "thickness = \"3 mm\""), "diameter = \"10",
              "diameter = \"5 mm\"");
  for (const char* filling : {"60 %", "65 %"}) {
    const Case c = read_sample(
        with(text, "count", std::string("bulk_filling = \"").append(filling).append("\"")));
    const Obstacles obstacles(c);
    const std::vector<scene::Ball> balls = starting_balls(c, 0);
    double nearest = 1, closest = 1;  // over the radius; over the diameter
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const Vec3& p = balls[i].position;
      nearest = std::min({nearest, obstacles.clearance(p, 0.0025) / 0.0025,
                          geometry::nearest_wall(*c.jar.shape, p, 0.0025) / 0.0025});
      for (std::size_t j = 0; j < i; ++j)
        closest = std::min(closest, norm(p - balls[j].position) / 0.005);
    }
    EXPECT_GE(nearest, 1) << filling;
    EXPECT_GE(closest, 1) << filling;
  }
}

TEST(MachineParts, of_triangles_push_out_balls_whose_centres_are_inside) {
  const Folder folder;
  folder.write("bar.stl", tests::binary_stl(tests::box(0.06, 0.06, 0.04)));
  folder.write("case.toml", vessel("[[parts]]\nname = \"block\"\n" + mesh));
  const Case c = read(folder.path() / "case.toml", catalogue());
  const Obstacles obstacles(c);
  std::vector<PlacedBall> balls{{{0.01, 0.005, 0.015}, 0.005, false}};
  const Domain domain{.half = {0.05, 0.05, 0.05},
                      .periods = {geometry::never, geometry::never, geometry::never}};
  const PushApartResult end =
      push_apart(balls, *c.jar.shape, domain, 1e-6, 10'000, nullptr, &obstacles);
  EXPECT_TRUE(end.free);
  EXPECT_GT(obstacles.clearance(balls[0].position, 0.005), 0.005);
}

}  // namespace
}  // namespace mahlwerk::cases::machine_parts_test
