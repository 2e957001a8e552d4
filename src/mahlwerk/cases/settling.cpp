// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/settling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/wall_faces.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/any_motion.hpp"
#include "mahlwerk/kinematics/planetary.hpp"
#include "mahlwerk/kinematics/tumbling.hpp"

namespace mahlwerk::cases {
namespace {

/// A drum, or a jar that tumbles end over end.
bool is_drum(const Case& c) {
  return kinematics::as<kinematics::Tumbling>(*c.mill.motion) != nullptr;
}

/// Parts of a period that are blocks: a turn has eight, a turn of a disc four, an oscillation one.
int blocks_per_period(const Case& c) {
  if (is_drum(c)) return 8;
  return shaft_speed(c) ? 4 : 1;
}

}  // namespace

namespace {

double period_at_full_speed(const Case& c) {
  if (const auto shaft = shaft_speed(c)) return 2 * std::numbers::pi / *shaft;
  const double jar = kinematics::period(*c.mill.motion);
  return std::isfinite(jar) ? jar : part_period(c);
}

/// [s] From then on the mill has its last speed.
double changes_until(const Case& c) {
  return speed_program(c).end();
}

}  // namespace

double mill_period(const Case& c) {
  const kinematics::SpeedProgram& program = c.mill.speed_over_time;
  if (program.repeats()) return program.end();
  return period_at_full_speed(c) / std::abs(program.last_rate());
}

bool settles(const Case& c) {
  const bool given = std::ranges::any_of(
      c.balls, [](const BallSet& set) { return !set.velocities.empty() || !set.spins.empty(); });
  return !c.run.settle && !given && std::isfinite(mill_period(c));
}

SettlingBlocks settling_blocks(const Case& c) {
  constexpr double times = 4;  // of the least, and of the counted time
  SettlingBlocks made{.begin = changes_until(c), .length = mill_period(c) / blocks_per_period(c)};
  const double within_counted = std::min(1e6, times * c.run.time / made.length);
  made.most = std::max(static_cast<int>(times) * SettlingBlocks::least,
                       c.run.until ? 0 : static_cast<int>(within_counted));
  return made;
}

double least_settling(const Case& c) {
  if (!settles(c)) return c.run.settle.value_or(changes_until(c));
  const SettlingBlocks blocks = settling_blocks(c);
  return blocks.begin + SettlingBlocks::least * blocks.length;
}

double counted_time(const Case& c) {
  if (!settles(c) || c.run.until) return c.run.time;
  constexpr double rounding = 1e-9, fewest_turns = 3;
  const double period = mill_period(c);
  double periods = std::ceil(c.run.time / period * (1 - rounding));
  if (is_drum(c)) periods = std::max(periods, fewest_turns);
  const double whole = periods * period;
  return std::abs(whole - c.run.time) <= rounding * whole ? c.run.time : whole;
}

double expected_time(const Case& c) {
  constexpr double share_of_longest = 0.1;
  const auto longest = std::ranges::find(c.origins, "run.longest", &Origin::key);
  const bool given = longest == c.origins.end() || !longest->assumed;
  return c.run.until && !given ? share_of_longest * counted_time(c) : counted_time(c);
}

double simulated_time(const Case& c) {
  return least_settling(c) + counted_time(c);
}

}  // namespace mahlwerk::cases
