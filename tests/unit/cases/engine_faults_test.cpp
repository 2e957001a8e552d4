// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/read.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::engine_faults_test {
namespace {

using namespace sample;

TEST(EngineFaults, what_an_engine_does_not_carry_can_still_be_read) {
  EXPECT_TRUE(engine_faults(read_sample(planetary)).empty());  // soft
  EXPECT_TRUE(engine_faults(read_sample(planetary, {{"contact.lasting", "roll"}})).empty());
  for (const std::string engine : {"event", "auto"}) {
    EXPECT_TRUE(engine_faults(read_sample(planetary, {{"run.engine", engine}})).empty());
    const auto many = engine_faults(
        read_sample(with(planetary, "friction", "lasting = \"roll\""), {{"run.engine", engine}}));
    ASSERT_EQ(many.size(), 1U);
    EXPECT_EQ(many[0].where, "case.toml:16");
    EXPECT_EQ(many[0].what, "lasting = \"roll\" is for one ball, the case has 5");
    EXPECT_EQ(many[0].code, "roll-one-ball");
  }
  EXPECT_TRUE(engine_faults(read_sample(vial, {{"run.engine", "auto"}})).empty());
  const auto viscous = engine_faults(read_sample(
      with(vial, "restitution", "rolling = \"viscous\"\nrolling_friction = \"1 s/m\"")));
  ASSERT_EQ(viscous.size(), 1U);
  EXPECT_EQ(viscous[0].where, "case.toml:17");
  EXPECT_EQ(viscous[0].code, "viscous-rolling");
  const auto own_spin =
      engine_faults(read_sample(with(vial, "restitution", "rolling = \"own-spin\"")));
  ASSERT_EQ(own_spin.size(), 1U);
  EXPECT_EQ(own_spin[0].code, "own-spin-rolling");
}

TEST(EngineFaults, the_soft_engine_has_one_restitution_for_all_speeds) {
  const auto places = [](const std::string& contact) {
    std::vector<std::string> found;
    for (const Fault& f : engine_faults(read_sample(with(planetary, "restitution", contact)))) {
      EXPECT_EQ(f.code, "constant-restitution");
      found.push_back(f.where);
    }
    return found;
  };
  using Places = std::vector<std::string>;
  const std::string table = "restitution_table = [[\"1 m/s\", 0.5]]";
  const std::string pair = "\npairs = [{between = [\"balls\", \"jar\"], ";
  EXPECT_EQ(places("restitution = 0"), Places{});
  EXPECT_EQ(places("restitution_law = \"viscoelastic\"\nrestitution_speed = \"1 m/s\""),
            Places{"case.toml:15"});
  EXPECT_EQ(places(table), Places{"contact.restitution_law"});  // it follows from the table
  EXPECT_EQ(places(table + pair + "friction = 0.1}]"), Places{"contact.restitution_law"});
  EXPECT_EQ(places("restitution = 0.5" + pair + table + "}]"),
            Places{"contact.pairs.1.restitution_law"});
}

}  // namespace
}  // namespace mahlwerk::cases::engine_faults_test
