// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Starting positions given in a case, and the reference frame of starting velocities.
#include <gtest/gtest.h>

#include <cmath>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::positions_test {
namespace {

using namespace sample;

/// The jar, 42 mm wide and 32.5 mm high, with 15 mm balls at `places`, given in line 7.
std::string at(const std::string& places) {
  return with(planetary, "count", "positions = " + places);
}

TEST(Positions, are_read_and_counted) {
  const Case c =
      read_sample(at("[[\"9 mm\", \"0 mm\", \"-7.74 mm\"], [\"-1 cm\", \"0 m\", \"0 m\"]]"));
  EXPECT_EQ(c.balls[0].count, 2);
  EXPECT_EQ(c.balls[0].positions, (std::vector<Vec3>{{9e-3, 0, -7.74e-3}, {-1e-2, 0, 0}}));
  EXPECT_EQ(source_of(c, "balls.1.positions"), "case.toml:7");
  EXPECT_EQ(source_of(c, "balls.1.count"), "case.toml:7: one for each of `positions`");
  EXPECT_EQ(read_text(write(c), "case.toml", catalogue()), c);
  const Case counted = read_sample(at("[[\"0 m\", \"0 m\", \"0 m\"]]"), {{"balls.count", "3"}});
  EXPECT_EQ(counted.balls[0].count, 3);
  EXPECT_TRUE(counted.balls[0].positions.empty());
}

TEST(Positions, faults_name_the_ball) {
  const auto fault = [](const std::string& places) { return fault_of(at(places)); };
  const auto is = [](const std::string& text, const std::string& part) {
    return text.find("case.toml:7|") == 0 && text.find('\n') == std::string::npos &&
                   text.find(part) != std::string::npos
               ? ::testing::AssertionSuccess()
               : ::testing::AssertionFailure() << text;
  };
  const std::string middle = "[\"0 m\", \"0 m\", \"0 m\"]";
  EXPECT_TRUE(is(fault("3"), "|wrong-type"));
  EXPECT_TRUE(is(fault("[]"), "|wrong-type"));
  EXPECT_TRUE(is(fault("[" + middle + ", [\"0 m\", \"0 m\"]]"), "ball 2 of `positions`"));
  EXPECT_TRUE(is(fault("[[0, \"0 m\", \"0 m\"]]"), "|bad-quantity"));
  EXPECT_TRUE(
      is(fault("[[\"30 mm\", \"0 m\", \"0 m\"]]"), "ball 1 of balls.1 starts outside the jar"));
  EXPECT_TRUE(is(fault("[[\"0 m\", \"0 m\", \"17 mm\"]]"), "starts outside the jar"));
  EXPECT_TRUE(
      is(fault("[[\"14 mm\", \"0 m\", \"0 m\"]]"), "ball 1 of balls.1 reaches 0.5 mm into the"));
  EXPECT_TRUE(
      is(fault("[" + middle + ", [\"0 m\", \"0 m\", \"14 mm\"]]"), "ball 2 of balls.1 reaches"));
  EXPECT_TRUE(is(fault("[" + middle + ", [\"13 mm\", \"0 m\", \"0 m\"]]"),
                 "ball 1 of balls.1 and ball 2 of balls.1 overlap by 2 mm"));
  EXPECT_TRUE(
      is(fault_of(with(at("[" + middle + "]"), "material", "material = \"steel\"\ncount = 1"))
             .insert(0, "case.toml:7|"),
         "both `count` and `positions`"));
  EXPECT_EQ(faults_of(planetary, {{"balls.positions", "[[\"1 mm\"]]"}}).at(0).where,
            "--set balls.positions");
  // Balls that touch the floor, the side or each other do not overlap.
  EXPECT_EQ(fault("[[\"0 mm\", \"0 m\", \"-8.75 mm\"], [\"0 mm\", \"0 m\", \"6.25 mm\"]]"), "");
  EXPECT_EQ(fault("[[\"13.5 mm\", \"0 m\", \"0 mm\"]]"), "");
}

TEST(Positions, in_a_periodic_box_images_count) {
  std::string text = with(with(drum, "kind = \"tumbling\"", "kind = \"still\""), "speed", "");
  text = with(with(text, "kind = \"cylinder\"",
                   "kind = \"periodic-box\"\nwidth = \"100 mm\"\ndepth = \"100 mm\""),
              "diameter = \"200", "");
  text = "gravity = \"0 m/s2\"\n" + with(text, "diameter = \"10",
                                         "diameter = \"10 mm\"\npositions = [[\"49 mm\", \"0 m\", "
                                         "\"0 m\"], [\"-49 mm\", \"0 m\", \"0 m\"]]");
  EXPECT_NE(fault_of(text).find("overlap by 8 mm"), std::string::npos) << fault_of(text);
  EXPECT_NE(fault_of(text, {{"jar.width", "97 mm"}}).find("starts outside"), std::string::npos);
  EXPECT_EQ(fault_of(text, {{"jar.width", "200 mm"}}), "");
}

TEST(Positions, balls_start_there_and_the_rest_around_them) {
  Case c = read_sample(with(drum, "diameter = \"20 mm",
                            "diameter = \"20 mm\"\npositions = [[\"0 m\", \"0 m\", \"-20 mm\"], "
                            "[\"0 m\", \"90 mm\", \"20 mm\"]]"));
  c.jar.material = "";
  for (const std::int64_t count : {1, 500, 1600}) {  // 1600 balls are pushed apart
    c.balls[0].count = count;
    const auto balls = starting_balls(c, 0);
    ASSERT_EQ(balls.size(), static_cast<std::size_t>(count) + 2);
    const Rotation mount = scene::mounted_along(c.mill.jar_axis);
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_LT(
          norm(mount.apply_inverse(balls[balls.size() - 2 + i].position) - c.balls[1].positions[i]),
          1e-15);
    double least = 1;
    for (std::size_t i = 0; i < balls.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        least = std::min(
            least, norm(balls[i].position - balls[j].position) - balls[i].radius - balls[j].radius);
    EXPECT_GT(least, 0) << count;
  }
}

TEST(StartFrame, a_ball_without_speed_rides_with_the_jar_or_stands_in_the_laboratory) {
  const std::vector<Override> still{{"run.start_speed", "0 m/s"}};
  const Case lab = read_sample(vial, still);
  Case jar = lab;
  jar.run.start_frame = StartFrame::jar;
  const Vec3 frame_velocity = kinematics::frame_motion(*lab.mill.motion, 0).velocity;
  EXPECT_GT(norm(frame_velocity), 1);
  EXPECT_EQ(starting_balls(lab, 0)[0].velocity, -1 * frame_velocity);
  EXPECT_EQ(norm(starting_balls(jar, 0)[0].velocity), 0);
  EXPECT_EQ(starting_balls(jar, 0)[0].position, starting_balls(lab, 0)[0].position);
}

}  // namespace
}  // namespace mahlwerk::cases::positions_test
