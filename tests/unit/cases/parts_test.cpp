// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "mahlwerk/cases/pairs.hpp"
#include "mahlwerk/cases/read.hpp"
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
kind = "lifter_cylinder"
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

TEST(JarWithParts, sizes_that_do_not_go_together_are_one_fault) {
  const std::vector<Fault> found = faults_of(with(std::string(drum), "lifters", "lifters = 40"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "impossible-jar");
  EXPECT_EQ(found[0].what,
            "there is no such lifter_cylinder: the lifters are so wide that they cover the whole "
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

}  // namespace
}  // namespace mahlwerk::cases::parts_test
