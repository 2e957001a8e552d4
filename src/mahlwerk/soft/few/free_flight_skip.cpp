// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/few/solver.hpp"

// Free-flight skip: time in which no contact exists and none can begin is passed in one step
// (dem.27).
namespace mahlwerk::soft {

/// Starts a skip if one is due and long enough to pay off. Its end does not depend on how calls of
/// advance() divide a run.
bool FewBodySolver::start_skip() {
  if (!skips_ || particles_.touched || particles_.step < next_skip_) return false;
  constexpr std::int64_t min_skip = 8;
  // The search grows with the square of the number of balls, a step with the number.
  const std::int64_t retry_after =
      std::max<std::int64_t>(4, static_cast<std::int64_t>(particles_.count) / 8);
  const std::int64_t steps = collision_free_steps();
  if (steps < min_skip) {
    next_skip_ = particles_.step + retry_after;
    return false;
  }
  skip_end_ = particles_.step + steps;
  return true;
}

/// Number of whole steps that end before the next possible contact. For two balls a quadratic
/// equation gives the time: all balls have the same acceleration, so their relative motion is
/// straight.
std::int64_t FewBodySolver::collision_free_steps() const {
  constexpr double max_steps = 1e6;  // steps
  double time = max_steps * settings_.time_step;
  const double now = mill_time(particles_.step);
  if (periodic_) return 0;
  if (liquid_ && liquid_at_wall()) return 0;
  const double reach = liquid_ ? liquid_->gap_reach(pairs_.all()) : 0;
  for (std::size_t i = 0; i < particles_.count; ++i) {
    const Vec3 x = particles_.position(i), v = particles_.velocity(i);
    time = std::min(time, jar_->safe_time(x, v, now, initial_balls_[i].radius + reach));
    for (std::size_t j = i + 1; j < particles_.count; ++j) {
      const Vec3 r = particles_.position(j) - x, u = particles_.velocity(j) - v;
      const double touch = initial_balls_[i].radius + initial_balls_[j].radius + reach;
      if (reach > 0 && squared(r) < touch * touch) return 0;  // the liquid acts
      const double b = dot(r, u), c = squared(r) - touch * touch;
      const double d = b * b - squared(u) * c;
      if (b < 0 && d > 0) time = std::min(time, std::max(c, 0.0) / (std::sqrt(d) - b));
    }
  }
  return static_cast<std::int64_t>(time / settings_.time_step) - 1;
}

FewBodySolver::FreeFlight FewBodySolver::free_flight(std::int64_t steps) const {
  if (steps == 0 || rest_.at_rest) return {};
  const double time = time_of(steps);
  const kinematics::FrameMotion from = jar_->frame_motion(mill_time(particles_.step));
  const kinematics::FrameMotion to = jar_->frame_motion(mill_time(particles_.step + steps));
  const Vec3& g = jar_->gravity();
  return {.shift = time * from.velocity + 0.5 * time * time * g - (to.centre - from.centre),
          .gain = time * g - (to.velocity - from.velocity),
          .time = time};
}

void FewBodySolver::end_skip() {
  const FreeFlight way = free_flight(skip_end_ - particles_.step);
  for (std::size_t b = 0; b < particles_.count; ++b) {
    const Vec3 v = particles_.velocity(b);
    set_lane(particles_.bodies[b / lanes].position, b % lanes,
             particles_.position(b) + way.time * v + way.shift);
    set_lane(particles_.balls[b / lanes].velocity, b % lanes, v + way.gain);
  }
  skipped_steps_ += skip_end_ - particles_.step;
  particles_.step = skip_end_;
  next_skip_ = skip_end_ + 1;
  skip_end_ = -1;
  rebuild_neighbour_list();
}

}  // namespace mahlwerk::soft
