// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/reference/estimate_case.hpp"

#include <gtest/gtest.h>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/read.hpp"

namespace mahlwerk::commands::estimate_case_test {
namespace {

cases::Case made(const EstimateWords& words) {
  const cases::Catalogue catalogue(std::string(MAHLWERK_HOME) + "/catalogue");
  return cases::read_text(estimate_case(words, catalogue, "1 s"), "estimate", catalogue);
}
EstimateWords planetary(std::vector<std::string> balls) {
  return {.mill = "PM 100",
          .jar = "50ml",
          .material = "zro2",
          .balls = std::move(balls),
          .speed = "300 rpm"};
}

TEST(EstimateCase, has_balls_by_number_mass_filling_and_name) {
  EXPECT_EQ(made(planetary({"2x10mm"})).balls.front().count, 2);
  EXPECT_EQ(made(planetary({"02 \u00d7 10 mm"})).balls.front().count, 2);
  EXPECT_EQ(made(planetary({" 3 x 0.5 cm "})).balls.front().diameter, 0.005);
  // 20 g of balls of 10 mm and 6000 kg/m3, 3.14 g each
  EXPECT_EQ(made(planetary({"20 g x 10 mm"})).balls.front().count, 6);
  // A tenth of 50 ml in bulk holds 3 ml of solid, at 60 %: 5.7 balls of 0.52 ml
  EXPECT_EQ(made(planetary({"10 % x 10mm"})).balls.front().count, 6);
  EXPECT_EQ(made(planetary({"50ml-10x10mm"})).balls.front().count, 10);
  const cases::Case two = made(planetary({"2x10mm", "3x5mm"}));
  ASSERT_EQ(two.balls.size(), 2U);
  EXPECT_EQ(two.balls[1].count, 3);
}

TEST(EstimateCase, has_the_jar_of_the_mill_by_volume_or_name) {
  EstimateWords words = planetary({"2x10mm"});
  const auto volume = [&](const std::string& jar) {
    words.jar = jar;
    return estimate_case(words, cases::Catalogue(std::string(MAHLWERK_HOME) + "/catalogue"), "1 s");
  };
  for (const char* same : {"50ml", "50 ml", "0.05 l", "retsch-pm-50ml"})
    EXPECT_NE(volume(same).find("model = \"retsch-pm-50ml\""), std::string::npos) << same;
  EXPECT_NE(volume("retsch-mm-25ml").find("retsch-mm-25ml"), std::string::npos)
      << "a jar of another mill, by its name";
  for (const char* none : {"51ml", "5.0 ml", "-50ml", "50 mm"})
    EXPECT_THROW(volume(none), InputError) << none;
}

TEST(EstimateCase, has_powder_by_mass_or_ratio_and_a_milling_time) {
  EstimateWords words = planetary({"10x10mm"});
  words.powder = "2 g";
  words.time = "2 h";
  EXPECT_EQ(made(words).powder->mass, 0.002);
  EXPECT_EQ(made(words).milling->time, 7200);
  words.powder = "10 : 1";
  const double balls = 10 * 6000 * 5.235987755982988e-7;  // kg
  EXPECT_NEAR(made(words).powder->mass, balls / 10, 1e-12);
  for (const char* wrong : {"10:0", "a:1", "10:1:2", ":", "-1:2"}) {
    words.powder = wrong;
    EXPECT_THROW(made(words), InputError) << wrong;
  }
}

TEST(EstimateCase, writes_words_as_toml_whatever_they_hold) {
  EstimateWords words = planetary({"2x10mm"});
  words.material = "a \" b \\ \n c";
  try {
    made(words);
    FAIL() << "no such material";
  } catch (const InputError& e) {
    EXPECT_EQ(e.faults().front().code, "unknown-name") << "and no fault of TOML";
  }
}

}  // namespace
}  // namespace mahlwerk::commands::estimate_case_test
