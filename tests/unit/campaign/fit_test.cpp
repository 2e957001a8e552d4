// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/fit/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"
#include "statement.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::fit_test {
namespace {

using cases::sample::catalogue;
using tests::states;

/// A vial with one ball and grains that break, and another with a reaction.
const std::string mill = R"(
title = "vial"
seed = 1
[mill]
kind = "vibration"
frequency = "19 Hz"
amplitude = "25 mm"
[jar]
kind = "capsule"
diameter = "12 mm"
volume = "5 ml"
[[balls]]
count = 1
diameter = "8 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.9
friction = 0.3
[run]
time = "1 s"
replicates = 1
[powder]
mass = "0.15 g"
density = "1280 kg/m3"
size = "1.3 mm"
)";
const std::string grinding = R"([capture]
model = "trapped-volume"
thickness = "1.3 mm"
[breakage]
model = "vogel-peukert"
f_mat = "0.3 kg/J/m"
x_w_min = "0.01 J m/kg"
[fragments]
model = "binary"
[grinding]
time = "20 s"
[fit]
"breakage.f_mat" = ["0.01 kg/J/m", "100 kg/J/m"]
"breakage.x_w_min" = ["0 J m/kg", "1 J m/kg"]
)";
const std::string kinetics = R"([kinetics]
time = "600 s"
dose_constant = "1 kJ/g"
[fit]
"kinetics.dose_constant" = ["0.05 kJ/g", "50 kJ/g"]
)";

cases::Case read(const std::string& text, const std::vector<cases::Override>& set = {}) {
  return cases::read_text(text, "case.toml", catalogue(), set);
}
Measurements data(const std::string& text) {
  return read_measurements_text(text, "data.csv");
}

TEST(Fit, looks_for_what_the_case_leaves_open_and_nobody_holds) {
  const cases::Case mill_case = read(mill + grinding);
  const std::vector<FreeParameter> both = free_parameters(mill_case);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0].name, "breakage.f_mat");
  EXPECT_EQ(both[0].least, 0.01);
  EXPECT_EQ(both[0].most, 100);
  EXPECT_FALSE(both[0].min_is_natural);
  EXPECT_TRUE(both[1].min_is_natural) << "no energy is below 0";
  EXPECT_FALSE(both[1].max_is_natural);
  const std::vector<FreeParameter> one = free_parameters(mill_case, {"breakage.f_mat"});
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].name, "breakage.x_w_min");
}

TEST(Fit, needs_a_case_that_tells_what_was_measured_and_leaves_something_open) {
  const auto fault = [](const std::string& text, const std::string& table,
                        const std::vector<std::string>& held = {}) {
    const cases::Case mill_case = read(text);
    const auto found =
        fit_faults(mill_case, data(table), free_parameters(mill_case, held), "data.csv");
    return found.empty() ? "" : found[0].where + "|" + found[0].what + "|" + found[0].code;
  };
  EXPECT_EQ(fault(mill + grinding, "D90 (um)\n900\n"), "");
  EXPECT_EQ(fault(mill + kinetics, "conversion\n0.5\n"), "");
  EXPECT_EQ(fault(mill + kinetics, "conversion\n0.5\n", {"kinetics.dose_constant"}),
            "case.toml|the case has no free parameter|nothing-to-fit");
  EXPECT_EQ(fault(mill + kinetics, "D90 (um)\n900\n"),
            "data.csv:2|D90 was measured, but the case has no [grinding]|nothing-to-fit");
  EXPECT_EQ(fault(mill + grinding, "conversion\n0.5\n"),
            "data.csv:2|conversion was measured, but the case has no [kinetics]|nothing-to-fit");
  EXPECT_EQ(fault(mill + grinding, "breakage.f_mat,D90 (um)\n,900\n1 kg/J/m,800\n"),
            "data.csv|the column breakage.f_mat sets a parameter of [fit]|nothing-to-fit");
}

TEST(Fit, residuals_are_relative_for_sizes_and_differences_for_shares) {
  Measurement size{.what = MeasuredQuantity::quantile, .value = 200e-6};
  EXPECT_DOUBLE_EQ(residual(size, 220e-6), std::log(1.1));
  size.error = 10e-6;
  EXPECT_DOUBLE_EQ(residual(size, 220e-6), 20 * std::log(1.1));
  size.what = MeasuredQuantity::specific_surface;
  EXPECT_DOUBLE_EQ(residual(size, 220e-6), 20 * std::log(1.1));
  Measurement share{.what = MeasuredQuantity::passing, .value = 0.5};
  EXPECT_NEAR(residual(share, 0.53), 0.03, 1e-15);
  share.error = 0.01;
  EXPECT_NEAR(residual(share, 0.53), 3, 1e-13);
  share.what = MeasuredQuantity::conversion;
  EXPECT_NEAR(residual(share, 0.53), 3, 1e-13);
  EXPECT_TRUE(std::isnan(residual(size, std::nan(""))));
}

TEST(Fit, mills_as_long_as_was_measured_under_each_condition) {
  const cases::Case mill_case =
      read(mill + grinding, {{"grinding.method", "both"}, {"observe.frames", "10 ms"}});
  Measurements all =
      data("mill.frequency (Hz),time (s),D90 (um)\n16,5,900\n16,30,700\n22,,600\n22,7,800\n");
  fill_times(all, {mill_case, mill_case});
  EXPECT_EQ(all.values[2].time, 20) << "as the case says";
  const std::vector<FreeParameter> numbers = free_parameters(mill_case);
  const cases::Case first = case_for_fit(mill_case, 0, all, numbers),
                    second = case_for_fit(mill_case, 1, all, numbers);
  EXPECT_EQ(first.grinding->time, 30);
  EXPECT_EQ(second.grinding->time, 20);
  EXPECT_EQ(first.grinding->method, cases::Grinding::Method::balance);
  EXPECT_FALSE(first.observe.frames);
  EXPECT_NEAR(cases::fit_parameter_value(first, "breakage.f_mat"), 1, 1e-12)
      << "middle of the logarithm";
}

/// Predictions of all measurable quantities by a run with these overrides.
std::vector<double> run_says(const std::vector<cases::Override>& set) {
  const results::Outcome outcome = run(read(mill + grinding, set));
  std::vector<double> predicted;
  for (const char* name : {"d10", "d50", "d90", "specific_surface"})
    for (const results::Quantity& q : results::summarise(outcome).quantities)
      if (q.name == name) predicted.push_back(q.value);
  const powder::SizeEvolution& milling = outcome.replicates[0].grinding->milling();
  predicted.push_back(powder::undersize(milling.grid, milling.shares.back(), 400e-6));
  return predicted;
}

TEST(Fit, predicts_what_a_run_with_these_numbers_says) {
  const Measurements asked = data(
      "time (s),D10 (um),D50 (um),D90 (um),specific_surface (m2/kg),size (um),passing\n"
      "20,100,500,900,10,400,0.5\n");
  const std::vector<results::Outcome> mills{run(read(mill + grinding))};
  const Predictor predict(mills, free_parameters(mills[0].mill_case), asked.values);
  for (const auto& [f_mat, x_w_min] : {std::pair{0.3, 0.01}, std::pair{2.0, 0.2}}) {
    const std::vector<double> predicted = predict({f_mat, x_w_min});
    const std::vector<double> expected =
        run_says({{"breakage.f_mat", std::to_string(f_mat) + " kg/J/m"},
                  {"breakage.x_w_min", std::to_string(x_w_min) + " J m/kg"}});
    ASSERT_EQ(predicted.size(), expected.size());
    for (std::size_t i = 0; i < predicted.size(); ++i)
      EXPECT_DOUBLE_EQ(predicted[i], expected[i]) << i;
  }
}

TEST(Fit, ends_when_it_is_told_to) {
  const std::vector<results::Outcome> mills{run(read(mill + kinetics))};
  const std::atomic<bool> stop{true};
  Measurements all = data("time (s),conversion\n60,0.2\n600,0.8\n");
  EXPECT_THROW(fit(mills, all, free_parameters(mills[0].mill_case), {.stop = &stop}), Interrupted);
}

TEST(Fit, of_a_dose_constant_has_the_closed_form) {
  // Without scatter, conversion = 1 - exp(-D/D_0) gives D_0 = -D/ln(1 - conversion) from one value.
  const std::vector<results::Outcome> mills{run(read(mill + kinetics))};
  const double rate = results::dissipated_power(mills[0].replicates[0]) / 0.15e-3;
  const Measurements all = data("time (s),conversion,conversion_error\n600,0.7,0.01\n");
  const Fit found = fit(mills, all, free_parameters(mills[0].mill_case));
  const double expected = -rate * 600 / std::log1p(-0.7);
  const FittedParameter& p = found.result.parameters[0];
  states("D_0", p.value, expected, 1e-9 * expected, "closed form");
  // The value at an end of the interval is 1.96 errors away; ends are found to 1 % of the
  // half-width.
  const double low = -rate * 600 / std::log1p(-0.7 - 0.0196);
  const double high = -rate * 600 / std::log1p(-0.7 + 0.0196);
  states("lower end", p.low, low, 0.01 * (expected - low), "closed form");
  states("upper end", p.high, high, 0.01 * (high - expected), "closed form");
  EXPECT_TRUE(std::isnan(p.simulation_ci95)) << "one replicate has no scatter";
}

/// Normal numbers (Box and Muller 1958).
double normal(Random& random) {
  const double size = std::sqrt(-2 * std::log(random.uniform()));
  return size * std::cos(random.uniform(0, 2 * std::numbers::pi));
}

TEST(Fit, intervals_allow_for_the_scatter_of_the_mill) {
  // Each mill is simulated so briefly that its power is known to a few per cent only. The
  // measurements are of a mill that runs 400 times as long, with noise of their own.
  constexpr int trials = 200;
  constexpr double true_dose = 1e6, noise = 0.005;
  const auto power = [](const results::Outcome& of) {
    double sum = 0;
    for (const results::Replicate& r : of.replicates) sum += results::dissipated_power(r);
    return sum / static_cast<double>(of.replicates.size());
  };
  const std::string text = mill + kinetics;
  const double rate =
      power(run(
          read(text, {{"run.time", "400 s"}, {"run.replicates", "5"}, {"run.settle", "1 s"}}))) /
      0.15e-3;
  Random random(1963, 0);
  int held = 0, held_without = 0;
  for (int trial = 1; trial <= trials; ++trial) {
    const std::vector<results::Outcome> mills{run(read(
        text, {{"seed", std::to_string(trial)}, {"run.settle", "1 s"}, {"run.replicates", "5"}}))};
    Measurements all =
        data("time (s),conversion,conversion_error\n20,0.5,1\n60,0.5,1\n200,0.5,1\n");
    for (Measurement& m : all.values) {
      m.value = -std::expm1(-rate * m.time / true_dose) + noise * normal(random);
      m.error = noise;
    }
    const std::vector<FreeParameter> numbers = free_parameters(mills[0].mill_case);
    const FittedParameter p = fit(mills, all, numbers).result.parameters[0];
    held += p.low <= true_dose && true_dose <= p.high ? 1 : 0;
    // If all replicates are alike, the power of the mill seems to be known exactly.
    std::vector<results::Outcome> sure = mills;
    for (results::Replicate& r : sure[0].replicates) r = mills[0].replicates[0];
    const FittedParameter q = fit(sure, all, numbers).result.parameters[0];
    held_without += q.low <= true_dose && true_dose <= q.high ? 1 : 0;
  }
  // Binomial: 200 trials of 0.95, standard deviation 3.1; 1 in 1000 lies beyond 3.3 standard
  // deviations.
  const double spread = 3.3 * std::sqrt(trials * 0.95 * 0.05);
  states("intervals that hold the truth, of 200", held, 0.95 * trials, spread,
         "binomial, 3.3 standard deviations");
  EXPECT_LT(held_without, 0.8 * trials) << "otherwise the scatter has no effect";
}

}  // namespace
}  // namespace mahlwerk::campaign::fit_test
