// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/derived.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/planetary.hpp"
#include "mahlwerk/kinematics/still.hpp"
#include "mahlwerk/kinematics/tumbling.hpp"

namespace mahlwerk::cases {

double jar_volume(const Jar& jar) {
  return geometry::volume(*jar.shape);
}

double ball_volume(const BallSet& set) {
  return std::numbers::pi * set.diameter * set.diameter * set.diameter / 6;
}

double balls_mass(const std::vector<BallSet>& balls) {
  double mass = 0;
  for (const BallSet& set : balls)
    if (!set.grains) mass += static_cast<double>(set.count) * set.mass();
  return mass;
}

double balls_volume(const std::vector<BallSet>& balls) {
  double volume = 0;
  for (const BallSet& set : balls)
    if (!set.grains) volume += static_cast<double>(set.count) * ball_volume(set);
  return volume;
}

double bulk_filling(const std::vector<BallSet>& balls, const Jar& jar) {
  return balls_volume(balls) / ((1 - bed_porosity) * jar_volume(jar));
}

std::optional<double> void_filling(const Case& c) {
  if (!c.powder || !c.powder->density) return std::nullopt;
  const double bulk = c.powder->mass / (*c.powder->density * (1 - bed_porosity));
  return bulk / (bed_porosity * bulk_filling(c.balls, c.jar) * jar_volume(c.jar));
}

double bulk_density(const std::vector<BallSet>& balls) {
  return balls_mass(balls) * (1 - bed_porosity) / balls_volume(balls);
}

std::int64_t balls_count(const std::vector<BallSet>& balls) {
  std::int64_t count = 0;
  for (const BallSet& set : balls) count += set.count;
  return count;
}

bool has_bodies(const Case& c) {
  return std::ranges::any_of(c.balls, [](const BallSet& set) { return !set.body.is_sphere(); });
}

std::vector<bool> sets_with_axis(const Case& c) {
  std::vector<bool> sets;
  for (const BallSet& set : c.balls) sets.push_back(scene::has_axis(set.body.solid_kind()));
  return std::ranges::find(sets, true) == sets.end() ? std::vector<bool>() : sets;
}

double largest_ball(const std::vector<BallSet>& balls) {
  double diameter = 0;
  for (const BallSet& set : balls) {
    if (std::isnan(set.diameter)) return set.diameter;
    for (const SizeClass& size : set.sizes())
      if (size.diameter > 0)  // keys are listed for balls without a size
        diameter = std::max(diameter, set.reach() * size.diameter);
  }
  return diameter;
}

double smallest_ball(const std::vector<BallSet>& balls) {
  double diameter = std::numeric_limits<double>::infinity();
  for (const BallSet& set : balls) {
    if (set.grains) continue;
    for (const SizeClass& size : set.sizes()) diameter = std::min(diameter, size.diameter);
  }
  return diameter;
}

std::optional<double> shaft_speed(const Case& c) {
  if (const auto* drum = kinematics::as<kinematics::Tumbling>(*c.mill.motion))
    return drum->speed != 0 ? std::optional(std::abs(drum->speed)) : std::nullopt;
  if (const auto* planetary = kinematics::as<kinematics::Planetary>(*c.mill.motion))
    return std::abs(planetary->speed);
  const auto* vessel = std::get_if<geometry::Attritor>(&*c.jar.shape);
  const bool at_rest = kinematics::as<kinematics::Still>(*c.mill.motion) != nullptr;
  if (at_rest && vessel != nullptr && vessel->rotor_speed != 0)
    return std::abs(vessel->rotor_speed);
  return std::nullopt;
}

kinematics::SpeedProgram speed_program(const Case& c) {
  if (c.run.start != StartLayout::ramp) return c.mill.speed_over_time;
  return kinematics::SpeedProgram::ramp(c.run.ramp_time);
}

bool speed_varies(const Case& c) {
  return c.drive.has_value() || !c.mill.speed_over_time.empty();
}

namespace {

/// Whether two turning parts are on one shaft: the same line in the same frame, turned the same way
/// at the same speed. Torques about other lines do not add up.
bool same_shaft(const scene::MachinePart& a, const scene::MachinePart& b) {
  constexpr double close = 1e-9;  // [m] and [1]
  return a.in_laboratory == b.in_laboratory && a.motion.speed == b.motion.speed &&
         norm(a.motion.axis - b.motion.axis) < close &&
         norm(cross(a.motion.pivot - b.motion.pivot, a.motion.axis)) < close;
}

}  // namespace

const MachinePart* shaft_part(const Case& c) {
  const MachinePart* first = nullptr;
  for (const MachinePart& part : c.machine_parts) {
    if (!part.body.motion.turns()) continue;
    if (first != nullptr && !same_shaft(first->body, part.body)) return nullptr;
    if (first == nullptr) first = &part;
  }
  return first;
}

double speed_without_load(const Case& c) {
  if (const auto* drum = drum_motion(c)) return drum->speed;
  if (kinematics::as<kinematics::Still>(*c.mill.motion) == nullptr) return 0;
  const auto* vessel = std::get_if<geometry::Attritor>(&*c.jar.shape);
  if (vessel != nullptr) return vessel->rotor_speed;
  const MachinePart* shaft = shaft_part(c);
  return shaft != nullptr ? shaft->body.motion.speed : 0;
}

const kinematics::Tumbling* drum_motion(const Case& c) {
  const bool about_own_axis = c.mill.jar_axis == kinematics::Tumbling::jar_axis;
  return about_own_axis ? kinematics::as<kinematics::Tumbling>(*c.mill.motion) : nullptr;
}

}  // namespace mahlwerk::cases
