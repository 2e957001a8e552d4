// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The state of another run as a start: the same balls, and one state for each replicate.
#include <fmt/format.h>

#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/faults/inconsistencies.hpp"

namespace mahlwerk::cases {
namespace {

/// The first difference between the balls of a state and those of the case, as a sentence without
/// its full stop; empty if there is none.
std::string difference(const Case& c, const std::vector<BallState>& state) {
  constexpr double rounding = 1e-9;
  if (std::cmp_not_equal(state.size(), balls_count(c.balls)))
    return fmt::format("the state has {} balls, the case {}", state.size(), balls_count(c.balls));
  const std::vector<scene::Ball> balls = balls_by_set(c.balls);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const scene::Ball& ball = balls[i];
    if (state[i].kind != ball.kind)
      return fmt::format("ball {} of the state is of ball set {}, in the case of {}", i + 1,
                         state[i].kind + 1, ball.kind + 1);
    if (!(std::abs(state[i].radius - ball.radius) <= rounding * ball.radius))
      return fmt::format("ball {} of the state has a diameter of {}, in the case of {}", i + 1,
                         show_rounded(2 * state[i].radius, "m"),
                         show_rounded(2 * ball.radius, "m"));
  }
  return "";
}

}  // namespace

void bad_start_state(const Case& c, std::vector<Fault>& found) {
  const StartStates& start = c.run.start_from;
  if (!start.states) return;
  const auto fault = [&](std::string what, std::string remedy) {
    found.push_back(
        {location_of(c, "run.start_from"), std::move(what), std::move(remedy), "bad-start-state"});
  };
  const auto many = static_cast<std::int64_t>(start.states->size());
  if (c.run.replicates > many)
    fault(start.folder
              ? fmt::format("the folder has {} states for {} replicates", many, c.run.replicates)
              : fmt::format("{} replicates from one state would be the same run", c.run.replicates),
          start.folder
              ? fmt::format("write replicates = {}", many)
              : "write replicates = 1, or give a result folder with a state for each replicate");
  for (std::size_t k = 0; k < start.states->size(); ++k)
    if (std::string what = difference(c, (*start.states)[k]); !what.empty())
      return fault(start.folder ? fmt::format("final-{}.csv: {}", k + 1, what) : what,
                   "give the same [[balls]] and grains as in the run that the state is from");
}

}  // namespace mahlwerk::cases
