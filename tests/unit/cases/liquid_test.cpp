// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The section [liquid] of a case.
#include <gtest/gtest.h>

#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/read.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::liquid_test {
namespace {

using namespace sample;

const std::string film = "[liquid]\nkind = \"film\"\nfilm = \"10 um\"\n";
const std::string flooded = "[liquid]\nkind = \"flooded\"\n";

std::string code_of(const std::string& liquid) {
  const auto found = faults_of(vial + liquid);
  return found.size() == 1 ? found[0].code : fault_of(vial + liquid);
}
std::vector<Fault> engine_faults_of(const std::string& liquid, const std::string& engine) {
  return engine_faults(read_sample(vial + liquid, {{"run.engine", engine}}));
}

TEST(ReadLiquid, films_and_jars_full_of_it) {
  EXPECT_FALSE(read_sample(vial).liquid.has_value());
  const Case wet = read_sample(vial + film + "viscosity = \"2 mPa s\"\n");
  contact::Liquid expected;
  expected.viscosity = 2e-3;
  expected.film = 10e-6;
  EXPECT_EQ(wet.liquid, (Liquid{"", expected}));
  EXPECT_EQ(source_of(wet, "liquid.roughness"), "default: a worn ball; uncalibrated, 0.1-10 um");
  const Case full = read_sample(vial + flooded +
                                "material = \"oil\"\nreach = 0.5\ndrag = false\n"
                                "rebound = \"resists\"\nroughness = \"3 um\"\n");
  expected = {};
  expected.viscosity = 0.08;
  expected.density = 870;
  expected.flooded = expected.resists_rebound = true;
  expected.drag = false;
  expected.reach = 0.5;
  expected.roughness = 3e-6;
  EXPECT_EQ(full.liquid, (Liquid{"oil", expected}));
  EXPECT_EQ(source_of(full, "liquid.viscosity"), "catalogue materials/oil: test sheet");
}

TEST(ReadLiquid, says_what_is_missing_out_of_range_or_without_meaning) {
  EXPECT_EQ(code_of("[liquid]\nviscosity = \"1 mPa s\"\n"), "missing-value");
  EXPECT_EQ(code_of("[liquid]\nkind = \"foam\"\n"), "unknown-word");
  EXPECT_EQ(code_of(film), "missing-value");
  EXPECT_EQ(code_of(film + "material = \"steel\"\n"), "missing-value");  // which is no liquid
  EXPECT_EQ(code_of(film + "viscosity = 0\n"), "bad-quantity");
  EXPECT_EQ(code_of(film + "viscosity = \"-1 mPa s\"\n"), "out-of-range");
  EXPECT_EQ(code_of(film + "material = \"oil\"\nreach = 0.5\n"), "too-much");
  EXPECT_EQ(code_of(film + "material = \"oil\"\ndensity = \"1 g/cm3\"\n"), "too-much");
  EXPECT_EQ(code_of(flooded + "material = \"oil\"\nfilm = \"1 um\"\n"), "too-much");
  EXPECT_EQ(code_of(flooded + "viscosity = \"1 mPa s\"\n"), "missing-value");  // the density
  EXPECT_EQ(code_of(film + "material = \"oil\"\nroughness = \"20 um\"\n"), "thin-film");
  EXPECT_EQ(code_of(film + "material = \"oil\"\nroughness = \"19.9 um\"\n"), "");
}

TEST(EngineFaults, the_event_engine_takes_films_that_cavitate) {
  const std::string oil = "material = \"oil\"\n";
  for (const std::string engine : {"event", "soft", "auto"})
    EXPECT_TRUE(engine_faults_of(film + oil, engine).empty()) << engine;
  for (const std::string& liquid : {flooded + oil, film + oil + "rebound = \"resists\"\n"}) {
    ASSERT_EQ(engine_faults_of(liquid, "event").size(), 1U);
    EXPECT_EQ(engine_faults_of(liquid, "event")[0].code, "liquid-needs-soft");
    EXPECT_TRUE(engine_faults_of(liquid, "soft").empty());
    EXPECT_TRUE(liquid_needs_soft(read_sample(vial + liquid)));
  }
}

}  // namespace
}  // namespace mahlwerk::cases::liquid_test
