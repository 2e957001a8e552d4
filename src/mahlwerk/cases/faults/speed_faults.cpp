// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Mills that cannot have a speed over time, and runs that it does not fit.
#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/faults/inconsistencies.hpp"
#include "mahlwerk/cases/wall_faces.hpp"
#include "mahlwerk/geometry/any_shape.hpp"
#include "mahlwerk/kinematics/still.hpp"
#include "mahlwerk/kinematics/tabulated.hpp"

namespace mahlwerk::cases {
namespace {

/// Why the mill has no speed that could change; empty if it has one.
std::string without_speed(const Case& c) {
  const kinematics::AnyMotion& mill = *c.mill.motion;
  if (kinematics::as<kinematics::Still>(mill) != nullptr &&
      geometry::rotor_tip_speed(*c.jar.shape) + part_speed(c) == 0)
    return "a jar that stands still has no speed";
  if (kinematics::as<kinematics::Tabulated>(mill) != nullptr)
    return "a measured motion runs as it was measured";
  return "";
}

}  // namespace

void bad_ramp(const Case& c, std::vector<Fault>& found) {
  if (c.run.start != StartLayout::ramp) return;
  const auto fault = [&](const char* key, std::string what, std::string remedy) {
    found.push_back({location_of(c, key), std::move(what), std::move(remedy), "bad-ramp"});
  };
  if (const std::string why = without_speed(c); !why.empty())
    fault("run.start", "start = \"ramp\": " + why, "remove start");
  if (c.run.settle && *c.run.settle < c.run.ramp_time)
    fault(
        "run.settle",
        fmt::format("counting would begin after {}, while the mill comes to its speed, which takes "
                    "{}",
                    show_rounded(*c.run.settle, "s"), show_rounded(c.run.ramp_time, "s")),
        "write settle = \"auto\", or a time that is not shorter than ramp_time");
}

void bad_speed_over_time(const Case& c, std::vector<Fault>& found) {
  const kinematics::SpeedProgram& program = c.mill.speed_over_time;
  if (program.empty()) return;
  const auto fault = [&](const std::string& where, std::string what, std::string remedy) {
    found.push_back(
        {location_of(c, where), std::move(what), std::move(remedy), "bad-speed-over-time"});
  };
  const std::string key = "mill.speed_over_time";
  if (const std::string why = without_speed(c); !why.empty())
    fault(key, "speed_over_time: " + why, "remove speed_over_time");
  if (std::ranges::all_of(program.rows(), [](const auto& row) { return row.rate <= 0; }))
    fault(key, "speed_over_time never turns the mill in the sense of its speed",
          "give shares above 0, and a negative speed for the other sense");
  if (c.run.start == StartLayout::ramp)
    fault("run.start", "start = \"ramp\" and speed_over_time both give the speed at the start",
          "remove start: the first rows of speed_over_time are the start");
  if (c.milling && c.milling->reverse && program.reverses())
    fault("milling.reverse", "`reverse` and speed_over_time both reverse the mill",
          "remove `reverse`, or give one cycle of it as speed_over_time");
  if (c.run.until)
    fault("run.time", "time = \"until ...\" needs a mill whose speed is constant", "give a time");
  if (!c.run.settle && (program.repeats() || program.last_rate() == 0))
    fault("run.settle",
          "settle = \"auto\" waits for a mill that runs at one speed, and speed_over_time does not "
          "end with one",
          "write settle = \"0 s\" to count from the start, or the time from which to count");
}

}  // namespace mahlwerk::cases
