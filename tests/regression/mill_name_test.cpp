// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A mill by its name alone, and what the ranges of the catalogue move.
#include <array>
#include <cmath>

#include "mahlwerk/results/files/json_value.hpp"
#include "program.hpp"

namespace mahlwerk::tests::mill_name_test {
namespace {

using results::Json;

class MillName : public ProgramTest {
 protected:
  Json summary(const std::string& folder) const {
    return Json::parse(text(folder + "/summary.json"));
  }
};

double value(const Json& summary, const std::string& quantity, const char* what = "value") {
  return std::get<double>(summary.find(quantity)->find(what)->value());
}

/// Difference of the power at the ends of a key's range.
double span(const Json& key) {
  const auto& ends = std::get<Json::Array>(key.find("at_ends")->find("dissipated_power")->value());
  return std::abs(std::get<double>(ends[1].value()) - std::get<double>(ends[0].value()));
}

TEST_F(MillName, alone_runs_and_carries_the_band_of_its_ranges_with_the_largest_cause_first) {
  const ProgramResult told = mahlwerk("run 'MM 400' --set run.time='0.3 s'");
  ASSERT_EQ(told.code, 0) << told.output;
  EXPECT_NE(told.output.find("Only the mill is given"), std::string::npos) << told.output;
  const Json found = summary("results/retsch-mm400");
  const auto& keys = std::get<Json::Array>(found.find("_sensitivity")->find("keys")->value());
  std::string names;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    names += std::get<std::string>(keys[i].find("key")->value()) + " ";
    if (i == 0) continue;
    EXPECT_LE(span(keys[i]), span(keys[i - 1])) << names;
  }
  for (const char* range : {"mill.swing", "mill.arm", "jar.diameter", "contact.restitution"})
    EXPECT_NE(names.find(range), std::string::npos) << names;
}

TEST_F(MillName, that_several_mills_have_is_asked_for) {
  const ProgramResult told = mahlwerk("run 'no such mill'");
  EXPECT_NE(told.code, 0);
  EXPECT_NE(told.output.find("there is no such file or folder"), std::string::npos);
}

/// Two steel balls in the 25 ml jar of a mixer mill: the range of the jar's proportions, with the
/// volume kept, moves the power by a third and the energy of hits by two fifths, but hits by less.
TEST_F(MillName, has_a_jar_whose_range_moves_power_and_energy_of_hits_by_a_fifth_and_more) {
  const std::string words =
      "estimate 'MM 400' --jar 25ml --material 1.4034 --balls 2x10mm --frequency 25Hz --save "
      "a.toml "
      "--quiet";
  ASSERT_EQ(mahlwerk(words).code, 0);
  std::array<Json, 3> at;
  const std::array diameters{"24.1 mm", "26.7 mm", "29.3 mm"};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string folder = "out" + std::to_string(i);
    ASSERT_EQ(mahlwerk("run a.toml --quiet --set run.sensitivity=off --set run.replicates=8 --set "
                       "run.time='4 s' --out " +
                       folder + " --set jar.diameter='" + diameters[i] + "'")
                  .code,
              0);
    at[i] = summary(folder);
  }
  for (const char* quantity :
       {"dissipated_power", "collision_rate_above_threshold", "energy_normal_mean_above_threshold"})
    std::printf("    %-36s %+4.0f %% at %s, %+4.0f %% at %s\n", quantity,
                100 * (value(at[0], quantity) / value(at[1], quantity) - 1), diameters[0],
                100 * (value(at[2], quantity) / value(at[1], quantity) - 1), diameters[2]);
  const auto change = [&](const char* quantity, std::size_t end) {
    return std::abs(value(at[end], quantity) / value(at[1], quantity) - 1);
  };
  // 16 replicates of 6 s had -21 and -28 %, -26 and +12 %, 0 and -41 %.
  EXPECT_GT(change("dissipated_power", 0), 0.1);
  EXPECT_GT(change("dissipated_power", 2), 0.15);
  EXPECT_GT(change("energy_normal_mean_above_threshold", 2), 0.25);
  EXPECT_LT(change("collision_rate_above_threshold", 2), 0.3);
}

}  // namespace
}  // namespace mahlwerk::tests::mill_name_test
