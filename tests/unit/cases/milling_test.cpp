// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The one milling time of a case.
#include <gtest/gtest.h>

#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/write.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::milling_test {
namespace {

using namespace sample;

const std::string milling = "[milling]\ntime = \"1 h\"\n";
const std::string kinetics = "[kinetics]\ndose_constant = \"5 kJ/g\"\n";
const std::string grinding = R"([capture]
model = "fixed"
mass = "1 mg"
[breakage]
model = "vogel-peukert"
f_mat = "1 kg/J/m"
x_w_min = "0.1 J m/kg"
[fragments]
model = "binary"
[grinding]
)";

TEST(MillingTime, is_given_once_for_sizes_conversion_and_temperatures) {
  const Case c = read_sample(powdered + milling + grinding + kinetics + "[heat]\n");
  EXPECT_EQ(c.grinding->time, 3600);
  EXPECT_EQ(c.kinetics->time, 3600);
  EXPECT_EQ(c.heat->milling, 3600);
  EXPECT_EQ(milling_time(c), 3600);
  EXPECT_EQ(source_of(c, "grinding.time"), "default: that of [milling]");
  EXPECT_EQ(milling_time(read_sample(powdered + milling)), 3600);
  EXPECT_EQ(milling_time(read_sample(powdered)), std::nullopt);
}

TEST(MillingTime, makes_another_case) {
  EXPECT_FALSE(read_sample(powdered + milling) == read_sample(powdered));
}

TEST(MillingTime, of_heat_is_shared_by_its_cycles) {
  const Case c = read_sample(powdered + milling + "[heat]\npause = \"5 min\"\ncycles = 4\n");
  EXPECT_EQ(c.heat->milling, 900);
  EXPECT_EQ(milling_time(c), 3600);
}

TEST(MillingTime, of_any_section_holds_for_the_others) {
  const Case c = read_sample(powdered + grinding + "time = \"30 s\"\n" + kinetics + "[heat]\n");
  EXPECT_EQ(c.kinetics->time, 30);
  EXPECT_EQ(c.heat->milling, 30);
  EXPECT_EQ(read_sample(powdered + grinding + kinetics + "time = \"2 h\"\n").grinding->time, 7200);
}

TEST(MillingTime, is_refused_where_two_sections_contradict_each_other) {
  expect_says(
      "heat.milling = 10 min in 3 cycles, but milling.time = 1 h: a case has one milling time",
      powdered + milling + "[heat]\nmilling = \"10 min\"\ncycles = 3\n");
  expect_says("give it once, as [milling] time: the other sections then use it|two-milling-times",
              powdered + grinding + "time = \"30 s\"\n" + kinetics + "time = \"40 s\"\n");
  const std::string agree = "[heat]\nmilling = \"20 min\"\ncycles = 3\n";
  EXPECT_EQ(milling_time(read_sample(powdered + milling + agree)), 3600);
}

TEST(MillingTime, survives_writing_and_reading) {
  const Case c = read_sample(powdered + milling + "dose = \"10 kJ/g\"\n" + kinetics + "[heat]\n");
  EXPECT_EQ(c.milling->dose, 1e7);
  EXPECT_EQ(read_text(write(c), "again.toml", catalogue()), c);
}

TEST(PlausibleRange, stands_beside_an_assumed_value_only) {
  const auto ends = [](const Case& c, std::string_view key) {
    const auto at = std::ranges::find(c.origins, key, &Origin::key);
    return at == c.origins.end() ? std::array<std::string, 2>{"-", "-"} : at->range;
  };
  const std::string assumed = with(with(vial, "restitution", ""), "tangential", "");
  EXPECT_EQ(ends(read_sample(assumed), "contact.restitution"),
            (std::array<std::string, 2>{"0.3", "0.9"}));
  EXPECT_EQ(ends(read_sample(assumed), "contact.friction"),
            (std::array<std::string, 2>{"0.1", "0.6"}));
  EXPECT_EQ(ends(read_sample(vial), "contact.restitution"), (std::array<std::string, 2>{}));
  const std::string pair = "[[contact.pairs]]\nbetween = [\"balls\", \"jar\"]\n";
  EXPECT_EQ(ends(read_sample(assumed + pair), "contact.pairs.1.restitution"),
            (std::array<std::string, 2>{}));  // follows that of [contact]
}

}  // namespace
}  // namespace mahlwerk::cases::milling_test
