// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Values that are valid and probably a mistake get a warning.
#include <gtest/gtest.h>

#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/keys.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::unusual_values_test {
namespace {

using namespace sample;

const std::string powder = "[powder]\nmass = \"10 mg\"\ndensity = \"2 g/cm3\"\n";

/// The texts of the warnings "unusual-value" of a case.
std::vector<std::string> remarks(const std::string& text, const std::string& key = {},
                                 const std::string& value = {}) {
  std::vector<Override> set;
  if (!key.empty()) set.push_back({key, value});
  std::vector<std::string> found;
  for (const Notice& one : unusual_values(read_sample(text, set)))
    if (one.code == "unusual-value") found.push_back(one.text);
  return found;
}

/// Nothing is said at `fine`; at `odd` there is one warning, which begins with the key.
void tells(const std::string& text, const std::string& key, const std::string& fine,
           const std::string& odd) {
  EXPECT_TRUE(remarks(text, key, fine).empty()) << key << " = " << fine;
  const std::vector<std::string> found = remarks(text, key, odd);
  ASSERT_EQ(found.size(), 1U) << key << " = " << odd;
  EXPECT_TRUE(found.front().starts_with(key)) << found.front();
}

TEST(UnusualValues, are_told_beyond_the_plausible_magnitude_of_their_key_and_not_at_it) {
  tells(vial, "contact.friction", "3", "3.001");
  tells(vial, "mill.frequency", "200 Hz", "201 Hz");
  tells(vial, "mill.amplitude", "0.5 m", "7 m");
  tells(vial, "jar.height", "20 m", "21 m");
  tells(vial, "balls.1.density", "500 kg/m3", "7.85 kg/m3");
  tells(vial + powder, "powder.density", "25000 kg/m3", "4 kg/m3");
  EXPECT_TRUE(remarks(vial, "mill.amplitude", "0 mm").empty()) << "0 is no wrong unit";
}

TEST(UnusualValues, powder_larger_than_the_balls_and_thick_films_are_told) {
  const std::string film = "[liquid]\nkind = \"film\"\nfilm = \"10 um\"\nviscosity = \"2 mPa s\"\n";
  tells(vial + powder, "powder.size", "1 mm", "40 mm");
  tells(vial + film, "liquid.film", "0.3 mm", "0.9 mm");
  EXPECT_EQ(remarks(vial + film, "liquid.film", "50 mm").size(), 2U)
      << "implausible, and too thick";
}

TEST(UnusualValues,
     a_solid_filling_that_was_probably_meant_as_bulk_is_told_and_a_bulk_filling_not) {
  const auto told = [](const std::string& filling, const std::string& mill) {
    const std::string text = mill +
                             "[jar]\nkind = \"cylinder\"\ndiameter = \"20 cm\"\nheight = "
                             "\"10 cm\"\n[[balls]]\ndiameter = \"8 mm\"\n"
                             "density = \"7850 kg/m3\"\n" +
                             filling + "[run]\ntime = \"1 s\"\n";
    std::vector<std::string> found;
    for (const Notice& one : unusual_values(read_sample(text)))
      if (one.code == "solid-filling") found.push_back(one.text);
    return found;
  };
  const std::string drum = "[mill]\nkind = \"tumbling\"\nspeed = \"75 %\"\n";
  const std::vector<std::string> found = told("filling = \"30 %\"\n", drum);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found.front().starts_with("[[balls.1]]: filling = \"30 %\"")) << found.front();
  EXPECT_NE(found.front().find("fill 50 % of the drum"), std::string::npos) << found.front();
  EXPECT_TRUE(told("filling = \"26 %\"\n", drum).empty()) << "J = 43 %";
  EXPECT_TRUE(told("bulk_filling = \"50 %\"\n", drum).empty());
  EXPECT_TRUE(told("filling = \"30 %\"\n",
                   "[mill]\nkind = \"planetary\"\norbit_radius = "
                   "\"20 cm\"\nspeed = \"300 rpm\"\nratio = -2\n")
                  .empty())
      << "no drum";
}

TEST(UnusualValues, powder_of_unknown_density_is_told_where_no_solid_is_dense_enough) {
  const auto told = [](const std::string& mass) {
    std::size_t found = 0;
    for (const Notice& one :
         jar_warnings(read_sample(vial + "[powder]\n", {{"powder.mass", mass}})))
      found += one.code == "too-much-powder";
    return found;
  };
  EXPECT_EQ(told("10 g"), 0U);
  EXPECT_EQ(told("100 g"), 1U) << "kg for g: the vial holds 5 ml, and 13.6 g/cm3 of loose osmium";
}

TEST(UnusualValues, plausible_magnitudes_hold_defaults_and_usual_values) {
  int declared = 0;
  for (const KeyInfo& key : all_keys()) {
    if (key.type != "number") continue;
    const auto [least, most] = key.plausible;
    declared += std::isfinite(most) ? 1 : 0;
    EXPECT_LT(least, most) << key.key;
    for (const std::string& text : {key.default_value, key.start, std::string(key.usual.least),
                                    std::string(key.usual.most)}) {
      if (text.empty()) continue;
      double value = 0;
      try {
        value = std::abs(parse_in(text, key.unit));
      } catch (const UnitError&) {
        continue;  // "70 %" of a critical speed, "1:-2"
      }
      EXPECT_TRUE(value == 0 || (value >= least && value <= most)) << key.key << " = " << text;
    }
  }
  EXPECT_GT(declared, 100) << "lengths, masses, speeds, moduli and so on";
}

}  // namespace
}  // namespace mahlwerk::cases::unusual_values_test
