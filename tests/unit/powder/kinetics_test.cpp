// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Kinetics by impact, temperature and ignition against closed forms and plain references.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/powder/models.hpp"
#include "statement.hpp"

namespace mahlwerk::powder::kinetics_test {
namespace {

using tests::states;
using tests::stays_below;
using Scheme = ImpactKinetics::Scheme;

/// Three energies, each hit captures a few thousandths of one gram.
MillingConditions spectrum() {
  return {.powder_mass = 1e-3,
          .dose_rate = 50,
          .impact_rate = 40,
          .hits = {{1e-3, 20, 2e-6}, {4e-3, 12, 3e-6}, {9e-3, 8, 4e-6}},
          .temperature = {}};
}

/// Shares of plain elements of powder that are hit one impact after the other: each hit captures
/// each element with a probability, and each captured element reacts with another.
struct Counted {
  double conversion = 0, product = 0, second = 0;
};
Counted hit_by_hit(const ImpactKinetics& k, const MillingConditions& mill, double time,
                   int elements) {
  Random random(7, 1);
  std::vector<std::size_t> hits;
  for (std::size_t i = 0; i < mill.hits.size(); ++i)
    hits.insert(hits.end(), static_cast<std::size_t>(std::lround(mill.hits[i].rate * time)), i);
  for (std::size_t i = hits.size(); i > 1; --i)
    std::swap(hits[i - 1], hits[static_cast<std::size_t>(random.uniform() * double(i))]);
  Counted counted;
  for (int e = 0; e < elements; ++e) {
    char state = 'A';
    std::int64_t processed = 0;
    for (const std::size_t i : hits) {
      const double captured = mill.hits[i].mass / mill.powder_mass;
      const double first = k.share_of_hit(mill.hits[i].energy);
      const double second = k.has_second() ? k.share_of_hit(mill.hits[i].energy, true) : 0;
      if (random.uniform() >= captured) continue;
      const double drawn = random.uniform();
      if (state == 'A' && drawn < first)
        state = k.has_second() || ++processed >= k.hits_needed ? 'B' : 'A';
      else if (k.scheme == Scheme::parallel && state == 'A' && drawn < first + second)
        state = 'C';
      else if (k.scheme == Scheme::sequential && state == 'B' && drawn < second)
        state = 'C';
    }
    counted.conversion += (state != 'A') / double(elements);
    counted.product += (state == 'B') / double(elements);
    counted.second += (state == 'C') / double(elements);
  }
  return counted;
}

/// Four standard errors of a counted share, and the largest share per hit, to which order the
/// closed forms are exact (Le Cam's bound for a binomial and a Poisson distribution).
double tolerance(double share, int elements, double per_hit) {
  return 4 * std::sqrt(share * (1 - share) / elements) + per_hit;
}

void agrees(const std::string& name, const ImpactKinetics& k, double time) {
  constexpr int elements = 5000;
  constexpr double per_hit = 4e-3;
  const MillingConditions mill = spectrum();
  const Counted counted = hit_by_hit(k, mill, time, elements);
  const ReactionShares found = k.shares(mill, time);
  const std::string source = "elements hit one impact after the other";
  states(name + ", conversion", found.conversion, counted.conversion,
         tolerance(counted.conversion, elements, per_hit), source);
  if (!k.has_second()) return;
  states(name + ", product", found.product, counted.product,
         tolerance(counted.product, elements, per_hit), source);
  states(name + ", second product", found.second_product, counted.second,
         tolerance(counted.second, elements, per_hit), source);
  states(name + ", sum", found.product + found.second_product, found.conversion, 1e-14, "mass");
}

TEST(ImpactKinetics, equal_hits_leave_one_minus_k_to_the_number_of_hits) {
  const ImpactKinetics k{.processed_share = 0.4};
  for (const double mass : {1e-9, 1e-6, 1e-4, 9e-4})
    for (const int hits : {1, 10, 3000}) {
      const MillingConditions mill{
          .powder_mass = 1e-3, .hits = {{1e-3, 10, mass}}, .temperature = {}};
      const double fraction = 0.4 * mass / 1e-3;
      const double expected = -std::expm1(hits * std::log1p(-fraction));
      states("conversion", k.shares(mill, hits / 10.0).conversion, expected, 1e-12 * expected,
             "1 - (1 - k)^n");
    }
}

TEST(ImpactKinetics, hit_that_processes_all_powder_converts_all_and_stays_finite) {
  for (const Scheme scheme : {Scheme::simple, Scheme::sequential, Scheme::parallel}) {
    const ImpactKinetics k{.processed_share = 1, .second_share = 0.5, .scheme = scheme};
    const MillingConditions mill{.powder_mass = 1, .hits = {{1, 1, 5}}, .temperature = {}};
    const ReactionShares all = k.shares(mill, 2);
    states("conversion", all.conversion, 1, 1e-15, "k = 1");
    states("sum", all.product + all.second_product, 1, 1e-14, "mass");
    EXPECT_EQ(k.shares(mill, 0).conversion, 0);
  }
}

TEST(ImpactKinetics, schemes_agree_with_powder_that_is_hit_one_impact_after_the_other) {
  agrees("one hit", {.processed_share = 0.5}, 40);
  agrees("threshold", {.processed_share = 0.9, .threshold_energy = 2e-3}, 30);
  agrees("growth with energy",
         {.processed_share = 0.5,
          .threshold_energy = 5e-4,
          .energy_exponent = 0.7,
          .reference_energy = 5e-3},
         30);
  agrees("three hits", {.processed_share = 0.8, .hits_needed = 3}, 50);
  agrees("sequence",
         {.processed_share = 0.6,
          .second_share = 0.2,
          .second_threshold = 2e-3,
          .scheme = Scheme::sequential},
         40);
  agrees("parallel",
         {.processed_share = 0.3,
          .second_share = 0.4,
          .second_threshold = 2e-3,
          .scheme = Scheme::parallel},
         30);
}

TEST(ImpactKinetics, sequence_solves_its_rate_equations_for_equal_and_unequal_rates) {
  for (const double second : {1e-4, 0.3, 0.3 + 1e-12, 1.0}) {
    const ImpactKinetics k{
        .processed_share = 0.3, .second_share = second, .scheme = Scheme::sequential};
    const MillingConditions mill = spectrum();
    const ImpactRates rate = k.rates(mill);
    constexpr int steps = 4000;
    constexpr double time = 60, dt = time / steps;
    double a = 1, b = 0;
    for (int i = 0; i < steps; ++i) {  // Runge-Kutta of fourth order
      const auto slope = [&](double x, double y) {
        return std::array{-rate.first * x, rate.first * x - rate.second * y};
      };
      const auto p = slope(a, b), q = slope(a + dt / 2 * p[0], b + dt / 2 * p[1]),
                 r = slope(a + dt / 2 * q[0], b + dt / 2 * q[1]),
                 s = slope(a + dt * r[0], b + dt * r[1]);
      a += dt / 6 * (p[0] + 2 * q[0] + 2 * r[0] + s[0]);
      b += dt / 6 * (p[1] + 2 * q[1] + 2 * r[1] + s[1]);
    }
    states("intermediate", k.shares(mill, time).product, b, 1e-11, "Runge-Kutta");
  }
}

TEST(ImpactKinetics, share_processed_several_times_is_the_rest_of_the_series) {
  for (const int needed : {1, 2, 3, 7})
    for (const double mean : {0.01, 0.5, 3.0, 20.0}) {
      double term = std::exp(-mean), below = 0;
      for (int i = 0; i < needed; ++i, term *= mean / i) below += term;
      states("share", share_processed(mean, needed), 1 - below, 2e-15,
             "1 - sum of mean^i/i! exp(-mean)");
    }
  states("few hits, cancellation-free", share_processed(1e-4, 3), 1e-12 / 6 * (1 - 0.75e-4), 1e-20,
         "mean^3/6 (1 - 3/4 mean)");
  // The median of a Poisson law that needs n hits is n - 1/3 (Choi 1994), and the share grows.
  for (const std::int64_t needed : {10, 100, 1000})
    states("half", share_processed(double(needed) - 1.0 / 3, needed), 0.5, 0.02 / double(needed),
           "median of the gamma distribution");
  EXPECT_EQ(share_processed(1e9, 1000), 1);
  EXPECT_EQ(share_processed(0, 5), 0);
}

TEST(ImpactKinetics, without_threshold_and_with_exponent_one_is_first_order_in_the_dose) {
  MillingConditions mill = spectrum();
  double power = 0;
  for (PowderHits& hit : mill.hits) {
    hit.mass = 1e-9;  // k far below 1: its square is negligible
    power += hit.rate * hit.energy;
  }
  mill.dose_rate = power / mill.powder_mass;
  const ImpactKinetics k{.processed_share = 0.5, .energy_exponent = 1, .reference_energy = 0.02};
  const DoseKinetics dose{.dose_constant = 0.02 / (0.5 * 1e-9)};
  for (const double time : {1e3, 1e5, 1e6})
    states("conversion", k.shares(mill, time).conversion, dose.shares(mill, time).conversion,
           1e-6 * dose.shares(mill, time).conversion, "1 - exp(-D/D_0), D_0 = E_r/(kappa m_c)");
}

TEST(ImpactKinetics, threshold_above_all_hits_converts_nothing) {
  const ImpactKinetics k{.processed_share = 1, .threshold_energy = 1};
  EXPECT_EQ(k.rates(spectrum()).hits, 0);
  EXPECT_EQ(k.shares(spectrum(), 1e6).conversion, 0);
}

/// A small mill that warms up: cycles of ten minutes and pauses of five.
PowderTemperature warming(double pause) {
  return {.from_heat = true,
          .constant = 0,
          .nodes = {.balls_capacity = 31, .jar_capacity = 150, .exchange = 0.18, .cooling = 0.13},
          .cycles = {.power = 9,
                     .share = 0.5,
                     .ambient = 293.15,
                     .milling = 600,
                     .pause = pause,
                     .cycles = 3},
          .node = PowderTemperature::Node::balls};
}

TEST(ThermalKinetics, constant_temperature_has_the_closed_form) {
  MillingConditions mill;
  mill.temperature.constant = 350;
  const ThermalKinetics k{.frequency_factor = 1e9, .activation_energy = 9e4};
  const double rate = 1e9 * std::exp(-9e4 / (8.31446261815324 * 350));
  states("conversion", k.shares(mill, 3600).conversion, -std::expm1(-rate * 3600), 1e-13,
         "1 - exp(-k t)");
  const ThermalKinetics stressed{
      .frequency_factor = 1e9, .activation_energy = 9e4, .activation_volume = 1e-5, .stress = 1e9};
  states("rate under stress over rate", stressed.rate_constant(mill, 350, true) / rate,
         std::exp(1e4 / (8.31446261815324 * 350)), 1e-11, "exp(sigma V/(R T))");
  EXPECT_EQ(stressed.rate_constant(mill, 350, false), k.rate_constant(mill, 350, false))
      << "no stress in pauses";
}

TEST(ThermalKinetics, impacts_set_the_frequency_factor_and_temperature_the_exponential) {
  // What the title of Andersen and Mack 2017 says: both halves of the law change apart.
  MillingConditions slow = spectrum(), fast = spectrum();
  slow.temperature.constant = fast.temperature.constant = 320;
  fast.impact_rate = 3 * slow.impact_rate;
  const ThermalKinetics k{.factor_per_impact = 1e6,
                          .activation_energy = 6e4,
                          .attempts = ThermalKinetics::Attempts::by_impact};
  states("rate by three times the impacts", k.rate_constant(fast, 320, true),
         3 * k.rate_constant(slow, 320, true), 1e-15, "proportional");
  states("slope of log rate over 1/T times -R",
         -8.31446261815324 *
             std::log(k.rate_constant(slow, 360, true) / k.rate_constant(slow, 320, true)) /
             (1 / 360.0 - 1 / 320.0),
         6e4, 1e-6, "activation energy, whatever the impacts");
}

TEST(ThermalKinetics, follows_a_temperature_history_with_pauses) {
  for (const double pause : {0.0, 300.0}) {
    MillingConditions mill;
    mill.temperature = warming(pause);
    const ThermalKinetics k{.frequency_factor = 3e9, .activation_energy = 9e4};
    // Trapezoids over the history of the thermal model, ten minutes at a time.
    const auto rate = [&](double t) { return 3e9 * std::exp(-9e4 / (gas_constant * t)); };
    Temperatures now{293.15, 293.15};
    double sum = 0;
    const auto add = [&](double length, const Heating& heat) {
      constexpr int pieces = 20'000;
      const PowderTemperature& t = mill.temperature;
      const Temperatures start = now;
      for (int i = 0; i < pieces; ++i) {
        const double at = length * (i + 0.5) / pieces;
        sum += length / pieces * rate(temperatures_after(t.nodes, heat, 293.15, start, at).balls);
      }
      now = temperatures_after(t.nodes, heat, 293.15, start, length);
    };
    const Heating on = mill.temperature.cycles.heating();
    add(600, on);
    if (pause > 0) add(pause, {});
    add(600, on);
    if (pause > 0) add(pause, {});
    add(200, on);
    // The error of the midpoint rule is h^2/24 times the second derivative: (600/20000)^2/24 over
    // the square of the shorter time constant, 90 s, times E/(R T) squared: 1e-6.
    states("conversion", k.shares(mill, 1400).conversion, -std::expm1(-sum), 1e-7,
           "midpoint rule, 20 000 pieces a phase");
    states("temperature then [K]", mill.temperature.at(1400), now.balls, 1e-9, "hea.4");
  }
}

TEST(ThermalKinetics, quadrature_keeps_nine_digits_of_a_steep_rate) {
  PowderTemperature t = warming(0);
  const auto rate = [](double kelvin, bool) { return std::exp(-2e5 / (gas_constant * kelvin)); };
  double fine = 0;
  constexpr int pieces = 400'000;
  constexpr double time = 36'000;
  for (int i = 0; i < pieces; ++i) {  // Simpson
    const double h = time / pieces, a = i * h;
    fine +=
        h / 6 * (rate(t.at(a), true) + 4 * rate(t.at(a + h / 2), true) + rate(t.at(a + h), true));
  }
  stays_below("relative error", std::abs(t.integral(rate, time) / fine - 1), 1e-9,
              "Simpson, 400 000 pieces");
}

TEST(IgnitionKinetics, dose_gives_the_critical_time) {
  const IgnitionKinetics k{.ignition_dose = 5e4, .converted_share = 0.95};
  MillingConditions mill = spectrum();  // 50 W/kg
  states("ignition [s]", k.ignition_time(mill, 1), 1000, 1e-10, "D_ig m/P");
  EXPECT_EQ(k.shares(mill, 999).conversion, 0);
  EXPECT_EQ(k.shares(mill, 1001).conversion, 0.95);
}

TEST(IgnitionKinetics, temperature_that_milling_lowers_has_the_closed_form) {
  const IgnitionKinetics k{.ignition_temperature = 1100,
                           .milled_temperature = 500,
                           .activation_dose = 2e5,
                           .flash_rise = 250,
                           .trigger = IgnitionKinetics::Trigger::temperature};
  MillingConditions mill = spectrum();
  mill.temperature.constant = 350;
  const double expected = -2e5 * std::log(1 - (1100 - 600.0) / (1100 - 500)) / mill.dose_rate;
  states("ignition [s]", k.ignition_time(mill, 1e5), expected, 1e-8 * expected,
         "-D_a ln(1 - (T_ig - T)/(T_ig - T_m)) m/P");
  EXPECT_TRUE(std::isinf(k.ignition_time(mill, 0.99 * expected)));
  mill.temperature.constant = 200;
  EXPECT_TRUE(std::isinf(k.ignition_time(mill, 1e7))) << "450 K never reach 500 K";
}

TEST(IgnitionKinetics,
     in_a_mill_that_warms_up_the_condition_holds_at_the_time_found_and_not_before) {
  MillingConditions mill = spectrum();
  mill.temperature = warming(300);
  const IgnitionKinetics k{.ignition_temperature = 360,
                           .milled_temperature = 310,
                           .activation_dose = 1e5,
                           .trigger = IgnitionKinetics::Trigger::temperature};
  const double at = k.ignition_time(mill, 1e5);
  ASSERT_TRUE(std::isfinite(at));
  const auto beyond = [&](double time) {
    return mill.temperature.at(time) - k.temperature_after(mill.dose_rate * time);
  };
  states("T - T_ig at ignition [K]", beyond(at), 0, 1e-8, "condition");
  double most = -1e9;
  for (int i = 1; i < 2000; ++i) most = std::max(most, beyond(at * 0.9999 * i / 2000));
  stays_below("T - T_ig before [K]", most, 0, "condition");
}

}  // namespace
}  // namespace mahlwerk::powder::kinetics_test
