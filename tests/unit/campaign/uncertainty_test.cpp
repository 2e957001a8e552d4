// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Runs of a case with [uncertainty].
#include "mahlwerk/cases/uncertainty.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "statement.hpp"
#include "unit/campaign/runs.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::uncertainty_test {
namespace {

using cases::sample::catalogue;
using tests::states;

/// Seven balls in a vibration mill, in the engine `engine`.
std::string mill(const std::string& engine) {
  return R"(
title = "seven balls"
seed = 3
[mill]
kind = "vibration"
frequency = "20 Hz"
amplitude = "8 mm"
[jar]
kind = "cylinder"
diameter = "40 mm"
height = "40 mm"
youngs_modulus = "1 GPa"
[[balls]]
count = 7
diameter = "10 mm"
density = "7850 kg/m3"
youngs_modulus = "1 GPa"
[contact]
restitution = 0.9
friction = 0.3
[run]
time = "0.2 s"
replicates = 4
engine = ")" +
         engine + "\"\n";
}

const std::string draws = R"([uncertainty]
"contact.restitution" = ["0.4", "0.6", "0.8"]
"mill.amplitude" = ["6 mm", "8 mm", "10 mm"]
)";

TEST(Uncertainty, a_replicate_has_the_bits_of_a_run_with_the_values_of_its_draw) {
  for (const std::string engine : {"event", "soft"}) {
    const cases::Case c = cases::read_text(mill(engine) + draws, "case.toml", catalogue());
    const std::vector<double> drawn = powers(run(c, on(1)));
    EXPECT_EQ(drawn, powers(run(c, on(2)))) << engine;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::vector<std::string> e{"0.4", "0.6", "0.8"}, a{"6 mm", "8 mm", "10 mm"};
      const cases::Case plain =
          cases::read_text(mill(engine), "case.toml", catalogue(),
                           {{"contact.restitution", e[k % 3]}, {"mill.amplitude", a[k % 3]}});
      EXPECT_EQ(drawn[k], powers(run(plain, on(1)))[k]) << engine << ", replicate " << k;
    }
  }
}

TEST(Uncertainty, an_interval_is_that_of_one_more_draw) {
  const cases::Case c = cases::read_text(mill("event") + draws, "case.toml", catalogue());
  const results::Outcome outcome = run(c, on(1));
  const observe::Estimate e = observe::estimate(powers(outcome));
  const results::Quantity& q = results::named(outcome.summary.quantities, "dissipated_power");
  states("half-width [W]", q.ci95, e.ci95 * std::sqrt(4 + 1.0), 1e-12, "cal.9");
  EXPECT_TRUE(std::isnan(q.ci95_time)) << "it knows nothing of the draws";
  EXPECT_FALSE(outcome.summary.two_states);
  const auto has = [&](const std::string& code) {
    return std::ranges::find(outcome.notices, code, &Notice::code) != outcome.notices.end();
  };
  EXPECT_TRUE(has("uncertain-parameters"));
  EXPECT_TRUE(has("few-draws"));
}

}  // namespace
}  // namespace mahlwerk::campaign::uncertainty_test
