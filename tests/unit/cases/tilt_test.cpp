// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Mills that lean, gravity in any direction, and mills that turn the other way.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::tilt_test {
namespace {

using namespace sample;

constexpr double g = 9.81;

void expect_near(const Vec3& found, const Vec3& expected) {
  EXPECT_LT(norm(found - expected), 1e-14 * g)
      << found.x << ' ' << found.y << ' ' << found.z << " instead of " << expected.x << ' '
      << expected.y << ' ' << expected.z;
}

std::string leaning(const std::string& tilt) {
  return with(drum, "speed", "speed = \"75 %\"\ntilt = \"" + tilt + "\"");
}

TEST(Tilt, a_level_mill_has_gravity_straight_down) {
  const Case c = read_sample(drum);
  EXPECT_EQ(c.gravity_vector(), (Vec3{0, 0, -g}));
  EXPECT_EQ(chamber(c).gravity, (Vec3{0, 0, -g}));
  EXPECT_EQ(write(c).find("tilt"), std::string::npos);
  EXPECT_EQ(write(c).find("gravity_direction"), std::string::npos);
}

TEST(Tilt, the_x_axis_of_a_tilted_mill_rises) {
  // (kin.19): a drum that leans by 30 degrees has half of gravity along its axis, towards -x.
  const Case c = read_sample(leaning("30 deg"));
  expect_near(c.gravity_vector(), {-g / 2, 0, -g * std::sqrt(0.75)});
  expect_near(chamber(c).gravity, c.gravity_vector());
  expect_near(read_sample(leaning("-30 deg")).gravity_vector(), {g / 2, 0, -g * std::sqrt(0.75)});
  expect_near(read_sample(leaning("90 deg")).gravity_vector(), {-g, 0, 0});
  EXPECT_EQ(read_sample(write(c)), c);
}

TEST(Tilt, the_critical_speed_of_a_leaning_drum_is_that_of_gravity_across_its_axis) {
  const auto speed = [](const Case& c) {
    return std::get<kinematics::Tumbling>(*c.mill.motion).speed;
  };
  const double level = speed(read_sample(drum));
  EXPECT_NEAR(speed(read_sample(leaning("60 deg"))) / level, std::sqrt(0.5), 1e-14);
}

TEST(Tilt, every_kind_but_a_vibration_takes_it_as_the_lean_of_the_mill) {
  const auto gravity_of = [](const std::string& mill) {
    return read_sample("[mill]\n" + mill +
                       "tilt = \"30 deg\"\n[jar]\nkind = \"sphere\"\ndiameter = \"50 "
                       "mm\"\n[[balls]]\ndiameter = \"5 mm\"\ndensity = \"7 g/cm3\"\n[run]\ntime = "
                       "\"1 s\"\n")
        .gravity_vector();
  };
  const Vec3 leans{-g / 2, 0, -g * std::sqrt(0.75)};
  expect_near(gravity_of("kind = \"still\"\n"), leans);
  expect_near(gravity_of("kind = \"planetary\"\norbit_radius = \"7 cm\"\nspeed = \"300 "
                         "rpm\"\nratio = -2\n"),
              leans);
  expect_near(gravity_of("kind = \"arc-shaker\"\narm = \"136 mm\"\nswing = \"4 deg\"\nfrequency = "
                         "\"20 Hz\"\n"),
              leans);
  expect_near(gravity_of("kind = \"circular\"\nradius = \"17 mm\"\nspeed = \"300 rpm\"\n"), leans);
  expect_near(gravity_of("kind = \"figure-eight\"\nfrequency = \"17 Hz\"\nstroke_along = \"30 "
                         "mm\"\nstroke_across = \"12 mm\"\n"),
              leans);
  expect_near(gravity_of("kind = \"vibration\"\nfrequency = \"17 Hz\"\namplitude = \"5 mm\"\n"),
              {0, 0, -g});
}

TEST(Tilt, gravity_has_any_direction_and_any_length_of_its_vector) {
  const auto directed = [](const std::string& direction) {
    return "gravity_direction = " + direction + "\n" + vial;
  };
  const Case c = read_sample(directed("[3, 0, -4]"));
  expect_near(c.gravity_vector(), {0.6 * g, 0, -0.8 * g});
  EXPECT_EQ(read_sample(write(c)), c);
  expect_near(read_sample(directed("[0, -2, 0]")).gravity_vector(), {0, -g, 0});
  for (const char* wrong : {"[0, 0, 0]", "[1, 2]", "\"down\""})
    EXPECT_TRUE(only(directed(wrong), "case.toml:1", "list of three numbers", "wrong-type"));
}

TEST(Tilt, layers_at_the_start_lie_against_gravity) {
  // The first of two ball sets lies lowest: along gravity, here towards +x of the mill.
  const std::string text = with(with(drum, "diameter", "diameter = \"60 mm\""), "time",
                                "time = \"1 s\"\nstart = \"layers\"");
  const Case c = read_sample("gravity_direction = [0, 1, 0]\n" + text);
  const auto balls = starting_balls(c, 0);
  ASSERT_EQ(balls.size(), 2U);
  EXPECT_LE(balls[1].position.y, balls[0].position.y);
}

TEST(Reverse, a_mill_that_turns_backwards_is_the_mirror_image) {
  const auto mirrored = [](const Vec3& a) { return Vec3{a.x, -a.y, a.z}; };
  const kinematics::Planetary ahead{.orbit_radius = 0.08, .speed = 36, .ratio = -2.2},
      back{.orbit_radius = 0.08, .speed = -36, .ratio = -2.2};
  const kinematics::Circular round{{}, 0.017, 50}, other{{}, 0.017, -50};
  for (const double t : {0.0, 0.013, 0.4, 7.7}) {
    EXPECT_EQ(back.frame_motion(t).centre, mirrored(ahead.frame_motion(t).centre));
    EXPECT_EQ(back.frame_motion(t).velocity, mirrored(ahead.frame_motion(t).velocity));
    EXPECT_EQ(back.frame_motion(t).acceleration, mirrored(ahead.frame_motion(t).acceleration));
    EXPECT_EQ(back.spin(t), -ahead.spin(t)) << "a spin is an axial vector";
    EXPECT_EQ(other.frame_motion(t).velocity, mirrored(round.frame_motion(t).velocity));
  }
  EXPECT_EQ(back.period(), ahead.period());
  EXPECT_EQ(back.bounds().speed, ahead.bounds().speed);
  EXPECT_EQ(back.bounds().jerk, ahead.bounds().jerk);
  EXPECT_EQ(other.bounds().jerk, round.bounds().jerk);
}

TEST(Reverse, a_negative_speed_is_read_and_0_is_not_a_speed) {
  const std::string text = with(planetary, "model = \"p7\"",
                                "kind = \"planetary\"\norbit_radius = \"70 mm\"\nratio = -2");
  const Case c = read_sample(with(text, "speed", "speed = \"-400 rpm\""));
  EXPECT_LT(std::get<kinematics::Planetary>(*c.mill.motion).speed, 0);
  const Case named = read_sample(with(planetary, "speed", "speed = \"-400 rpm\""));
  EXPECT_LT(std::get<kinematics::Planetary>(*named.mill.motion).speed, 0);
  EXPECT_GT(shaft_speed(c).value(), 0) << "the torque has the sign of the power";
  expect_says("it must be other than 0", with(text, "speed", "speed = \"0 rpm\""));
}

}  // namespace
}  // namespace mahlwerk::cases::tilt_test
