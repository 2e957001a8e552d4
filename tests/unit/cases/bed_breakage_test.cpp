// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [bed_breakage]: what it takes, what it refuses, and what it assumes.
#include "mahlwerk/cases/bed_breakage.hpp"

#include <gtest/gtest.h>

#include <string>

#include "mahlwerk/cases/faults.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::bed_breakage_test {
namespace {

using namespace sample;

const std::string mill = R"(
[mill]
kind = "vibration"
frequency = "30 Hz"
amplitude = "5 mm"
[jar]
kind = "cylinder"
diameter = "30 mm"
height = "30 mm"
[[balls]]
count = 2
diameter = "8 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.5
friction = 0.3
)";
const std::string models = R"(
[breakage]
model = "vogel-peukert"
f_mat = "1 kg/J/m"
x_w_min = "0.1 J m/kg"
[fragments]
model = "halves"
)";

std::string case_with(const std::string& powder, const std::string& bed = "",
                      const std::string& run = "engine = \"soft\"") {
  return mill + models + "[run]\ntime = \"1 s\"\n" + run +
         "\n[powder]\nmass = \"1 g\"\nsize = \"1 mm\"\ndensity = \"2650 kg/m3\"\n" + powder +
         "\n[bed_breakage]\n" + bed + "\n";
}
std::string code(const std::string& text) {
  const auto found = faults_of(text);
  return found.empty() ? "" : found.front().code;
}

TEST(BedBreakage, assumes_a_quarter_of_the_grains_and_four_times_their_number) {
  const Case c = read_sample(case_with("as = \"grains\""));
  const powder::BedBreakage bed = bed_breakage(c);
  EXPECT_DOUBLE_EQ(bed.grain_size, 1e-3);
  EXPECT_DOUBLE_EQ(bed.smallest_fragment, 0.25e-3);
  EXPECT_EQ(bed.diameters().size(), 7U);  // two octaves of three classes, and the grains
  EXPECT_EQ(largest_grain_number(c), 4 * c.balls.back().count);
  EXPECT_EQ(static_cast<std::int64_t>(spare_grains(c).size()), 3 * c.balls.back().count);
  EXPECT_FALSE(bed.coarse);
}

TEST(BedBreakage, grains_that_stand_for_many_keep_their_spheres) {
  const Case c = read_sample(case_with("as = \"grains\"\ngrain_size = \"2 mm\""));
  EXPECT_TRUE(bed_breakage(c).coarse);
  EXPECT_TRUE(spare_grains(c).empty());
  EXPECT_EQ(code(case_with("as = \"grains\"\ngrain_size = \"2 mm\"", "smallest = \"0.1 mm\"")),
            "too-much");
}

TEST(BedBreakage, refuses_what_it_cannot_compute) {
  EXPECT_EQ(code(case_with("")), "bad-bed-breakage");
  EXPECT_EQ(code(case_with("as = \"grains\"", "smallest = \"1 mm\"")), "bad-bed-breakage");
  EXPECT_EQ(code(case_with("as = \"grains\"", "finest = \"0.5 mm\"")), "bad-bed-breakage");
  EXPECT_EQ(code(case_with("as = \"grains\"", "largest_number = 10")), "bad-bed-breakage");
  EXPECT_EQ(code(case_with("as = \"grains\"") + "[mixing]\n"), "bad-bed-breakage");
  EXPECT_EQ(code(case_with("as = \"grains\"", "classes_per_octave = 4")), "out-of-range");
  const auto event =
      engine_faults(read_sample(case_with("as = \"grains\"", "", "engine = \"event\"")));
  ASSERT_FALSE(event.empty());
  EXPECT_EQ(event.front().code, "bed-breakage-needs-soft");
  EXPECT_EQ(code(case_with("as = \"grains\"") + "[observe]\nfinal_state = true\n"),
            "bad-bed-breakage");
  EXPECT_EQ(
      code(mill + "[run]\ntime = \"1 s\"\n[powder]\nmass = \"1 g\"\nsize = \"1 mm\"\ndensity = "
                  "\"2650 kg/m3\"\nas = \"grains\"\n[bed_breakage]\n"),
      "lone-section");
}

}  // namespace
}  // namespace mahlwerk::cases::bed_breakage_test
