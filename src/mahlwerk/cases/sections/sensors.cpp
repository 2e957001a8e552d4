// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [power_meter], [microphone], [accelerometer] and [thermocouple]: sensors that a run imitates.
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {

void describe(KeyVisitor& v, PowerMeter& meter, const Case& c) {
  NumberSpec interval("interval", "s", positive, "time between two readings");
  if (v.reader() == nullptr)
    interval = interval.with_default_text("a 200th of run.time; 0.1 s with \"until\"");
  else if (c.run.until)
    interval = interval.with_default(0.1, "usual of meters");
  else
    interval = interval.with_default(c.run.time / 200, "a 200th of run.time");
  v.number(interval, meter.interval);
  v.number({"idle_power",
            "W",
            {.least = 0, .most = 1e9},
            "power of the motor that turns the mill without balls",
            PowerMeter().idle_power,
            "only the charge takes power"},
           meter.idle_power);
  v.number({"efficiency",
            "",
            {.least = 0.01, .most = 1},
            "power that reaches the charge over what the motor takes for it",
            PowerMeter().efficiency,
            "a drive without losses; measured: 0.7-0.95"},
           meter.efficiency);
}

void describe(KeyVisitor& v, Microphone& microphone) {
  v.number({"threshold", "J", not_negative, "least normal energy of a hit that is heard",
            Microphone().threshold, "every hit is heard"},
           microphone.threshold);
  v.number({"definition_time", "s", not_negative,
            "hits with shorter intervals are heard as one, with the energy of the largest",
            Microphone().definition_time, "the ring of a jar; uncalibrated, 0.1-10 ms"},
           microphone.definition_time);
  v.word({"hears",
          {"jar", "all"},
          "jar",
          "the jar carries the sound to the sensor",
          "which hits are heard",
          {"hits on the jar", "also hits between balls"}},
         microphone.hears);
}

void describe(KeyVisitor& v, Accelerometer& sensor) {
  v.word({"axis",
          {"x", "y", "z"},
          "z",
          "the jar's axis",
          "direction that is measured, in the jar's own axes",
          {"across the jar's axis", "across it and x", "along the jar's axis"}},
         sensor.axis);
  v.optional_number(NumberSpec("mass", "kg", {.least = 1e-6, .most = 1e6},
                               "mass that impacts accelerate: jar, lid and holder")
                        .with_default_text("that of the jar's wall: area, thickness and density"),
                    sensor.mass);
  v.number({"bandwidth",
            "Hz",
            {.least = 0.1, .most = 1e7},
            "frequency up to which the sensor follows, at -3 dB",
            Accelerometer().bandwidth,
            "a piezoelectric sensor of general use"},
           sensor.bandwidth);
  const double usual = 10 * (sensor.bandwidth > 0 ? sensor.bandwidth : 1);
  v.number({"sample_rate", "Hz", positive, "samples per second of the recorder",
            v.visits_all() ? Accelerometer().sample_rate : usual, "ten times the bandwidth"},
           sensor.sample_rate);
  v.number({"duration", "s", positive, "length of the record, from the first counted time",
            Accelerometer().duration, "a few periods of a mill"},
           sensor.duration);
}

void describe(KeyVisitor& v, Thermocouple& sensor) {
  v.word({"place",
          {"wall", "gas", "balls"},
          "wall",
          "a bore in the jar",
          "where the thermocouple is",
          {"in the jar's wall", "in the gas inside the jar", "at the balls"}},
         sensor.place);
  v.number({"lag",
            "s",
            {.least = 0, .most = 1e6},
            "time constant of the reading after a step",
            Thermocouple().lag,
            "a sheath of some millimetres in a bore; uncalibrated, 1-60 s"},
           sensor.lag);
}

}  // namespace mahlwerk::cases
