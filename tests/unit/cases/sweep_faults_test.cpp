// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "mahlwerk/cases/read.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::sweep_faults_test {
namespace {

using namespace sample;

TEST(SweepFaults, of_a_sweep_come_together_and_have_no_others_in_their_wake) {
  const std::string swept = with(vial, "frequency", "") +
                            "[sweep]\ndesign = \"grit\"\nsamples = 0\n"
                            "\"mill.frequency\" = { from = \"3 Hz\", steps = 4 }\n"
                            "\"mill.amplitude\" = [\"1 mm\", \"\"]\n"
                            "together = [[\"mill.frequency\", \"mill.nothing\"]]\n";
  std::vector<std::string> places;
  for (const Fault& fault : faults_of(swept)) places.push_back(fault.where + " " + fault.code);
  EXPECT_EQ(places,
            (std::vector<std::string>{"case.toml:25 unknown-word", "case.toml:26 out-of-range",
                                      "case.toml:27 bad-range", "case.toml:28 wrong-type",
                                      "case.toml:29 bad-together"}));
}

TEST(SweepFaults, of_a_design_that_cannot_use_a_value) {
  const auto swept = [](const std::string& lines) { return vial + "[sweep]\n" + lines; };
  EXPECT_TRUE(only(swept("desing = \"sobol\"\n\"mill.frequency\" = [\"3 Hz\"]\n"), "case.toml:25",
                   "did you mean `design`?", "unknown-key"));
  EXPECT_TRUE(only(swept("design = \"sobol\"\nsamples = 4\n\"mill.frequency\" = { from = \"3 Hz\", "
                         "to = \"5 Hz\", steps = 5 }\n"),
                   "case.toml:27", "steps has no meaning", "too-much"));
  EXPECT_TRUE(only(swept("design = \"sobol\"\nsamples = 2.5\n\"mill.frequency\" = { from = \"3 "
                         "Hz\", to = \"5 Hz\" }\n"),
                   "case.toml:26", "whole number", "out-of-range"));
}

}  // namespace
}  // namespace mahlwerk::cases::sweep_faults_test
