// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The formulas of comminution for the power of tumbling mills, against worked values and the
// integrals that their closed forms solve.
#include "mahlwerk/cases/mill_power.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "statement.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::mill_power_test {
namespace {

using sample::read_sample;
using tests::states;

constexpr double pi = std::numbers::pi, g = 9.81;

MillNumbers ball_mill(double filling = 0.35, double speed = 0.75) {
  return {.diameter = 2.4, .length = 3.6, .speed = speed, .filling = filling, .density = 4680};
}

/// Simpson's rule, exact for the cubic integrands below but for rounding.
template <class F>
double integral(F f, double from, double to) {
  constexpr int pieces = 20;
  const double h = (to - from) / pieces;
  double sum = f(from) + f(to);
  for (int i = 1; i < pieces; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(from + i * h);
  return sum * h / 3;
}

/// By hand: 2.4^0.3 = 1.300359, 3.2 - 3 J = 2.15, 1 - 0.1/2^1.5 = 0.964645, their product with 0.75
/// and 4.879 is 9.86873.
TEST(MillPower, bond_gives_the_worked_value_per_tonne) {
  states("kW for a tonne of balls", 1e-3 * bond_power(ball_mill(), 1000), 9.86873, 1e-5,
         "mil.1, by hand to six digits");
  EXPECT_DOUBLE_EQ(bond_power(ball_mill(), 3000), 3 * bond_power(ball_mill(), 1000));
}

/// By hand for 10 ft by 10 ft, phi 0.72, J 0.4, 4.68 t/m3 and 35 degrees:
/// 0.238 * 3162.28 * 0.72 * 4.68 * 0.4 * (1 - 0.426) * 0.573576 = 333.98.
TEST(MillPower, hogg_and_fuerstenau_give_the_worked_value_in_feet) {
  const MillNumbers m{
      .diameter = 3.048, .length = 3.048, .speed = 0.72, .filling = 0.4, .density = 4680};
  states("kW", 1e-3 * hogg_fuerstenau_power(m, usual_lift_angle), 333.98, 0.02,
         "mil.2, by hand to five digits");
}

/// By hand for J 0.35 and phi 0.75: phi_c = 1.0549, exp(-19.42 * 0.3049) = 0.0026822;
/// theta_T = 2.5307 * 0.9296 * 0.9973178 + pi/2 = 3.917025;
/// theta_S = pi/2 - 2.346229 (0.3386 + 0.078075 - 0.385475 * 0.35) = 0.909726.
TEST(MillPower, morrells_charge_has_the_worked_toe_and_shoulder) {
  const MorrellCharge c = morrell_charge(ball_mill());
  states("toe [rad]", c.toe, 3.917025, 1e-6, "mil.3, by hand");
  states("shoulder [rad]", c.shoulder, 0.909726, 1e-6, "mil.4, by hand");
}

/// Above the speed at which the charge centrifuges, phi_c is phi and the toe is at 12 o'clock.
TEST(MillPower, morrells_toe_is_at_twelve_o_clock_when_the_charge_centrifuges) {
  EXPECT_DOUBLE_EQ(morrell_charge(ball_mill(0.35, 1.1)).toe, 0.5 * pi);
}

/// The speed of the charge falls from that of the shell at r_m to (1 - z) r_i/(r_m - z r_i) of it
/// at r_i. Its layers are lifted from the toe to the shoulder, and leave with their kinetic energy:
/// P = rho L int g r V (sin theta_S - sin theta_T) + V^3/2 dr (Morrell 1993).
TEST(MillPower, morrells_closed_form_is_the_integral_over_the_layers_of_the_charge) {
  for (const double filling : {0.1, 0.35, 0.45})
    for (const double speed : {0.6, 0.85}) {
      const MillNumbers m = ball_mill(filling, speed);
      const MorrellCharge c = morrell_charge(m);
      const double rm = 0.5 * m.diameter, ri = c.inner_radius, z = std::pow(1 - filling, 0.4532);
      const double turns = speed * std::sqrt(2 * g / m.diameter) / (2 * pi);
      const auto along = [&](double r) {
        return 2 * pi * turns * rm * (r - z * ri) / (rm - z * ri);
      };
      const double lift = std::sin(c.shoulder) - std::sin(c.toe);
      const auto layer = [&](double r) {
        const double v = along(r);
        return m.density * m.length * (g * r * v * lift + 0.5 * v * v * v);
      };
      const double power = integral(layer, ri, rm);
      states("power over the integral", c.power / power, 1, 1e-12, "mil.6, rounding");
      EXPECT_GT(ri, 0);
      EXPECT_LT(ri, rm);
    }
}

/// A charge that does not fly (beta = 1) fills J of the mill between r_i and r_m, so r_i is not
/// less than that; and the share in the bed is t_c/(t_c + t_f) by half the turns of the mill
/// (mil.5).
TEST(MillPower, morrells_inner_radius_leaves_room_for_the_share_in_the_bed) {
  const MillNumbers m = ball_mill();
  const MorrellCharge c = morrell_charge(m);
  const double rm = 0.5 * m.diameter, arc = 2 * pi + c.shoulder - c.toe;
  const double bed = 0.5 * arc * (rm * rm - c.inner_radius * c.inner_radius) / (pi * rm * rm);
  const double turns = m.speed * std::sqrt(2 * g / m.diameter) / (2 * pi);
  const double mean = 0.5 * rm * (1 + std::sqrt(1 - 2 * pi * m.filling / arc));
  const double flight = std::sqrt(2 * mean * (std::sin(c.shoulder) - std::sin(c.toe)) / g);
  states("share of the charge in the bed", bed / m.filling,
         (arc / (pi * turns)) / (arc / (pi * turns) + flight), 1e-12, "mil.5, rounding");
}

/// By hand: 2.4^2.05 = 6.017735, (0.75 * 3.6)^0.82 = 2.257971, their product with 1.68 is 22.8276.
TEST(MillPower, of_the_empty_mill_is_the_worked_value) {
  states("kW", 1e-3 * morrell_no_load_power(ball_mill()), 22.8276, 1e-4, "mil.8, by hand");
}

constexpr std::string_view drum = R"(title = "Slice of a ball mill"
[mill]
kind = "tumbling"
speed = "20 rpm"
[jar]
kind = "periodic-lifter-cylinder"
diameter = "2.4 m"
length = "0.3 m"
lifters = 20
lifter_height = "60 mm"
lifter_width = "120 mm"
mill_length = "3.6 m"
[[balls]]
diameter = "75 mm"
density = "7800 kg/m3"
bulk_filling = "35 %"
[run]
engine = "soft"
time = "1 s"
)";

TEST(MillPower, numbers_of_a_case_are_those_of_the_shell_and_the_balls) {
  const auto m = mill_numbers(read_sample(std::string(drum)));
  ASSERT_TRUE(m.has_value());
  EXPECT_DOUBLE_EQ(m->diameter, 2.4);
  EXPECT_DOUBLE_EQ(m->length, 0.3);
  states("phi", m->speed, 20 * pi / 30 / std::sqrt(2 * g / 2.4), 1e-12, "critical speed of Bond");
  // The number of balls is whole: one ball of 1257 is 0.0003 of J.
  states("J", m->filling, 0.35, 2e-4, "as the case states it");
  states("bulk density [kg/m3]", m->density, 0.6 * 7800, 1e-9, "40 % voids");
}

TEST(MillPower, of_a_mill_end_over_end_or_at_rest_is_not_given) {
  const auto given = [](const std::vector<Override>& changes) {
    return mill_numbers(read_sample(std::string(drum), changes)).has_value();
  };
  EXPECT_TRUE(given({}));
  EXPECT_FALSE(given({{"mill.speed", "0 rpm"}}));
  EXPECT_FALSE(given({{"gravity", "0 m/s2"}}));
}

/// Above 123 % of the critical speed Bond's formula is negative.
TEST(MillPower, has_no_value_by_a_formula_outside_its_range) {
  MillNumbers fast = ball_mill(0.35, 1.3);
  EXPECT_LT(bond_power(fast, 1000), 0);
  for (const FormulaRange& range : formula_ranges) {
    EXPECT_FALSE(range.has(fast)) << range.name;
    EXPECT_TRUE(range.has(ball_mill(0.35, 0.75))) << range.name;
    EXPECT_TRUE(range.has(ball_mill(range.least_filling, range.least_speed))) << range.name;
    EXPECT_TRUE(range.has(ball_mill(range.most_filling, range.most_speed))) << range.name;
    EXPECT_FALSE(range.has(ball_mill(range.most_filling + 0.001, 0.75))) << range.name;
    EXPECT_FALSE(range.has(ball_mill(0.35, range.least_speed - 0.001))) << range.name;
  }
}

TEST(MillPower, that_a_formula_does_not_give_is_noted_with_the_reason) {
  const auto told = [](const std::string& speed, const std::string& filling) {
    const Notices notes = mill_power_notices(
        read_sample(std::string(drum), {{"mill.speed", speed}, {"balls.1.bulk_filling", filling}}));
    return notes.empty() ? std::string() : notes.at(0).text;
  };
  EXPECT_EQ(told("20 rpm", "35 %"), "");
  const std::string fast = told("35 rpm", "35 %");
  for (const char* part : {"128.2 % of the critical speed", "(bond_power)", "(morrell_power)",
                           "(hogg_fuerstenau_power)", "speed of 50 to 90 %"})
    EXPECT_NE(fast.find(part), std::string::npos) << part << " in: " << fast;
  const std::string empty = told("20 rpm", "7 %");
  EXPECT_NE(empty.find("bond_power"), std::string::npos) << empty;
  EXPECT_EQ(empty.find("morrell_power"), std::string::npos) << "its range begins at 5 %: " << empty;
}

/// A motor or a speed over time decides at which mean speed the run will be.
TEST(MillPower, before_a_run_of_another_speed_is_told_for_the_speed_of_the_case) {
  const std::vector<Override> fast{{"mill.speed", "35 rpm"}, {"balls.1.bulk_filling", "35 %"}};
  const auto with = [&](std::vector<Override> more) {
    more.insert(more.end(), fast.begin(), fast.end());
    return read_sample(std::string(drum), more);
  };
  const Case driven = with({{"drive.inertia", "1 kg m2"}, {"drive.torque", "1 N m"}}),
             programmed = with({{"mill.speed_over_time", "[[\"0 s\", 0], [\"1 s\", 0.5]]"}});
  EXPECT_NE(mill_power_notices(driven).at(0).text.find("shell without load"), std::string::npos);
  EXPECT_NE(mill_power_notices(programmed).at(0).text.find("shell at full speed"),
            std::string::npos);
  for (const Case& c : {driven, programmed}) {
    EXPECT_EQ(mill_power_notices(c, 0.5).size(), 0U) << "64 % of the critical speed is in range";
    EXPECT_TRUE(may_hold(bond_range, c)) << "the run decides";
  }
  EXPECT_FALSE(may_hold(bond_range, with({})));
}

}  // namespace
}  // namespace mahlwerk::cases::mill_power_test
