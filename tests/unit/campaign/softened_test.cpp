// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Quantities of runs with softened contacts.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "mahlwerk/campaign/run/run.hpp"
#include "statement.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::softened_test {
namespace {

using cases::sample::catalogue;
using tests::states;

/// A steel ball that falls on the bottom of a jar at rest and bounces.
results::Outcome bouncing(const std::string& softening) {
  const std::string text = R"(
title = "a bouncing ball"
[mill]
kind = "still"
[jar]
kind = "cylinder"
diameter = "40 mm"
height = "60 mm"
[[balls]]
diameter = "10 mm"
density = "7850 kg/m3"
positions = [["0 mm", "0 mm", "20 mm"]]
[contact]
restitution = 0.7
friction = 0.3
[run]
engine = "soft"
time = "0.4 s"
start_speed = "0 m/s"
start_spin = "0 rad/s"
replicates = 1
[heat]
)";
  RunOptions options;
  options.threads = 1;
  return run(cases::read_text(text, "case.toml", catalogue(), {{"contact.softening", softening}}),
             options);
}

double value(const results::Outcome& o, const char* name) {
  return named(o.summary.quantities, name).value;
}

TEST(SoftenedContacts, have_the_flash_temperature_of_the_given_moduli) {
  const results::Outcome hard = bouncing("1");
  for (const char* softening : {"0.12", "0.02"}) {
    const double expected = value(hard, "flash_rise_mean");
    states(std::string("flash rise at softening ") + softening + " [K]",
           value(bouncing(softening), "flash_rise_mean"), expected, 0.02 * expected,
           "hea.11; tolerance: rise ~ E_n^0.65, and a step's error of 1 % in each rebound speed");
  }
}

TEST(SoftenedContacts, are_named_with_the_factor_by_which_impacts_last_longer) {
  const auto told = [](const results::Outcome& o) {
    const auto at = std::ranges::find(o.notices, "softened-quantities", &Notice::code);
    return at == o.notices.end() ? std::string() : at->text;
  };
  EXPECT_EQ(told(bouncing("1")), "");
  const std::string text = told(bouncing("0.02"));  // 0.02^-0.4 = 4.78
  EXPECT_NE(text.find("impacts last 4.8 times longer"), std::string::npos) << text;
  EXPECT_NE(text.find("with 0.21 times the force"), std::string::npos) << text;
}

}  // namespace
}  // namespace mahlwerk::campaign::softened_test
