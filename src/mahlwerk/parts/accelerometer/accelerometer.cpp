// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/accelerometer/accelerometer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/file/key_visitor.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/wear_heat.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/parts/accelerometer/impact_record.hpp"
#include "mahlwerk/report/columns.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/wall.hpp"

namespace mahlwerk::parts::accelerometer {
namespace {

using cases::Case;
using results::Outcome;
using results::Replicate;
using results::Table;

void describe(cases::KeyVisitor& v, Accelerometer& sensor, const Case&) {
  v.word({"axis",
          {"x", "y", "z"},
          "z",
          "the jar's axis",
          "direction that is measured, in the jar's own axes",
          {"across the jar's axis", "across it and x", "along the jar's axis"}},
         sensor.axis);
  v.optional_number(cases::NumberSpec("mass", "kg", {.least = 1e-6, .most = 1e6},
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

const Accelerometer& sensor_of(const Case& c) {
  return *c.parts.find<Accelerometer>();
}

void slow_or_long_record(const Case& c, const Accelerometer& sensor, std::vector<Fault>& found) {
  constexpr double most_samples = 2e5;
  if (!(sensor.sample_rate > 0) || !(sensor.bandwidth > 0) || !(sensor.duration > 0)) return;
  if (sensor.sample_rate < 2 * sensor.bandwidth)
    found.push_back({cases::location_of(c, "accelerometer.sample_rate"),
                     fmt::format("{} samples per second cannot show the bandwidth of {}: two "
                                 "samples per period are needed",
                                 show(sensor.sample_rate, ""), show(sensor.bandwidth, "Hz")),
                     "give a higher sample_rate or a smaller bandwidth", "slow-sampling"});
  const double count = sensor.duration * sensor.sample_rate;
  const double within_run = std::min(sensor.duration, c.run.time) * sensor.sample_rate;
  if (within_run < 2)
    found.push_back({cases::location_of(c, "accelerometer.sample_rate"),
                     fmt::format("the record has fewer than two samples: it lasts {}",
                                 show_rounded(std::min(sensor.duration, c.run.time), "s")),
                     "give a higher sample_rate, or a longer duration and run.time",
                     "too-few-readings"});
  if (count > most_samples)
    found.push_back(
        {cases::location_of(c, "accelerometer.duration"),
         fmt::format("the record has {:.2g} samples, more than {:.0g}", count, most_samples),
         fmt::format("write duration = \"{}\" or less, or a smaller sample_rate",
                     show_rounded(0.95 * most_samples / sensor.sample_rate, "s")),
         "too-many-readings"});
}

void check(const Case& c, std::vector<Fault>& found) {
  slow_or_long_record(c, sensor_of(c), found);
  if (geometry::as<geometry::PeriodicBox>(*c.jar.shape) != nullptr)
    found.push_back({cases::location_of(c, "accelerometer.axis"),
                     "a periodic box has no wall that could carry an accelerometer",
                     "remove [accelerometer], or take a jar with walls", "periodic-box"});
}

std::unique_ptr<observe::Recorder> recorder(const Case& c) {
  // Intervals of the record in each sample: they follow the sensor's response closely.
  constexpr double finer = 4;
  const Accelerometer& sensor = sensor_of(c);
  using Axis = Accelerometer::Axis;
  const Vec3 axis = sensor.axis == Axis::x   ? Vec3{1, 0, 0}
                    : sensor.axis == Axis::y ? Vec3{0, 1, 0}
                                             : Vec3{0, 0, 1};
  const double duration = std::min(sensor.duration, c.run.time);
  const double count = std::max(1.0, std::round(duration * sensor.sample_rate));
  return std::make_unique<ImpactRecord>(axis, c.run.settle.value_or(0),
                                        1 / (finer * sensor.sample_rate),
                                        static_cast<std::size_t>(finer * count));
}

const ImpactRecord& record_of(const Replicate& r) {
  return *r.recorders.find<ImpactRecord>();
}

/// [kg] The mass that impacts accelerate.
double moved_mass(const Case& c) {
  const auto& given = sensor_of(c).mass;
  return given ? *given : cases::jar_mass(c, results::wall_area(*c.jar.shape));
}

/// [m/s2] What the sensor shows at the end of each interval of its record, without gravity: by the
/// motion of the jar's centre and by impacts (sns.5).
struct AccelerationSignal {
  std::vector<double> of_motion, of_impacts;
};

AccelerationSignal signal_of(const Case& c, const Replicate& r) {
  const ImpactRecord& record = record_of(r);
  const scene::Chamber mill = cases::chamber(c);
  const double mass = moved_mass(c), bandwidth = sensor_of(c).bandwidth;
  std::vector<double> motion, impacts;
  for (std::size_t i = 0; i < record.impulses().size(); ++i) {
    const double t = record.begin() + record.step() * (static_cast<double>(i) + 0.5);
    if (t - record.begin() > r.time()) break;  // of a run that was stopped
    const Vec3 axis = kinematics::rotation(*mill.motion, t) * (mill.mount * record.axis());
    motion.push_back(dot(kinematics::frame_motion(*mill.motion, t).acceleration, axis));
    impacts.push_back(record.impulses()[i] / (record.step() * mass));
  }
  const double start = motion.empty() ? 0 : motion.front();
  return {low_pass(motion, record.step(), bandwidth, start),
          low_pass(impacts, record.step(), bandwidth, 0)};
}

double root_mean_square(const std::vector<double>& values) {
  double squares = 0;
  for (const double a : values) squares += a * a;
  return std::sqrt(results::share(squares, static_cast<double>(values.size())));
}

std::vector<double> sum_of(const AccelerationSignal& s) {
  std::vector<double> sum = s.of_motion;
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += s.of_impacts[i];
  return sum;
}

results::Measures quantities() {
  const auto present = [](const Case& c) { return c.parts.find<Accelerometer>() != nullptr; };
  return results::where(
      present, "with `[accelerometer]`",
      {{"acceleration_rms",
        "m/s2",
        "root mean square of the accelerometer's signal",
        [](const Case& c, const Replicate& r) { return root_mean_square(sum_of(signal_of(c, r))); },
        {.label = "acceleration, root mean square",
         .equation = "sns.6",
         .heading = "Accelerometer"}},
       {"acceleration_rms_of_impacts",
        "m/s2",
        "part of it by the impacts of balls alone",
        [](const Case& c, const Replicate& r) {
          return root_mean_square(signal_of(c, r).of_impacts);
        },
        {.label = "acceleration by impacts, root mean square"}},
       {"acceleration_peak",
        "m/s2",
        "largest absolute value of the signal",
        [](const Case& c, const Replicate& r) {
          double largest = results::undefined;
          for (const double a : sum_of(signal_of(c, r))) largest = std::fmax(largest, std::abs(a));
          return largest;
        },
        {.label = "peak acceleration"}}});
}

/// A row for each sample of one run, as a sensor sees one run.
Table acceleration(const Outcome& outcome) {
  Table table{{{"time", "s", "time of the sample, since counting began"},
               {"acceleration", "m/s2", "signal of the accelerometer, without gravity"},
               {"of_motion", "m/s2", "part of it by the motion of the mill"},
               {"of_impacts", "m/s2", "part of it by impacts of balls on the jar"}},
              {}};
  const Case& c = outcome.mill_case;
  const auto chosen = results::averaged_replicates(outcome);
  if (chosen.empty()) return table;
  const double step = record_of(*chosen.front()).step();
  const auto every = static_cast<std::size_t>(std::lround(1 / (sensor_of(c).sample_rate * step)));
  const AccelerationSignal s = signal_of(c, *chosen.front());
  for (std::size_t i = every; i <= s.of_motion.size(); i += every) {
    const double motion = s.of_motion[i - 1], impacts = s.of_impacts[i - 1];
    table.rows.push_back({static_cast<double>(i) * step, motion + impacts, motion, impacts});
  }
  return table;
}

std::vector<results::NamedTable> tables(const Outcome& outcome) {
  return {{"accelerometer", "samples of the accelerometer", acceleration(outcome)}};
}

void softened_impacts(const Outcome& outcome, Notices& list) {
  const Case& c = outcome.mill_case;
  if (!cases::in_time_steps(outcome.engine)) return;
  if (!(c.contact.softening < 1)) return;
  list.push_back(warning(
      "softened-impacts",
      fmt::format("contact.softening = {} makes contacts longer than real ones: the peaks of the "
                  "accelerometer are too small where a contact lasts longer than 1/bandwidth.",
                  show(c.contact.softening, ""))));
}

/// The record cannot be as long as the case asks for.
void short_record(const Outcome& outcome, Notices& list) {
  const Accelerometer& sensor = sensor_of(outcome.mill_case);
  if (sensor.duration <= outcome.mill_case.run.time) return;
  list.push_back(note("short-record",
                      fmt::format("The record of the accelerometer ends with the run, after {} "
                                  "instead of {}.",
                                  show_rounded(outcome.mill_case.run.time, "s"),
                                  show_rounded(sensor.duration, "s"))));
}

Notices notices(const Outcome& outcome) {
  Notices list;
  short_record(outcome, list);
  softened_impacts(outcome, list);
  return list;
}

report::Plot plot_of(const Outcome& outcome) {
  constexpr std::size_t shown = 4000;  // samples, in which single impacts are still seen
  Table table = acceleration(outcome);
  table.rows.resize(std::min(table.rows.size(), shown));
  constexpr double milli = 1e-3;
  const std::vector<double> time = report::column(table, "time", milli);
  return {
      .title = "Acceleration of the jar",
      .x = report::Axis{.label = "time (ms)", .least = 0},
      .y = report::Axis{.label = "acceleration (m/s²)"},
      .series = {{"signal", time, report::column(table, "acceleration"), {}, report::Mark::line},
                 {"motion of the mill",
                  time,
                  report::column(table, "of_motion"),
                  {},
                  report::Mark::line}},
      .shape = 0.42};
}

std::string panel(const Outcome& outcome) {
  return report::figure(
      plot_of(outcome),
      "The first part of the record of one run: the motion of the mill, and impacts as the sensor "
      "follows them. accelerometer.csv has the whole record.");
}

/// The mass of the jar, if it is not given.
bool needs(const Case& c, std::string_view key) {
  return !sensor_of(c).mass && (key == "jar.wall" || key == "jar.density");
}

}  // namespace

const cases::Part& part() {
  static const cases::Part made{
      .name = "accelerometer",
      .sections = {cases::section_of<Accelerometer, describe>(
          {"accelerometer", "", "acceleration of the jar by motion and impacts; may be empty"})},
      .check = check,
      .needs = needs,
      .recorder = recorder,
      .quantities = quantities,
      .tables = tables,
      .notices = notices,
      .heading = "Sensors",
      .panel = panel};
  return made;
}

}  // namespace mahlwerk::parts::accelerometer
