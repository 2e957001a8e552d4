// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Guards of the event engine: energy that appears, and time that stands still.
#include "mahlwerk/event/guard.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "statement.hpp"

namespace mahlwerk::event::guard_test {
namespace {

using tests::states;

constexpr double mass = 0.004, approach = 3, slip = 2;
constexpr double energy = 0.5 * mass * (approach * approach + slip * slip);  // 26 mJ

std::string error_of(const contact::Loss& loss) {
  try {
    reject_energy_gain(loss, mass, approach, slip, 1.5);
  } catch (const RunError& e) {
    return e.what();
  }
  return "";
}

TEST(Guard, a_collision_that_gains_more_than_rounding_is_an_error) {
  EXPECT_EQ(error_of({.normal = -0.999e-9 * energy, .tangential = 0}), "") << "rounding";
  EXPECT_NE(error_of({.normal = -1.001e-9 * energy, .tangential = 0}), "");
  EXPECT_NE(error_of({.normal = 0, .tangential = -1.001e-9 * energy}), "");
  EXPECT_EQ(error_of({.normal = 0.5 * energy, .tangential = 0.5 * energy}), "") << "loses all";
  EXPECT_NE(error_of({.normal = NAN, .tangential = 0}), "") << "not a number";
}

TEST(Guard, what_is_gained_along_the_normal_may_come_from_across_it) {
  EXPECT_EQ(error_of({.normal = -0.2 * energy, .tangential = 0.2 * energy}), "");
  EXPECT_EQ(error_of({.normal = 0.2 * energy, .tangential = -0.2 * energy}), "");
  EXPECT_NE(error_of({.normal = 0.2 * energy, .tangential = -0.3 * energy}), "");
}

TEST(Guard, the_error_names_time_gain_and_energy) {
  const std::string text = error_of({.normal = -0.01, .tangential = -0.003});
  for (const char* part : {"at 1.5 s", "gained 0.013 J", "of the 0.026 J"})
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(Guard, the_residual_of_a_collision_is_that_of_its_balance_over_its_energies) {
  scene::EnergyBalance balance;
  check_balance(balance, 1, 3, 1.5, 5.5);
  states("residual", balance.worst_collision, 0.05, 1e-15, "|1 - 3 + 1.5|/(5.5 + 3 + 1.5)");
  check_balance(balance, 1, 1, 0, 3);
  states("after a better one", balance.worst_collision, 0.05, 0, "the worst stays");
  check_balance(balance, -1, -3, 1, 2);
  states("residual", balance.worst_collision, 0.5, 1e-15, "|-1 + 3 + 1|/(2 + 3 + 1)");
  check_balance(balance, NAN, 0, 0, 1);
  EXPECT_TRUE(std::isnan(balance.worst_collision));
}

TEST(Guard, collapsed_bounces_have_the_remedy_of_their_treatment) {
  const auto text = [](SustainedContactMode mode) {
    return std::string(zeno_error(2, 1e-9, 100000, mode).what());
  };
  for (const auto mode :
       {SustainedContactMode::none, SustainedContactMode::roll, SustainedContactMode::tc})
    EXPECT_NE(text(mode).find("at 2 s 100000 events took place within 1e-09 s"), std::string::npos);
  EXPECT_NE(text(SustainedContactMode::none).find("Leave it out"), std::string::npos);
  EXPECT_NE(text(SustainedContactMode::roll).find("lasting = \"tc\""), std::string::npos);
  EXPECT_NE(text(SustainedContactMode::tc).find("wedged"), std::string::npos);
}

}  // namespace
}  // namespace mahlwerk::event::guard_test
