// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What a case says of wear and heat: hardness, conductivity, [wear], [heat].
#include <gtest/gtest.h>

#include <algorithm>

#include "mahlwerk/cases/read.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases {
namespace {

using namespace sample;

/// The one fault as "line code"; what there is if it is another number.
std::string fault(const std::string& text) {
  const auto found = faults_of(text);
  if (found.size() != 1) return fault_of(text);
  return found[0].where.substr(found[0].where.find(':') + 1) + " " + found[0].code;
}
bool assumed(const Case& c, std::string_view key) {
  const auto at = std::ranges::find(c.origins, key, &Origin::key);
  return at != c.origins.end() && at->assumed;
}
Heat heat_of(const std::string& lines) {
  return read_sample(vial + "[heat]\n" + lines).heat.value();
}
Wear wear_of(const std::string& lines) {
  return read_sample(vial + "[wear]\n" + lines).wear.value();
}
/// The first line of the section is line 25 of the file.
std::string heat_fault(const std::string& lines) {
  return fault(vial + "[heat]\n" + lines);
}

TEST(ReadSubstance, from_the_case_the_material_or_hardened_steel) {
  const Case c = read_sample(with(planetary, "count", "count = 5\nhardness = 800"),
                             {{"jar.material", "mystery"}, {"jar.wall", "8 mm"}});
  EXPECT_EQ(c.balls[0].substance, (Substance{800, 30, 460}));
  EXPECT_EQ(c.jar.substance, (Substance{5, 30, 460}));
  EXPECT_EQ(source_of(c, "jar.hardness"), "catalogue materials/mystery: test sheet");
  EXPECT_EQ(c.jar.density, 7730);
  EXPECT_EQ(source_of(c, "jar.density"),
            "default: hardened steel (1.4034), handbook; uncalibrated; the catalogue gives none "
            "for mystery");
  EXPECT_EQ(c.jar.wall, 8e-3);
  EXPECT_EQ(read_sample(planetary).jar.density, 7700);  // of its steel
  EXPECT_EQ(read_sample(vial).jar.wall, 5e-3);
}

TEST(ReadSubstance, of_grains_is_that_of_the_powder) {
  const std::string grains = "size = \"1 mm\"\nas = \"grains\"\nconductivity = \"0.2 W/m/K\"";
  const Case c = read_sample(with(planetary, "size", grains));
  EXPECT_EQ(c.balls.back().substance.conductivity, 0.2);
  EXPECT_EQ(fault(with(planetary, "size", "hardness = 5")), "13 too-much");
}

TEST(ReadSubstance, out_of_range) {
  const auto ball = [](const std::string& line) { return fault(with(planetary, "count", line)); };
  EXPECT_EQ(ball("hardness = 0"), "7 out-of-range");
  EXPECT_EQ(ball("hardness = \"6 GPa\""), "7 bad-quantity");
  EXPECT_EQ(ball("conductivity = \"-1 W/m/K\""), "7 out-of-range");
  EXPECT_EQ(ball("heat_capacity = 460"), "7 bad-quantity");
  EXPECT_EQ(fault(with(planetary, "model = \"pot\"", "model = \"pot\"\nwall = \"0 mm\"")),
            "6 out-of-range");
}

TEST(ReadOrigins, what_nobody_asked_for_is_not_assumed) {
  const Case silent = read_sample(vial), wear = read_sample(vial + "[wear]\n"),
             heat = read_sample(vial + "[heat]\n");
  for (const char* key : {"balls.1.hardness", "jar.hardness"}) {
    EXPECT_FALSE(assumed(silent, key)) << key;
    EXPECT_TRUE(assumed(wear, key)) << key;
    EXPECT_FALSE(assumed(heat, key)) << key;
  }
  for (const char* key : {"balls.1.conductivity", "jar.heat_capacity", "jar.wall"}) {
    EXPECT_FALSE(assumed(silent, key)) << key;
    EXPECT_FALSE(assumed(wear, key)) << key;
    EXPECT_TRUE(assumed(heat, key)) << key;
  }
  EXPECT_FALSE(assumed(silent, "jar.density"));
  EXPECT_TRUE(assumed(wear, "jar.density"));
  EXPECT_TRUE(assumed(heat, "jar.density"));
  EXPECT_TRUE(assumed(wear, "wear.coefficient"));
  EXPECT_TRUE(assumed(heat, "heat.cooling"));
  EXPECT_NE(source_of(silent, "jar.wall"), "");
}

TEST(ReadWear, models_and_coefficients) {
  EXPECT_FALSE(read_sample(vial).wear.has_value());
  EXPECT_EQ(wear_of(""), Wear());
  EXPECT_EQ(wear_of("model = \"finnie\"").model, Wear::Model::finnie);
  EXPECT_EQ(wear_of("model = \"archard\"\ncoefficient = 1e-5").coefficient, 1e-5);
  EXPECT_EQ(fault(vial + "[wear]\nmodel = \"finny\""), "25 unknown-word");
  EXPECT_EQ(fault(vial + "[wear]\ncoefficient = 0"), "25 out-of-range");
  EXPECT_EQ(fault(vial + "[wear]\nhardness = 5"), "25 unknown-key");
  EXPECT_EQ(fault("wear = 5\n" + vial), "1 wrong-type");
}

TEST(ReadHeat, defaults) {
  EXPECT_FALSE(read_sample(vial).heat.has_value());
  const Case c = read_sample(vial + "[heat]\n");
  EXPECT_EQ(c.heat, Heat());
  for (const char* key : {"heat.ambient", "heat.milling", "heat.pause", "heat.cycles",
                          "heat.ball_exchange", "heat.share_in_balls"})
    EXPECT_TRUE(assumed(c, key)) << key;
}

TEST(ReadHeat, every_key) {
  const Heat heat = heat_of(
      "ambient = \"25 degC\"\nmilling = \"10 min\"\npause = \"5 min\"\ncycles = 12\n"
      "cooling = \"20 W/m2/K\"\nball_exchange = \"30 W/m2/K\"\nshare_in_balls = \"70 %\"");
  EXPECT_EQ(heat, (Heat{298.15, 600, 300, 12, 20, 30, 0.7}));
  EXPECT_EQ(heat_of("ambient = \"300 K\"\nmilling = \"2 h\"").milling, 7200);
}

TEST(ReadHeat, a_cycle_is_said_whole) {
  EXPECT_EQ(heat_fault("milling = \"1 h\"\npause = \"30 min\""), "24 missing-value");
  EXPECT_EQ(heat_fault("pause = \"30 min\"\ncycles = 2"), "24 missing-value");
  EXPECT_EQ(heat_fault("cycles = 2"), "24 missing-value");
  EXPECT_EQ(heat_of("milling = \"1 h\"\npause = \"30 min\"\ncycles = 1").pause, 1800);
}

TEST(ReadHeat, out_of_range) {
  EXPECT_EQ(heat_fault("ambient = \"-300 degC\""), "25 out-of-range");
  EXPECT_EQ(heat_fault("ambient = 20"), "25 bad-quantity");
  EXPECT_EQ(heat_fault("milling = \"0 s\""), "25 out-of-range");
  EXPECT_EQ(heat_fault("milling = \"1 h\"\ncycles = 2\npause = \"-1 s\""), "27 out-of-range");
  EXPECT_EQ(heat_fault("milling = \"1 h\"\ncycles = 0"), "26 out-of-range");
  EXPECT_EQ(heat_fault("milling = \"1 h\"\ncycles = 20000"), "26 out-of-range");
  EXPECT_EQ(heat_fault("cooling = \"0 W/m2/K\""), "25 out-of-range");
  EXPECT_EQ(heat_fault("ball_exchange = \"5 W/m/K\""), "25 bad-quantity");
  EXPECT_EQ(heat_fault("share_in_balls = 1.5"), "25 out-of-range");
  EXPECT_EQ(heat_fault("hours = 5"), "25 unknown-key");
}

TEST(ReadHeat, a_periodic_box_has_no_wall_to_warm) {
  const std::string box = with(with(with(vial, "kind = \"capsule", "kind = \"periodic_box\""),
                                    "diameter", "width = \"40 mm\"\ndepth = \"40 mm\""),
                               "volume", "height = \"40 mm\"");
  const std::string still =
      with(with(with(box, "kind", "kind = \"still\""), "frequency", ""), "amplitude", "");
  EXPECT_EQ(faults_of("gravity = \"0 m/s2\"\n" + still).size(), 0u);
  EXPECT_NE(fault_of("gravity = \"0 m/s2\"\n" + still + "[heat]\n").find("|periodic-box"),
            std::string::npos);
}

}  // namespace
}  // namespace mahlwerk::cases
