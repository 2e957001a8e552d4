// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The sections of parts.

#include <gtest/gtest.h>

#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/parts/accelerometer/accelerometer.hpp"
#include "mahlwerk/parts/microphone/microphone.hpp"
#include "mahlwerk/parts/power_meter/power_meter.hpp"
#include "mahlwerk/parts/thermocouple/thermocouple.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::parts::sections_test {
namespace {

using namespace cases::sample;
using accelerometer::Accelerometer;
using cases::Case;
using cases::PartValues;
using microphone::Microphone;
using power_meter::PowerMeter;
using thermocouple::Thermocouple;

/// The values of four sensors.
PartValues sensors(const PowerMeter& meter, const Microphone& microphone,
                   const Accelerometer& accelerometer, const Thermocouple& thermocouple) {
  PartValues made;
  made.set(meter);
  made.set(microphone);
  made.set(accelerometer);
  made.set(thermocouple);
  return made;
}

std::string code_of(const std::string& sensors) {
  const auto found = faults_of(vial + sensors);
  return found.size() == 1 ? found[0].code : fault_of(vial + sensors);
}

TEST(ReadSensors, empty_sections_are_sensors_with_defaults) {
  EXPECT_TRUE(read_sample(vial).parts == PartValues());
  const Case c =
      read_sample(vial + "[heat]\n[power_meter]\n[microphone]\n[accelerometer]\n[thermocouple]\n");
  const PartValues expected =
      sensors({.interval = 0.3}, Microphone(), Accelerometer(), Thermocouple());
  EXPECT_TRUE(c.parts == expected);  // the vial runs for 60 s
  EXPECT_EQ(source_of(c, "power_meter.interval"), "default: a 200th of run.time");
}

/// The vial runs for 60 s: a thousand samples are 60 ms apart.
TEST(ReadMixing, an_interval_of_more_than_a_thousand_samples_is_refused) {
  const auto faults = [](const std::string& interval) {
    return faults_of(with(vial, "count", "count = 6") + "[mixing]\ninterval = \"" + interval +
                     "\"\n");
  };
  EXPECT_TRUE(faults("60 ms").empty());
  const std::vector<Fault> found = faults("59 ms");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "too-many-readings");
  EXPECT_EQ(found[0].what, "a sample every 59 ms makes more than 1000 of the mixing");
  EXPECT_EQ(found[0].remedy, "write interval = \"63 ms\" or more, or leave it out");
}

TEST(ReadMixing, a_cell_of_more_balls_than_there_are_is_refused) {
  const auto faults = [](const std::string& cell) {
    return faults_of(with(vial, "count", "count = 6") + "[mixing]\nballs_per_cell = " + cell +
                     "\n");
  };
  EXPECT_TRUE(faults("6").empty());
  const std::vector<Fault> found = faults("7");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "cell-too-large");
  EXPECT_NE(found[0].what.find("balls_per_cell = 7 is more than the 6 balls"), std::string::npos);
}

TEST(ReadSensors, every_key_is_read) {
  const Case c = read_sample(vial + R"([heat]
[power_meter]
interval = "20 ms"
idle_power = "0.1 kW"
efficiency = "80 %"
[microphone]
threshold = "5 mJ"
definition_time = "0.5 ms"
hears = "all"
[accelerometer]
axis = "x"
mass = "800 g"
bandwidth = "5 kHz"
duration = "20 ms"
[thermocouple]
place = "gas"
lag = "1 min"
)");
  const PartValues expected =
      sensors({0.02, 100, 0.8}, {5e-3, 0.5e-3, Microphone::Hears::all},
              {Accelerometer::Axis::x, 0.8, 5e3, 50e3, 0.02}, {Thermocouple::Place::gas, 60});
  EXPECT_TRUE(c.parts == expected);
}

TEST(ReadSensors, says_what_cannot_be) {
  EXPECT_EQ(code_of("[thermocouple]\n"), "no-temperature");
  EXPECT_EQ(code_of("[power_meter]\ninterval = \"0.1 ms\"\n"), "too-many-readings");  // of 60 s
  EXPECT_EQ(code_of("[power_meter]\ninterval = \"0 s\"\n"), "out-of-range");
  EXPECT_EQ(code_of("[power_meter]\nefficiency = 0\n"), "out-of-range");
  EXPECT_EQ(code_of("[power_meter]\nefficiency = 1.1\n"), "out-of-range");
  EXPECT_EQ(code_of("[microphone]\nthreshold = \"-1 J\"\n"), "out-of-range");
  EXPECT_EQ(code_of("[microphone]\nhears = \"nothing\"\n"), "unknown-word");
  EXPECT_EQ(code_of("[accelerometer]\nsample_rate = \"15 kHz\"\n"), "slow-sampling");
  EXPECT_EQ(code_of("[power_meter]\ninterval = \"61 s\"\n"), "too-few-readings");
  EXPECT_EQ(code_of("[accelerometer]\nduration = \"3 s\"\n"), "too-many-readings");
  EXPECT_EQ(code_of("[accelerometer]\nduration = \"10 us\"\n"), "too-few-readings");
  EXPECT_EQ(code_of("[accelerometer]\nbandwidth = \"0.01 Hz\"\n"), "out-of-range");
  EXPECT_EQ(code_of("[accelerometer]\nmass = \"0 kg\"\n"), "out-of-range");
  EXPECT_EQ(code_of("[accelerometer]\naxis = \"up\"\n"), "unknown-word");
  EXPECT_EQ(code_of("[accelerometer]\nrange = \"5 m\"\n"), "unknown-key");
}

TEST(ShaftSpeed, is_that_of_drum_disc_or_stirrer) {
  EXPECT_FALSE(shaft_speed(read_sample(vial)));
  EXPECT_NEAR(*shaft_speed(read_sample(planetary)), 41.8879, 1e-4);  // 400 rpm
  EXPECT_GT(*shaft_speed(read_sample(drum)), 0);
  EXPECT_FALSE(shaft_speed(read_sample(drum, {{"mill.speed", "0 rpm"}})));
}

}  // namespace
}  // namespace mahlwerk::parts::sections_test
