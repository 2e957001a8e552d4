// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Sensors that the case cannot serve, and records that are too long.
#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults/faults.hpp"
#include "mahlwerk/geometry/shapes.hpp"

namespace mahlwerk::cases {
namespace {

constexpr double most_readings = 1e5, most_samples = 2e5;

void wrong_interval(const Case& c, const PowerMeter& meter, std::vector<Fault>& found) {
  const double count = c.run.time / meter.interval;
  if (count < 1 - 1e-9)
    found.push_back({location_of(c, "power_meter.interval"),
                     fmt::format("an interval of {} is longer than the run ({}): the meter would "
                                 "make no reading",
                                 show_rounded(meter.interval, "s"), show_rounded(c.run.time, "s")),
                     "give a shorter interval, or a longer run.time", "too-few-readings"});
  if (!(meter.interval > 0) || !(count > most_readings)) return;
  found.push_back({location_of(c, "power_meter.interval"),
                   fmt::format("a reading every {} makes {:.2g} readings, more than {:.0g}",
                               show_rounded(meter.interval, "s"), count, most_readings),
                   fmt::format("write interval = \"{}\" or more",
                               show_rounded(1.05 * c.run.time / most_readings, "s")),
                   "too-many-readings"});
}

void slow_or_long_record(const Case& c, const Accelerometer& sensor, std::vector<Fault>& found) {
  if (!(sensor.sample_rate > 0) || !(sensor.bandwidth > 0) || !(sensor.duration > 0)) return;
  if (sensor.sample_rate < 2 * sensor.bandwidth)
    found.push_back({location_of(c, "accelerometer.sample_rate"),
                     fmt::format("{} samples per second cannot show the bandwidth of {}: two "
                                 "samples per period are needed",
                                 show(sensor.sample_rate, ""), show(sensor.bandwidth, "Hz")),
                     "give a higher sample_rate or a smaller bandwidth", "slow-sampling"});
  const double count = sensor.duration * sensor.sample_rate;
  const double within_run = std::min(sensor.duration, c.run.time) * sensor.sample_rate;
  if (within_run < 2)
    found.push_back({location_of(c, "accelerometer.sample_rate"),
                     fmt::format("the record has fewer than two samples: it lasts {}",
                                 show_rounded(std::min(sensor.duration, c.run.time), "s")),
                     "give a higher sample_rate, or a longer duration and run.time",
                     "too-few-readings"});
  if (count > most_samples)
    found.push_back(
        {location_of(c, "accelerometer.duration"),
         fmt::format("the record has {:.2g} samples, more than {:.0g}", count, most_samples),
         fmt::format("write duration = \"{}\" or less, or a smaller sample_rate",
                     show_rounded(0.95 * most_samples / sensor.sample_rate, "s")),
         "too-many-readings"});
}

}  // namespace

void bad_sensors(const Case& c, std::vector<Fault>& found) {
  if (c.sensors.power_meter) wrong_interval(c, *c.sensors.power_meter, found);
  if (c.sensors.accelerometer) slow_or_long_record(c, *c.sensors.accelerometer, found);
  if (c.sensors.thermocouple && !c.heat)
    found.push_back({location_of(c, "thermocouple.lag"),
                     "a thermocouple needs the temperatures of [heat]",
                     "add [heat], which may be empty, or remove [thermocouple]", "no-temperature"});
  if (c.sensors.accelerometer && geometry::as<geometry::PeriodicBox>(*c.jar.shape) != nullptr)
    found.push_back({location_of(c, "accelerometer.axis"),
                     "a periodic box has no wall that could carry an accelerometer",
                     "remove [accelerometer], or take a jar with walls", "periodic-box"});
}

}  // namespace mahlwerk::cases
