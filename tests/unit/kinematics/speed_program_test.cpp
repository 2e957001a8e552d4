// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A prescribed speed over time (kin.21, kin.27).
#include "mahlwerk/kinematics/speed_program.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "statement.hpp"

namespace mahlwerk::kinematics::speed_program_test {
namespace {

using tests::states;

/// Full speed at 2 s, kept until 5 s, and from 7 s the full speed in the other sense.
const SpeedProgram reversal({{0, 0}, {2, 1}, {5, 1}, {7, -1}});
/// The same, ended at rest and repeated; it does not come back to where it began.
const SpeedProgram cycle({{0, 0}, {2, 1}, {5, 1}, {7, -0.3}, {8, 0}}, true);

TEST(SpeedProgram, of_a_ramp_is_3u2_minus_2u3_to_the_bit) {
  constexpr double ramp = 0.7;
  const SpeedProgram program = SpeedProgram::ramp(ramp);
  for (double t = 0; t < 2; t += 0.0137) {
    const double u = t / ramp, u2 = u * u;
    const Clock at = program.clock(t);
    EXPECT_EQ(at.time, t >= ramp ? t - 0.5 * ramp : ramp * u * (u2 - 0.5 * u * u2)) << t;
    EXPECT_EQ(at.rate, t >= ramp ? 1 : u2 * (3 - 2 * u)) << t;
    EXPECT_EQ(at.acceleration, t >= ramp ? 0 : 6 * u * (1 - u) / ramp) << t;
  }
}

TEST(SpeedProgram, has_the_clock_of_its_rows) {
  const auto clock = [](double t) { return reversal.clock(t); };
  states("s(2 s)", clock(2).time, 1, 1e-15, "half of 2 s");
  states("s(5 s)", clock(5).time, 4, 1e-15, "3 s more at full speed");
  states("s(6 s)", clock(6).time, 4.625, 1e-15, "2 s (u - 2 (u^3 - u^4/2)) at u = 1/2");
  states("rate at 6 s", clock(6).rate, 0, 1e-15, "half way from 1 to -1");
  states("acceleration at 6 s [1/s]", clock(6).acceleration, -1.5, 1e-15, "-2 * 6 u (1 - u)/2 s");
  states("s(7 s)", clock(7).time, 4, 1e-15, "back again");
  states("s(12 s)", clock(12).time, -1, 1e-14, "5 s at -1");
  EXPECT_TRUE(reversal.reverses());
  EXPECT_FALSE(SpeedProgram::ramp(1).reverses());
}

/// Simpson's rule is exact for the rate, of third order between two rows.
TEST(SpeedProgram, its_clock_and_its_travel_are_integrals_of_the_rate) {
  for (const SpeedProgram& program : {reversal, cycle}) {
    constexpr double step = 1e-3;
    double time = 0, travel = 0;
    const auto third = [&](double t, const auto& of) {
      const double a = of(program.clock(t).rate), b = of(program.clock(t + 0.5 * step).rate),
                   c = of(program.clock(t + step).rate);
      return step / 6 * (a + 4 * b + c);
    };
    for (int k = 0; k < 20'000; ++k) {
      time += third(step * k, [](double r) { return r; });
      travel += third(step * k, [](double r) { return std::abs(r); });
      if (k % 1700 != 0) continue;
      const double t = step * (k + 1);
      states("clock [s]", program.clock(t).time, time, 1e-11, "Simpson");
      // At a zero of the rate within a step the rule errs by the slope, 1.5/s, times step^2.
      states("travel [s]", program.travel(t), travel, 5e-6, "Simpson");
    }
  }
  states("travel in 7 s", reversal.travel(7), 5.25, 1e-14, "4 s, and twice 0.625 s");
}

TEST(SpeedProgram, that_repeats_goes_on_from_where_it_was) {
  const double once = cycle.clock(8 - 1e-12).time;
  for (const double t : {0.3, 1.9, 4.0, 6.3, 7.7})
    for (const int k : {1, 2, 5}) {
      const Clock first = cycle.clock(t), later = cycle.clock(t + 8 * k);
      states("clock [s]", later.time, first.time + k * once, 1e-10, "k times a cycle more");
      states("rate", later.rate, first.rate, 1e-13, "the same");
    }
}

TEST(SpeedProgram, without_rows_is_the_time_itself) {
  const SpeedProgram none;
  EXPECT_EQ(none.clock(3.7).time, 3.7);
  EXPECT_EQ(none.clock(3.7).rate, 1);
  EXPECT_EQ(none.travel(3.7), 3.7);
  EXPECT_EQ(none.last_rate(), 1);
}

}  // namespace
}  // namespace mahlwerk::kinematics::speed_program_test
