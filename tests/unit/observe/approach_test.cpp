// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Exponential approaches fitted to curves whose time constant is known (mix.3).
#include "mahlwerk/observe/approach.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "statement.hpp"

namespace mahlwerk::observe::approach_test {
namespace {

using tests::states;
using Kind = Approach::Kind;

constexpr std::size_t samples = 101;
constexpr double counted = 10;  // [s]

struct Curve {
  double start = 0, end = 1, time = 1;
  double at(double t) const { return end - (end - start) * std::exp(-t / time); }
};

std::vector<double> times() {
  std::vector<double> all;
  for (std::size_t i = 0; i < samples; ++i) all.push_back(counted / (samples - 1) * double(i));
  return all;
}

/// A number of the standard normal distribution (Box and Muller).
double normal(Random& random) {
  const double u = random.uniform();
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * random.uniform());
}

template <class Of>
Approach fit(const Of& of, double noise = 0, std::uint32_t draw = 0) {
  Random random(7, draw);
  std::vector<double> values;
  for (const double t : times()) values.push_back(of(t) + (noise > 0 ? noise * normal(random) : 0));
  return fit_approach(times(), values);
}
Approach fit(const Curve& curve, double noise = 0, std::uint32_t draw = 0) {
  return fit([&](double t) { return curve.at(t); }, noise, draw);
}

/// Standard error of the time constant of a fit by least squares, to first order (Cramer and Rao).
double standard_error(const Curve& c, double noise) {
  double a[3][3] = {};
  for (const double t : times()) {
    const double e = std::exp(-t / c.time);
    const double d[3] = {(c.start - c.end) * e * t / (c.time * c.time), e, 1 - e};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) a[i][j] += d[i] * d[j];
  }
  const double minor = a[1][1] * a[2][2] - a[1][2] * a[2][1];
  const double whole = a[0][0] * minor - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
                       a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
  return noise * std::sqrt(minor / whole);
}

void is_found_exactly(const Curve& c) {
  const Approach found = fit(c);
  EXPECT_EQ(found.kind, Kind::found);
  // The sum of squares is flat at its least value: rounding of 1e-16 in it moves the time by 1e-8.
  states("time constant", found.time, c.time, 1e-7 * c.time, "its own");
  states("start", found.start, c.start, 1e-7, "its own");
  states("end", found.end, c.end, 1e-7, "its own");
}

TEST(Approach, to_a_random_mixture_has_its_time_constant) {
  is_found_exactly({0.05, 1, 2});
}
TEST(Approach, of_a_charge_that_segregates_has_its_time_constant) {
  is_found_exactly({0.95, 0.4, 1.3});
  is_found_exactly({0.1, 0.4, 0.5});
}
TEST(Approach, is_found_from_two_intervals_up_to_the_counted_time) {
  is_found_exactly({0, 1, 0.2});
  is_found_exactly({0, 1, 0.9 * counted});
}

TEST(Approach, with_scatter_has_the_standard_error_of_least_squares) {
  constexpr int draws = 400;
  constexpr double noise = 0.02;
  for (const Curve& c : {Curve{0, 1, 2}, Curve{0.9, 0.4, 1}}) {
    double sum = 0, squares = 0;
    for (int i = 0; i < draws; ++i) {
      const Approach found = fit(c, noise, static_cast<std::uint32_t>(i));
      ASSERT_EQ(found.kind, Kind::found);
      sum += found.time / draws;
      squares += (found.time - c.time) * (found.time - c.time) / draws;
    }
    const double expected = standard_error(c, noise);
    states("mean time constant", sum, c.time, 4 * expected / std::sqrt(draws) + expected * expected,
           "four standard errors, and a bias of second order");
    states("standard error", std::sqrt(squares), expected, 4 * expected / std::sqrt(2.0 * draws),
           "Cramer and Rao");
  }
}

/// How many of a thousand curves are fitted as of that kind.
template <class Of>
int count(Kind kind, const Of& of, double noise) {
  int found = 0;
  for (std::uint32_t i = 0; i < 1000; ++i) found += fit(of, noise, i).kind == kind ? 1 : 0;
  return found;
}

TEST(Approach, of_a_level_with_scatter_is_flat) {
  // F of two parameters and 98 degrees of freedom is above 10 with a probability of 1e-4; the time
  // constant that is searched besides multiplies this by the number of independent times, about 10.
  states("flat curves",
         count(
             Kind::flat, [](double) { return 0.4; }, 0.05),
         1000, 5, "a probability of 1e-3; four standard errors");
  const Approach exact = fit([](double) { return 0.4; });
  EXPECT_EQ(exact.kind, Kind::flat);
  states("level", exact.end, 0.4, 1e-15, "its own");
}

TEST(Approach, of_slow_swings_about_a_level_is_flat) {
  int flat = 0;
  for (std::uint32_t draw = 0; draw < 1000; ++draw) {
    Random random(8, draw);
    constexpr double memory = 0.8;  // of a sample for the one before
    double swing = normal(random);
    std::vector<double> values;
    for (std::size_t i = 0; i < samples; ++i) {
      values.push_back(0.9 + 0.02 * swing);
      swing = memory * swing + std::sqrt(1 - memory * memory) * normal(random);
    }
    flat += fit_approach(times(), values).kind == Kind::flat ? 1 : 0;
  }
  // One in a thousand, if the correlation were known; it comes from the residuals and is too low
  // where the fit follows a swing. Without it, one in eight curves would not be flat.
  states("flat curves", flat, 1000, 20, "two per cent");
}

TEST(Approach, of_a_straight_line_has_no_end) {
  const auto line = [](double t) { return 0.1 + 0.05 * t; };
  EXPECT_EQ(fit(line).kind, Kind::open);
  // Student's t of 97 degrees of freedom is above sqrt(10) with a probability of 1e-3.
  states("lines without end", count(Kind::open, line, 0.02), 1000, 5, "four standard errors");
}

TEST(Approach, that_takes_longer_than_the_counted_time_is_open) {
  for (const double time : {1.1, 3.0, 30.0}) {
    const Approach found = fit(Curve{0, 1, time * counted});
    EXPECT_EQ(found.kind, Kind::open);
    EXPECT_TRUE(std::isnan(found.time));
  }
}

TEST(Approach, within_the_first_interval_is_fast) {
  const Approach found = fit(Curve{0.1, 0.9, 0.01}, 0.01);
  EXPECT_EQ(found.kind, Kind::fast);
  EXPECT_TRUE(std::isnan(found.time));
  states("end", found.end, 0.9, 4 * 0.01 / std::sqrt(samples), "four standard errors");
}

TEST(Approach, of_samples_without_a_value_leaves_them_out) {
  std::vector<double> values;
  for (const double t : times()) values.push_back(Curve{}.at(t));
  for (std::size_t i = 3; i < samples; i += 7) values[i] = std::nan("");
  states("time constant", fit_approach(times(), values).time, 1, 1e-7, "its own");
  EXPECT_EQ(fit_approach({}, {}).kind, Kind::open);
  const std::array<double, 4> few{0, 1, 2, 3}, of{0, 0.5, 0.75, 0.875};
  EXPECT_EQ(fit_approach(few, of).kind, Kind::open);
}

}  // namespace
}  // namespace mahlwerk::observe::approach_test
