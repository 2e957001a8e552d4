// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/calibrate/calibration.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/calibrate/calibration_job.hpp"
#include "mahlwerk/campaign/calibrate/ensemble_sampler.hpp"
#include "mahlwerk/campaign/calibrate/likelihood.hpp"
#include "mahlwerk/campaign/calibrate/posterior.hpp"
#include "mahlwerk/campaign/fit/minimiser.hpp"
#include "statement.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::calibration_test {
namespace {

using tests::states;
using tests::stays_below;

TEST(EnsembleSampler, samples_a_correlated_normal_density) {
  constexpr double deviation = 0.05, rho = 0.95;
  const auto log_density = [](const std::vector<double>& x) {
    const double a = (x[0] - 0.4) / deviation, b = (x[1] - 0.6) / deviation;
    return -(a * a - 2 * rho * a * b + b * b) / (2 * (1 - rho * rho));
  };
  const DensitySample drawn =
      sample_density(log_density, {{0.5, 0.5}, {0.1, 0.9}},
                     {.walkers = 40, .burn_in = 300, .moves = 4000, .keep_every = 10, .seed = 1});
  std::vector<double> first;
  for (const auto& point : drawn.points) first.push_back(point[0]);
  double mean = 0, square = 0;
  for (const double x : first) mean += x / static_cast<double>(first.size());
  for (const double x : first)
    square += (x - mean) * (x - mean) / static_cast<double>(first.size());
  // An ensemble of Goodman and Weare has a correlation time of about 50 moves in two dimensions:
  // 40 walkers of 4000 moves hold about 3200 independent points.
  const double independent = 3200;
  states("mean", mean, 0.4, 4 * deviation / std::sqrt(independent), "the density");
  states("standard deviation", std::sqrt(square), deviation,
         4 * deviation / std::sqrt(2 * independent), "the density");
  states("correlation", correlation_of(drawn.points, 2)[0][1], rho,
         4 * (1 - rho * rho) / std::sqrt(independent), "the density");
  states("97.5 % quantile", quantile_of(first, 0.975), 0.4 + 1.96 * deviation,
         4 * 2.7 * deviation / std::sqrt(independent), "the density");
  stays_below("potential scale reduction", drawn.shrinkage, 1.05, "cal.5");
}

TEST(EnsembleSampler, stays_in_the_unit_cube_and_refuses_a_density_of_zero) {
  const DensitySample drawn =
      sample_density([](const std::vector<double>&) { return 0.0; }, {{0.5}},
                     {.walkers = 24, .burn_in = 200, .moves = 4000, .keep_every = 10, .seed = 2});
  double mean = 0, square = 0;
  for (const auto& point : drawn.points) {
    EXPECT_GT(point[0], 0);
    EXPECT_LT(point[0], 1);
    mean += point[0] / static_cast<double>(drawn.points.size());
    square += point[0] * point[0] / static_cast<double>(drawn.points.size());
  }
  const double independent = 24 * 4000 / 40;
  states("mean of a uniform density", mean, 0.5, 4 * 0.289 / std::sqrt(independent), "1/2");
  states("its variance", square - mean * mean, 1.0 / 12, 4 * 0.0745 / std::sqrt(independent),
         "1/12");
  EXPECT_THROW(sample_density([](const std::vector<double>&) { return NAN; }, {{0.5}}, {}),
               std::invalid_argument);
}

/// Power [W] of a mill that grows with the stroke and with what collisions lose, at several
/// frequencies. `noise` is relative.
constexpr std::array frequencies{12.0, 16.0, 20.0, 25.0};
double power(double e, double stroke, double frequency) {
  const double f = frequency / 20;
  return 4 * stroke * stroke * f * f * f * (1 - e * e) / (1 + 1.5 * e * f);
}

/// A standard normal number.
double normal(Random& random) {
  return standard_normal(random);
}

CalibrationGoal goal_of(const std::vector<double>& measured, double error) {
  CalibrationGoal goal{.parameters = {{.name = "restitution", .least = 0.1, .most = 0.95},
                                      {.name = "stroke", .least = 0.5, .most = 1.5}},
                       .data = {},
                       .outcomes = frequencies.size(),
                       .settings = 44,
                       .replicates = 2};
  for (std::size_t i = 0; i < measured.size(); ++i)
    goal.data.push_back({.outcome = i, .value = measured[i], .error = error * measured[i]});
  return goal;
}

/// Runs with a relative scatter of 3 %.
std::vector<TrialResult> simulated(const CalibrationGoal& goal,
                                   const std::vector<TrialRequest>& asked) {
  std::vector<TrialResult> results;
  for (const TrialRequest& one : asked) {
    TrialResult& made = results.emplace_back();
    const double e = value_at(goal.parameters[0], one.point[0]),
                 stroke = value_at(goal.parameters[1], one.point[1]);
    for (int r = 0; r < one.count; ++r) {
      Random random(7, static_cast<std::uint32_t>(one.first + r));
      std::vector<double>& values = made.replicates.emplace_back();
      for (const double f : frequencies)
        values.push_back(power(e, stroke, f) * (1 + 0.03 * normal(random)));
    }
  }
  return results;
}

/// Measurements with an error of 3 % at parameters drawn from their ranges.
struct Synthetic {
  double e, stroke;
  std::vector<double> measured;
};
Synthetic synthetic(std::uint64_t number) {
  Random random(1234, static_cast<std::uint32_t>(number));
  Synthetic made{random.uniform(0.1, 0.95), random.uniform(0.5, 1.5), {}};
  for (const double f : frequencies)
    made.measured.push_back(power(made.e, made.stroke, f) * (1 + 0.03 * normal(random)));
  return made;
}

CalibrationResult calibrated(const std::vector<double>& measured, double error = 0.03) {
  const CalibrationGoal goal = goal_of(measured, error);
  return calibrate(goal, [&](const auto& asked) { return simulated(goal, asked); });
}

TEST(Calibration, intervals_contain_the_truth_in_95_of_100_data_sets) {
  constexpr int sets = 100;
  std::array<int, 2> covered{};
  double narrower = 0;
  for (int k = 0; k < sets; ++k) {
    const Synthetic truth = synthetic(static_cast<std::uint64_t>(k));
    const CalibrationResult found = calibrated(truth.measured);
    const std::array<double, 2> values{truth.e, truth.stroke};
    for (std::size_t i = 0; i < 2; ++i)
      if (found.parameters[i].low <= values[i] && values[i] <= found.parameters[i].high)
        ++covered[i];
    narrower += (found.parameters[1].high - found.parameters[1].low) / sets;
  }
  // The number is binomial with p = 0.95; errors of the emulators make it smaller. Three standard
  // deviations are 6.5.
  for (std::size_t i = 0; i < 2; ++i)
    states(i == 0 ? "sets that cover the restitution" : "sets that cover the stroke", covered[i],
           95, 6.5, "95 % intervals; binomial");
  stays_below("mean width of the stroke's interval", narrower, 0.5, "narrower than the range, 1");
}

TEST(Calibration, of_exact_data_finds_the_parameters_and_predicts_the_outcomes) {
  std::vector<double> measured;
  for (const double f : frequencies) measured.push_back(power(0.5, 0.8, f));
  const CalibrationResult found = calibrated(measured, 0.01);
  ASSERT_EQ(found.parameters.size(), 2U);
  EXPECT_LE(found.parameters[0].low, 0.5);
  EXPECT_GE(found.parameters[0].high, 0.5);
  EXPECT_TRUE(found.parameters[1].determined);
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    const observe::IntervalEstimate& p = found.outcomes[i].value;
    states("prediction [W]", p.value, measured[i], p.half_width(), "its 95 % interval");
    stays_below("its width over the value", (p.high - p.low) / measured[i], 0.08,
                "four errors of 1 % and the emulator's");
  }
  EXPECT_EQ(found.draws.size(), 32U);
  EXPECT_LE(found.settings, 44);
}

TEST(Calibration, is_the_same_each_time) {
  const std::vector<double> measured = synthetic(3).measured;
  const CalibrationResult one = calibrated(measured), other = calibrated(measured);
  EXPECT_EQ(one.central, other.central);
  EXPECT_EQ(one.posterior, other.posterior);
}

TEST(Calibration, says_what_the_data_do_not_determine) {
  CalibrationGoal goal = goal_of({power(0.5, 1, frequencies[0])}, 0.03);
  goal.parameters.push_back({.name = "without effect", .least = 0, .most = 1});
  const CalibrationResult found =
      calibrate(goal, [&](const auto& asked) { return simulated(goal, asked); });
  EXPECT_FALSE(found.parameters[2].determined);
  EXPECT_FALSE(found.parameters[2].remarks.empty());
  EXPECT_TRUE(std::isnan(found.misfit)) << "one value for three parameters";
}

TEST(Calibration, widens_intervals_of_a_model_that_does_not_fit) {
  std::vector<double> measured;
  for (const double f : frequencies) measured.push_back(power(0.5, 1, f));
  const CalibrationResult fits = calibrated(measured);
  measured[0] *= 1.6;
  measured[2] *= 0.6;
  const CalibrationResult misses = calibrated(measured);
  EXPECT_LT(fits.misfit, 1.5);
  EXPECT_GT(misses.misfit, 3);
  const auto width = [](const CalibrationResult& r) {  // of what the model predicts
    return r.outcomes[1].value.high - r.outcomes[1].value.low;
  };
  EXPECT_GT(width(misses), 2 * width(fits));
  EXPECT_NE(misses.remarks.front().find("scatter"), std::string::npos) << misses.remarks.front();
}

TEST(Calibration, estimates_the_scatter_of_data_without_errors) {
  CalibrationGoal goal = goal_of(synthetic(5).measured, 0.03);
  for (std::size_t k = 0; k < 3; ++k)  // four data sets of the same mill
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
      const Synthetic truth = synthetic(5);
      Random random(99, static_cast<std::uint32_t>(10 * k + i));
      goal.data.push_back(
          {.outcome = i,
           .value = power(truth.e, truth.stroke, frequencies[i]) * (1 + 0.03 * normal(random))});
    }
  for (Datum& datum : goal.data) datum.error = NAN;
  const CalibrationResult found =
      calibrate(goal, [&](const auto& asked) { return simulated(goal, asked); });
  ASSERT_EQ(found.scatter.size(), 1U);
  // The scatter of 16 values with two parameters is known to 1/sqrt(2 * 14) = 19 %: three of that.
  states("relative scatter", found.scatter.front(), 0.03, 3 * 0.19 * 0.03, "the data");
}

TEST(Calibration, leaves_out_settings_that_fail_and_stops_if_too_few_run) {
  const CalibrationGoal goal = goal_of(synthetic(1).measured, 0.03);
  const auto some = [&](const std::vector<TrialRequest>& asked) {
    std::vector<TrialResult> all = simulated(goal, asked);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (asked[i].point[0] > 0.9) all[i].failure = "the balls do not fit";
    return all;
  };
  const CalibrationResult found = calibrate(goal, some);
  EXPECT_GT(found.failed, 0);
  EXPECT_NE(found.remarks.back().find("could not be run"), std::string::npos);
  const auto none = [&](const std::vector<TrialRequest>& asked) {
    std::vector<TrialResult> all = simulated(goal, asked);
    for (TrialResult& one : all) one.failure = "no room";
    return all;
  };
  EXPECT_THROW(calibrate(goal, none), RunError);
}

TEST(Likelihood, of_values_that_share_an_emulator_is_that_of_their_joint_normal_distribution) {
  const Synthetic truth = synthetic(2);
  CalibrationGoal goal = goal_of(truth.measured, 0.03);
  goal.data = {goal.data[0], goal.data[0]};
  goal.data[1].value *= 1.05;
  std::vector<Trial> trials;
  for (int k = 0; k < 8; ++k) {
    const DesignPoint point{0.1 + 0.1 * k, std::fmod(0.37 * k, 1)};
    const auto result = simulated(goal, {{.point = point, .first = 2 * k, .count = 2}});
    trials.push_back({.point = point, .replicates = result.front().replicates, .failure = {}});
  }
  const auto made = emulators(goal, trials);
  const Likelihood likelihood(goal, made);
  const std::vector<double> at{0.3, 0.6};
  // The plain formula with the 2 x 2 covariance matrix.
  const OutcomeEmulator& emulator = *made[0];
  const Posterior guess = emulator.model.at(at);
  const double v = guess.deviation * guess.deviation;
  std::array<double, 2> off{}, own{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Datum& d = goal.data[i];
    off[i] = emulator.transformed(d.value) - guess.mean;
    own[i] = emulator.logarithmic ? d.error / d.value : d.error;
  }
  const double a = own[0] * own[0] + v, b = own[1] * own[1] + v, determinant = a * b - v * v;
  const double quadratic =
      (b * off[0] * off[0] - 2 * v * off[0] * off[1] + a * off[1] * off[1]) / determinant;
  const double expected = -(quadratic + std::log(determinant)) / 2;
  states("log likelihood", likelihood.log_at(at), expected, 1e-9 * std::abs(expected),
         "cal.3, written out");
  states("chi square", likelihood.chi_square(at), quadratic, 1e-9 * quadratic, "cal.6");
}

TEST(Calibration, a_rebound_is_the_square_of_the_restitution) {
  const cases::Case mill_case = cases::sample::read_sample(R"(
[mill]
kind = "still"
[jar]
kind = "cylinder"
diameter = "50 mm"
height = "50 mm"
[[balls]]
count = 1
diameter = "10 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.8
friction = 0.3
[run]
time = "1 s"
)");
  states("rebound from 0.5 m [m]", rebound_height(mill_case, 0.5), 0.8 * 0.8 * 0.5, 1e-15, "cal.2");
}

}  // namespace
}  // namespace mahlwerk::campaign::calibration_test
