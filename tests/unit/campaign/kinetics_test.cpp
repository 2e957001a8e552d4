// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// From the collisions of a run to the conversion of its powder, and back to the constants.
#include "mahlwerk/results/quantities/kinetics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/campaign/fit/fit.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/powder/models.hpp"
#include "mahlwerk/results/notices/warnings.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"
#include "statement.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::kinetics_test {
namespace {

using cases::sample::catalogue;
using results::Outcome;
using tests::states;

/// A vial with one ball and 0.15 g of powder.
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
time = "4 s"
replicates = 1
[powder]
mass = "0.15 g"
density = "1280 kg/m3"
size = "0.1 mm"
)";
const std::string by_impact = R"([kinetics]
model = "by-impact"
time = "600 s"
)";

cases::Case read(const std::string& text) {
  return cases::read_text(text, "case.toml", catalogue());
}
Outcome ran(const std::string& text) {
  return run(read(text));
}
double quantity(const Outcome& o, std::string_view name) {
  for (const results::Quantity& q : results::summarise(o).quantities)
    if (q.name == name) return q.value;
  ADD_FAILURE() << "no quantity " << name;
  return 0;
}
bool warns(const Outcome& o, std::string_view code) {
  const Notices list = results::kinetics_warnings(o);
  return std::ranges::any_of(list, [&](const Notice& n) { return n.code == code; });
}

TEST(Kinetics, by_impact_without_threshold_is_first_order_in_the_energy_of_collisions) {
  const Outcome o =
      ran(mill + by_impact +
          "processed_share = 0.5\nenergy_exponent = 1\nreference_energy = \"1 J\"\n"
          "mass_per_hit = \"0.1 mg\"\nenergy = \"lost\"\nmolar_mass = \"60 g/mol\"\n");
  const double power = quantity(o, "dissipated_power_of_collisions");
  // k of a hit is at most 0.5 x 0.1/150 x E/1 J, 1e-5 for the hits of this vial.
  const double expected = -std::expm1(-0.5 * 1e-7 / 0.15e-3 * power * 600);
  states("conversion", quantity(o, "conversion"), expected, 1e-4 * expected,
         "1 - exp(-kappa m_c E/(m E_r))");
  states("processing rate [1/s]", quantity(o, "processing_rate"), 0.5 * 1e-7 / 0.15e-3 * power,
         1e-4 * quantity(o, "processing_rate"), "kappa m_c P/(m E_r)");
  states("dose [kJ/mol]", quantity(o, "milling_dose_per_mole"), quantity(o, "milling_dose") * 0.06,
         1e-9 * quantity(o, "milling_dose"), "J/g times 60 g/mol");
  const results::Table table = results::conversion(o);
  states("last row of conversion.csv", table.rows.back()[2], quantity(o, "conversion"), 1e-15,
         "summary");
}

TEST(Kinetics, by_impact_with_capture_takes_the_mass_that_hits_capture) {
  const std::string capture = "[capture]\nmodel = \"fixed\"\nmass = \"0.1 mg\"\n";
  const std::string constants = "processed_share = 0.3\nthreshold_energy = \"1 mJ\"\n";
  const Outcome captured = ran(mill + capture + by_impact + constants);
  const Outcome given = ran(mill + by_impact + constants + "mass_per_hit = \"0.1 mg\"\n");
  states("conversion", quantity(captured, "conversion"), quantity(given, "conversion"), 1e-12,
         "the same mass per hit");
  states("mass per hit [kg]", quantity(captured, "processed_mass_per_hit"), 0.3e-7, 1e-18,
         "kappa m_c");
  EXPECT_GE(quantity(captured, "processing_hit_energy"), 1e-3);
}

TEST(Kinetics, threshold_above_every_hit_converts_nothing_and_says_so) {
  const std::string constants = "processed_share = 0.3\nmass_per_hit = \"0.1 mg\"\n";
  const Outcome cold = ran(mill + by_impact + constants + "threshold_energy = \"1 kJ\"\n");
  EXPECT_EQ(quantity(cold, "conversion"), 0);
  EXPECT_TRUE(warns(cold, "no-hit-above-threshold"));
  const Outcome warm = ran(mill + by_impact + constants + "threshold_energy = \"1 uJ\"\n");
  EXPECT_GT(quantity(warm, "conversion"), 0);
  EXPECT_FALSE(warns(warm, "no-hit-above-threshold"));
}

TEST(Kinetics, ignition_is_where_the_dose_is_critical_and_said_if_it_is_not_reached) {
  const std::string text = mill + "[kinetics]\nmodel = \"ignition\"\ntime = \"600 s\"\n";
  const Outcome o = ran(text + "ignition_dose = \"1 J/kg\"\n");
  const double rate = quantity(o, "milling_dose") * 1000 / 600;  // [W/kg]
  states("ignition [s]", quantity(o, "ignition_time"), 1 / rate, 1e-9 / rate, "D_ig m/P");
  EXPECT_EQ(quantity(o, "conversion"), 1);
  EXPECT_FALSE(warns(o, "no-ignition"));
  const Outcome none = ran(text + "ignition_dose = \"1e12 J/kg\"\n");
  EXPECT_EQ(quantity(none, "conversion"), 0);
  EXPECT_TRUE(warns(none, "no-ignition"));
}

TEST(Kinetics, temperature_of_heat_drives_a_thermal_reaction) {
  const Outcome o = ran(mill +
                        "[heat]\nmilling = \"600 s\"\n[kinetics]\nmodel = \"thermal\"\n"
                        "frequency_factor = \"1e9 1/s\"\nactivation_energy = \"80 kJ/mol\"\n");
  const results::Table table = results::conversion(o);
  states("temperature at the end [degC]", table.rows.back()[3] - 273.15,
         quantity(o, "temperature_balls"), 1e-6, "[heat]");
  EXPECT_GT(quantity(o, "conversion"), 0);
}

/// Fits the constants in `open` to what the case predicts with its own constants, at the times and
/// conditions of `data` (its measured values are replaced); the fit starts from other constants.
Fit fit_back(const std::string& text, Measurements data) {
  const cases::Case c = read(text);
  std::vector<Outcome> mills;
  for (const auto& set : data.conditions)
    mills.push_back(run(cases::read_text(text, "case.toml", catalogue(), set)));
  const std::vector<FreeParameter> open = free_parameters(c);
  std::vector<double> truth;
  for (const FreeParameter& p : open) truth.push_back(cases::fit_parameter_value(c, p.name));
  const std::vector<double> exact = Predictor(mills, open, data.values, 1)(truth);
  for (std::size_t i = 0; i < exact.size(); ++i) data.values[i].value = exact[i];
  Fit found = fit(mills, data, open, {});
  for (std::size_t i = 0; i < open.size(); ++i)
    states(open[i].name, found.result.parameters[i].value, truth[i], 1e-3 * truth[i],
           "constant that made the data");
  return found;
}

/// As fit_back, with placeholders of measured values.
void recovers(const std::string& text, const std::string& csv) {
  fit_back(text, read_measurements_text(csv, "data.csv"));
}

TEST(KineticsFit, finds_processed_share_and_threshold_again) {
  // One setting of the mill determines their product alone; three frequencies determine both. The
  // bins of the spectrum make the threshold a step function of the data, which the exponent
  // smooths.
  recovers(mill + by_impact +
               "processed_share = 0.3\nthreshold_energy = \"2 mJ\"\nenergy_exponent = 1\n"
               "reference_energy = \"10 mJ\"\nmass_per_hit = \"0.1 mg\"\n[fit]\n"
               "\"kinetics.processed_share\" = [0.01, 1]\n"
               "\"kinetics.threshold_energy\" = [\"0.1 mJ\", \"20 mJ\"]\n",
           "mill.frequency (Hz),time (s),conversion\n14,60,0.5\n14,300,0.5\n19,60,0.5\n19,300,0.5\n"
           "25,60,0.5\n25,300,0.5\n");
}

TEST(KineticsFit, finds_both_shares_of_a_sequence_again_from_two_products) {
  recovers(mill + by_impact +
               "scheme = \"sequential\"\nprocessed_share = 0.3\nsecond_share = 0.05\n"
               "mass_per_hit = \"0.1 mg\"\n[fit]\n\"kinetics.processed_share\" = [0.01, 1]\n"
               "\"kinetics.second_share\" = [0.001, 1]\n",
           "time (s),yield,second_yield\n10,0.5,0.5\n30,0.5,0.5\n60,0.5,0.5\n120,0.5,0.5\n");
}

TEST(KineticsFit, finds_the_barrier_and_the_frequency_factor_again) {
  recovers(mill +
               "[kinetics]\nmodel = \"thermal\"\ntime = \"1 h\"\ntemperature = \"60 degC\"\n"
               "frequency_factor = \"1e9 1/s\"\nactivation_energy = \"85 kJ/mol\"\n[fit]\n"
               "\"kinetics.frequency_factor\" = [\"1e3 1/s\", \"1e13 1/s\"]\n"
               "\"kinetics.activation_energy\" = [\"40 kJ/mol\", \"120 kJ/mol\"]\n",
           "kinetics.temperature (degC),time (h),conversion\n40,1,0.5\n60,1,0.5\n80,1,0.5\n"
           "60,4,0.5\n");
}

TEST(KineticsFit, of_an_ignition_dose_has_the_closed_form) {
  const std::string text = mill +
                           "[kinetics]\nmodel = \"ignition\"\ntime = \"1 h\"\n"
                           "ignition_dose = \"1 kJ/g\"\n[fit]\n"
                           "\"kinetics.ignition_dose\" = [\"1 J/g\", \"1e4 kJ/g\"]\n";
  const std::vector<Outcome> mills{ran(text)};
  const Measurements all =
      read_measurements_text("ignition_time (min),ignition_time_error (min)\n42,1\n", "data.csv");
  const Fit found = fit(mills, all, free_parameters(mills[0].mill_case), {});
  const double rate = quantity(mills[0], "milling_dose") * 1000 / 3600;
  states("D_ig [J/kg]", found.result.parameters[0].value, rate * 42 * 60, 1e-6 * rate * 2520,
         "P t/m");
}

TEST(KineticsFit, names_what_the_model_does_not_predict) {
  const auto fault = [](const std::string& csv) {
    const cases::Case c =
        read(mill + by_impact + "processed_share = 0.3\nmass_per_hit = \"1 mg\"\n");
    for (const Fault& f : fit_faults(c, read_measurements_text(csv, "data.csv"),
                                     {{.name = "kinetics.processed_share"}}, "data.csv"))
      return f.what;
    return std::string();
  };
  EXPECT_EQ(fault("yield\n0.5\n"), "");
  EXPECT_EQ(fault("second_yield\n0.5\n"),
            "second_yield was measured, but [kinetics] does not predict it");
  EXPECT_EQ(fault("ignition_time (s)\n5\n"),
            "ignition_time was measured, but [kinetics] does not predict it");
}

}  // namespace
}  // namespace mahlwerk::campaign::kinetics_test
