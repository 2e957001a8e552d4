// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Keys of a case for wear and heat: hardness, conductivity, [wear], [heat].
#include "mahlwerk/cases/wear_heat.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/wear.hpp"
#include "statement.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::wear_heat_test {
namespace {

using namespace sample;
using cases::Wear;
using tests::states;

/// The only fault as "line code"; all faults if their number is not one.
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
  return *read_sample(vial + "[wear]\n" + lines).parts.find<Wear>();
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
  EXPECT_EQ(read_sample(planetary).jar.density, 7700);  // from its material, steel
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
  EXPECT_EQ(read_sample(vial).parts.find<Wear>(), nullptr);
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
  for (const char* key :
       {"heat.ambient", "heat.milling", "heat.pause", "heat.cycles", "heat.ball_exchange"})
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
  const std::string box = with(with(with(vial, "kind = \"capsule", "kind = \"periodic-box\""),
                                    "diameter", "width = \"40 mm\"\ndepth = \"40 mm\""),
                               "volume", "height = \"40 mm\"");
  const std::string still =
      with(with(with(box, "kind", "kind = \"still\""), "frequency", ""), "amplitude", "");
  EXPECT_EQ(faults_of("gravity = \"0 m/s2\"\n" + still).size(), 0u);
  EXPECT_NE(fault_of("gravity = \"0 m/s2\"\n" + still + "[heat]\n").find("|periodic-box"),
            std::string::npos);
}

TEST(WearHeat, balls_and_jar_of_a_case_as_lumps) {
  const Case c = read_sample(planetary + "[heat]\nball_exchange = \"40 W/m2/K\"\n");
  constexpr double area = 0.01, pi = std::numbers::pi;
  const powder::HeatNodes n = heat_nodes(c, area);
  const double ball = 7700 * pi / 6 * 15e-3 * 15e-3 * 15e-3;
  states("balls [J/K]", n.balls_capacity, 5 * ball * 460, 1e-12, "five of 15 mm, 460 J/(kg K)");
  states("jar [J/K]", n.jar_capacity, area * 5e-3 * 7700 * 460, 1e-12, "5 mm of 7700 kg/m3");
  states("between them [W/K]", n.exchange, 40 * 5 * pi * 15e-3 * 15e-3, 1e-15,
         "by the balls' surface");
  states("to the air [W/K]", n.cooling, 15 * area, 1e-15, "by the jar's wall");
  const powder::MillCycles mill = mill_cycles(c, 8, 0.5);
  states("into the balls [W]", mill.heating().balls, 4, 1e-15, "half of 8 W");
  states("in all [W]", mill.heating().balls + mill.heating().jar, 8, 1e-15, "8 W");
}

TEST(WearHeat, sizes_that_differ_count_each_with_its_surface) {
  const std::string sizes =
      "distribution = \"uniform\"\nsmallest = \"5 mm\"\nlargest = \"15 mm\"\n";
  const Case c = read_sample(with(with(with(vial, "diameter = \"8", sizes), "count", "count = 40"),
                                  "diameter = \"12", "diameter = \"60 mm\"") +
                                 "[heat]\n",
                             {{"jar.volume", "900 ml"}});
  double area = 0, mass = 0;
  for (const SizeClass& size : c.balls[0].sizes()) {
    const double d = size.diameter, n = static_cast<double>(size.count);
    area += n * std::numbers::pi * d * d;
    mass += n * std::numbers::pi / 6 * d * d * d * 7850;
  }
  EXPECT_GT(c.balls[0].sizes().size(), 3u);
  states("surface [m2]", balls_surface(c), area, 1e-15, "sum over the classes");
  states("capacity [J/K]", heat_nodes(c, 1).balls_capacity, 460 * mass, 1e-10, "sum over them");
}

TEST(WearHeat, grains_are_no_balls) {
  const std::string grains = "size = \"1 mm\"\nas = \"grains\"";
  const std::string heat = "[heat]\n";
  EXPECT_EQ(balls_surface(read_sample(with(planetary, "size", grains) + heat)),
            balls_surface(read_sample(planetary + heat)));
}

TEST(WearHeat, who_meets_in_a_flash) {
  const Case c = read_sample(with(planetary, "restitution", "softening = 0.01"));
  const powder::FlashPair two = flash_pair(c, 0, 0), wall = flash_pair_with_jar(c, 0);
  states("radius of two balls over one's", two.radius / 7.5e-3, 0.5, 1e-15, "1/R* = 1/R + 1/R");
  states("at the wall", wall.radius / 7.5e-3, 1, 1e-15, "flat");
  states("mass of two balls over that at the wall", two.mass / wall.mass, 0.5, 1e-15, "1/m* = 2/m");
  states("modulus [Pa]", two.modulus, 100e9 / (1 - 0.265 * 0.265), 1e-4, "not softened");
  states("effusivity", wall.other_effusivity, std::sqrt(30.0 * 7700 * 460), 1e-11, "hea.10");
}

TEST(WearHeat, bounces_without_a_limit_slide_like_lasting_contacts) {
  const Case c = read_sample(vial);
  EXPECT_EQ(sliding_friction(c, c.contact.rule), 0.3);
  const Case coulomb = read_sample(planetary);
  EXPECT_EQ(sliding_friction(coulomb, coulomb.contact.rule), 0.5);
}

}  // namespace
}  // namespace mahlwerk::cases::wear_heat_test
