// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/pairs.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::parts_test {
namespace {

using namespace sample;

constexpr std::string_view drum = R"(title = "Drum"
[mill]
kind = "tumbling"
speed = "60 rpm"
[jar]
kind = "lifter-cylinder"
diameter = "200 mm"
height = "60 mm"
lifters = 8
lifter_height = "12 mm"
lifter_width = "20 mm"
[[balls]]
diameter = "10 mm"
density = "7800 kg/m3"
count = 20
[run]
time = "1 s"
engine = "soft"
)";

TEST(JarWithParts, lifter_bars_are_read_and_are_faces) {
  const Case c = read_sample(std::string(drum));
  const auto& jar = std::get<geometry::LifterCylinder>(*c.jar.shape);
  EXPECT_EQ(jar.faces, 11);
  EXPECT_EQ(jar.lifter_width, 0.02);
  EXPECT_EQ(face_names(*c.jar.shape).back(), "lifter8");
}

/// A number out of range is no number of bars; bars are not laid out then.
TEST(JarWithParts, a_number_of_bars_out_of_range_is_refused) {
  for (const char* bars : {"0.5", "-1e300", "1001"}) {
    const auto found =
        faults_of(with(std::string(drum), "lifters = 8", std::string("lifters = ") + bars));
    ASSERT_EQ(found.size(), 1U) << bars;
    EXPECT_EQ(found[0].code, "out-of-range");
  }
}

/// The volume of such a jar is no number.
TEST(JarWithParts, bars_wider_than_the_jar_are_refused) {
  const auto found = faults_of(with(std::string(drum), "lifter_width", "lifter_width = \"20 m\""));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "impossible-jar");
}

TEST(JarWithParts, kind_with_underscores_is_read_with_a_note) {
  const Case now = read_sample(std::string(drum));
  const Case old =
      read_sample(with(std::string(drum), "kind = \"lifter", "kind = \"lifter_cylinder\""));
  EXPECT_TRUE(now.remarks.empty());
  ASSERT_EQ(old.remarks.size(), 1U);
  EXPECT_EQ(old.remarks[0].code, "old-spelling");
  EXPECT_NE(old.remarks[0].text.find("lifter-cylinder"), std::string::npos);
  EXPECT_EQ(write(old), write(now)) << "the same case, so the same results and hashes";
  EXPECT_EQ(faults_of(with(std::string(drum), "kind = \"lifter", "kind = \"lifter_drum\""))[0].code,
            "unknown-word");
}

TEST(JarWithParts, sizes_that_do_not_go_together_are_one_fault) {
  const std::vector<Fault> found = faults_of(with(std::string(drum), "lifters", "lifters = 40"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "impossible-jar");
  EXPECT_EQ(found[0].what,
            "there is no such lifter-cylinder: the lifters are so wide that they cover the whole "
            "shell");
}

TEST(JarWithParts, the_event_engine_does_not_take_them) {
  const std::vector<Fault> found =
      engine_faults(read_sample(with(std::string(drum), "engine", "engine = \"event\"")));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "jar-needs-soft");
  EXPECT_TRUE(
      engine_faults(read_sample(with(std::string(drum), "engine", "engine = \"auto\""))).empty());
}

constexpr std::string_view open_drum = R"(title = "Drum without ends"
[mill]
kind = "tumbling"
speed = "60 rpm"
[jar]
kind = "periodic-cylinder"
diameter = "200 mm"
length = "50 mm"
[[balls]]
diameter = "10 mm"
density = "7800 kg/m3"
filling = "30 %"
[run]
time = "1 s"
)";

TEST(PeriodicCylinder, is_read_filled_by_its_volume_and_runs_in_the_soft_engine) {
  const Case c = read_sample(std::string(open_drum));
  const auto& jar = std::get<geometry::PeriodicCylinder>(*c.jar.shape);
  EXPECT_EQ(jar.length, 0.05);
  const double volume = 0.25 * std::numbers::pi * 0.2 * 0.2 * 0.05;
  EXPECT_NEAR(jar.volume(), volume, 1e-15);
  const double ball = std::numbers::pi / 6 * 1e-6;
  EXPECT_EQ(c.balls[0].count, std::lround(0.3 * volume / ball));
  EXPECT_TRUE(engine_faults(c).empty()) << "auto";
  const std::vector<Fault> event =
      engine_faults(read_sample(std::string(open_drum), {{"run.engine", "event"}}));
  ASSERT_EQ(event.size(), 1U);
  EXPECT_EQ(event[0].code, "jar-needs-soft");
}

TEST(PeriodicCylinder, is_refused_where_something_pulls_along_its_axis_or_it_is_too_short) {
  const auto codes = [](const std::vector<Override>& set) {
    std::string all;
    for (const Fault& f : faults_of(std::string(open_drum), set))
      all += f.where + " " + f.code + "\n";
    return all;
  };
  EXPECT_EQ(codes({{"jar.length", "20 mm"}}), "--set jar.length periodic-cylinder\n");
  EXPECT_EQ(codes({{"jar.length", "20.1 mm"}}), "");
  const std::string upright = codes({{"mill.jar_axis", "vertical"}});
  EXPECT_EQ(std::ranges::count(upright, '\n'), 2) << "gravity and the turning axis: " << upright;
  const auto& planetary = [&](const std::string& gravity) {
    return codes({{"mill.kind", "planetary"},
                  {"mill.orbit_radius", "70 mm"},
                  {"mill.ratio", "-2"},
                  {"gravity", gravity}});
  };
  EXPECT_EQ(planetary("0 m/s2"), "") << "the jar's axis is parallel to that of the disc";
  EXPECT_NE(planetary("9.81 m/s2").find("periodic-cylinder"), std::string::npos);
  const auto shaken = [&](const std::string& direction) {
    return codes({{"mill.kind", "circular"},
                  {"mill.radius", "10 mm"},
                  {"mill.jar_axis", direction},
                  {"gravity", "0 m/s2"}});
  };
  EXPECT_EQ(shaken("vertical"), "") << "moves across the axis";
  EXPECT_NE(shaken("horizontal").find("periodic-cylinder"), std::string::npos)
      << "moves along the axis";
}

std::string slice_of(const std::string& jar_keys) {
  std::string text(open_drum);
  text.replace(text.find("periodic-cylinder"), std::string("periodic-cylinder").size(),
               "periodic-lifter-cylinder");
  return text.insert(
      text.find("[[balls]]"),
      "lifters = 6\nlifter_height = \"10 mm\"\nlifter_width = \"20 mm\"\n" + jar_keys);
}

TEST(PeriodicLifterCylinder, has_the_walls_of_the_drum_without_its_ends) {
  const Case c = read_sample(slice_of("lifter_face_angle = \"70 deg\"\n"));
  const auto& jar = std::get<geometry::PeriodicLifterCylinder>(*c.jar.shape);
  geometry::LifterCylinder drum_with_ends{.diameter = 0.2,
                                          .height = 0.05,
                                          .lifters = 6,
                                          .lifter_height = 0.01,
                                          .lifter_width = 0.02,
                                          .lifter_face_angle = jar.lifter_face_angle,
                                          .bars = {}};
  drum_with_ends.complete();
  EXPECT_EQ(geometry::face_names(*c.jar.shape),
            (std::vector<std::string>{"side", "lifter1", "lifter2", "lifter3", "lifter4", "lifter5",
                                      "lifter6"}));
  EXPECT_EQ(jar.volume(), drum_with_ends.volume());
  for (int i = 0; i < 100; ++i) {
    const Vec3 p{0.09 * std::cos(0.1 * i), 0.09 * std::sin(0.1 * i), 0.024};
    for (int face = 0; face < jar.faces; ++face) {
      const geometry::Gap expected = drum_with_ends.gap(face == 0 ? 0 : face + 2, p);
      EXPECT_EQ(jar.gap(face, p).distance, expected.distance);
      EXPECT_EQ(jar.gap(face, p).inward, expected.inward);
    }
  }
}

TEST(PeriodicLifterCylinder, is_refused_as_a_slice_without_lifters_is) {
  const auto codes = [](const std::vector<Override>& set) {
    std::string all;
    for (const Fault& f : faults_of(slice_of(""), set)) all += f.where + " " + f.code + "\n";
    return all;
  };
  EXPECT_EQ(codes({{"jar.length", "20 mm"}}), "--set jar.length periodic-cylinder\n");
  EXPECT_EQ(codes({{"jar.lifter_height", "100 mm"}}).find("periodic-cylinder"), std::string::npos);
  EXPECT_NE(codes({{"jar.lifter_height", "100 mm"}}), "") << "the bars reach the middle";
  EXPECT_NE(codes({{"mill.jar_axis", "vertical"}}).find("periodic-cylinder"), std::string::npos);
}

TEST(PeriodicLifterCylinder, alone_with_the_smooth_slice_has_a_length_of_the_whole_mill) {
  EXPECT_EQ(read_sample(slice_of("mill_length = \"3 m\"\n")).jar.mill_length, 3.0);
  EXPECT_EQ(read_sample(std::string(open_drum), {{"jar.mill_length", "2 m"}}).jar.mill_length, 2.0);
  EXPECT_FALSE(read_sample(slice_of("")).jar.mill_length.has_value());
  const auto faults = faults_of(std::string(drum), {{"jar.mill_length", "3 m"}});
  EXPECT_EQ(faults.size(), 1U) << "a drum with ends is the whole mill";
}

TEST(PeriodicLifterCylinder, is_not_longer_than_the_whole_mill) {
  const double slice =
      geometry::periods(*read_sample(slice_of("mill_length = \"3 m\"\n")).jar.shape).z;
  const auto found = faults_of(slice_of(""), {{"jar.mill_length", "20 mm"}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "mill-length");
  EXPECT_EQ(found[0].where, "--set jar.mill_length");
  EXPECT_NE(found[0].what.find("shorter than the slice"), std::string::npos) << found[0].what;
  const std::string all = std::to_string(1000 * slice) + " mm";
  EXPECT_TRUE(faults_of(slice_of(""), {{"jar.mill_length", all}}).empty()) << "of one slice";
}

}  // namespace
}  // namespace mahlwerk::cases::parts_test
