// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/uncertainty.hpp"

#include <gtest/gtest.h>

#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::uncertainty_test {
namespace {

using sample::catalogue;

const std::string mill = sample::vial_with_two_balls + R"([contact]
restitution = 0.9
friction = 0.3
[run]
time = "1 s"
)";
const std::string draws = R"([uncertainty]
source = "a test"
"contact.restitution" = [0.5, 0.7, "0.8"]
"mill.amplitude" = ["10 mm", "20 mm", "30 mm"]
)";

/// "what|remedy|code" of the first fault; empty without one.
std::string fault(const std::string& lines, const std::vector<Override>& set = {}) try {
  read_text(mill + lines, "case.toml", catalogue(), set);
  return "";
} catch (const InputError& error) {
  const Fault& f = error.faults().front();
  return f.where + "|" + f.what + "|" + f.remedy + "|" + f.code;
}

TEST(Uncertainty, gives_each_replicate_the_values_of_its_draw) {
  const Case c = read_text(mill + draws, "case.toml", catalogue());
  EXPECT_EQ(c.contact.rule.restitution.at(1), 0.9) << "the case itself keeps its value";
  ASSERT_EQ(c.uncertainty->count(), 3U);
  const std::vector<double> expected{0.5, 0.7, 0.8, 0.5};
  for (std::size_t k = 0; k < 4; ++k) {
    const Case drawn = case_of_replicate(c, k);
    EXPECT_EQ(drawn.contact.rule.restitution.at(1), expected[k]) << k;
    EXPECT_FALSE(drawn.uncertainty);
    const std::string amplitude = k % 3 == 0 ? "10 mm" : k == 1 ? "20 mm" : "30 mm";
    const Case plain = read_text(mill, "case.toml", catalogue(), {{"mill.amplitude", amplitude}});
    EXPECT_EQ(drawn.mill, plain.mill) << k;
  }
  EXPECT_EQ(case_of_replicate(read_text(mill, "case.toml", catalogue()), 5),
            read_text(mill, "case.toml", catalogue()));
}

TEST(Uncertainty, is_read_back_as_it_is_written) {
  const Case c = read_text(mill + draws, "case.toml", catalogue());
  EXPECT_EQ(read_text(write(c), "case.toml", catalogue()), c);
}

TEST(Uncertainty, says_what_is_wrong_with_its_draws) {
  const auto says = [](const std::string& lines, const std::string& part,
                       const std::vector<Override>& set = {}) {
    const std::string said = fault(lines, set);
    EXPECT_NE(said.find(part), std::string::npos) << lines << said;
  };
  says("[uncertainty]\n", "[uncertainty] has no key|");
  says("[uncertainty]\n\"contact.restitution\" = 0.5\n", "must be a list of at least two values|");
  says("[uncertainty]\n\"contact.restitution\" = [0.5]\n", "|bad-draws");
  says("[uncertainty]\n\"contact.restitution\" = [0.5, 0.6]\n\"contact.friction\" = [1, 2, 3]\n",
       "\"contact.friction\" has 3 values, \"contact.restitution\" has 2|");
  says("[uncertainty]\n\"balls.1.count\" = [1, 2]\n",
       "takes keys of [contact] and [mill]|bad-draws");
  says("[uncertainty]\n\"contact.restitution\" = [0.5, 1.6]\n",
       "[uncertainty] contact.restitution");
  says("[uncertainty]\n\"contact.restitutoin\" = [0.5, 0.6]\n", "did you mean");
  says(draws, "|drawn-value", {{"contact.restitution", "0.5"}});
  says(draws + "[sweep]\n\"mill.amplitude\" = [\"1 mm\", \"2 mm\"]\n", "|drawn-value");
  EXPECT_EQ(fault(draws), "");
}

}  // namespace
}  // namespace mahlwerk::cases::uncertainty_test
