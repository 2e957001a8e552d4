// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/few/step_block.hpp"
#include "mahlwerk/soft/kernel/force_rows.hpp"

// Motion of the balls of a charge over a step. V is a register.
namespace mahlwerk::soft {

/// Half a kick, a drift, and the velocities predicted for the contacts of this step (velocity
/// Verlet, dem.26). Returns whether a displacement since the last rebuild exceeds the limit.
template <class V>
[[gnu::always_inline]] inline bool half_kick_and_drift(const StepBlock& s, ParticleData& w,
                                                       const DriveSample& before,
                                                       const DriveSample& after) {
  const V zero{}, step = zero + s.constants.dt, half = 0.5 * step;
  const Vec<V> acceleration_before = in_all_lanes<V>(before.body_acceleration),
               acceleration_after = in_all_lanes<V>(after.body_acceleration);
  const double slack = s.max_displacement - s.jar.max_wall_speed() *
                                                static_cast<double>(w.step - w.list_step) *
                                                s.constants.dt;
  const double limit = slack > 0 ? slack * slack : -1;
  BodyBlock* body = w.bodies.data();
  BallBlock *ball = w.balls.data(), *end = ball + w.balls.size();
  MaskOf<V> moved_far{};
  for (; ball != end; ++body, ++ball)
    for (int first = 0; first < lanes; first += width_of<V>) {
      const LaneGroup<V> group{first};
      const Vec<V> half_kick = group(ball->half_kick_factor) * group(ball->force);
      const Vec<V> v = group(ball->velocity) + half_kick + half * acceleration_before;
      const Vec<V> x = group(body->position) + step * v;
      group.put(body->position, x);
      group.put(body->velocity, v + half_kick + half * acceleration_after);
      // Still without the second half kick of the contacts.
      group.put(ball->velocity, v + half * acceleration_after);
      const Vec<V> half_spin_kick = group(ball->half_spin_kick_factor) * group(ball->torque),
                   spin = group(ball->spin) + half_spin_kick;
      group.put(ball->spin, spin);
      group.put(body->angular_velocity, spin + half_spin_kick);
      const Vec<V> displacement = x - group(ball->list_position);
      const V moved = dot(displacement, displacement);
      group.put(ball->displacement_squared, moved);
      moved_far |= ~less(moved, zero + limit) & group(ball->used);
    }
  return any(moved_far);
}

/// The second half kick of the contacts.
template <class V>
[[gnu::always_inline]] inline void second_half_kick(BallBlock& ball, const LaneGroup<V>& group,
                                                    const Vec<V>& force, const Vec<V>& torque) {
  group.put(ball.force, force), group.put(ball.torque, torque);
  group.put(ball.velocity, group(ball.velocity) + group(ball.half_kick_factor) * force);
  group.put(ball.spin, group(ball.spin) + group(ball.half_spin_kick_factor) * torque);
}

/// Sums the force rows of each ball, in the order of its lanes; then the second half kick. Unused
/// lanes of the last group may get forces of other balls, which their factor 0 cancels.
template <class V>
[[gnu::always_inline]] inline void sum_forces(ParticleData& w) {
  const auto* rows = reinterpret_cast<const char*>(w.force_rows.data());
  const std::uint32_t* offset = w.row_offsets.data();
  const std::uint16_t* rows_of_ball = w.rows_of_ball.data();
  ForceRow sums[width_of<V>]{};
  for (std::size_t ball = 0; ball < w.count; ball += width_of<V>) {
    const std::size_t end = std::min<std::size_t>(width_of<V>, w.count - ball);
    for (std::size_t l = 0; l < end; ++l) {
      RowSum<V> sum;
      for (int left = rows_of_ball[ball + l]; left > 0; --left)
        sum.add(reinterpret_cast<const double*>(rows + *offset++));
      sum.put(sums[l].values);
    }
    V f[4], t[4];
    load_columns<V>([&](std::size_t l) -> const ForceRow& { return sums[l]; }, 0, f);
    load_columns<V>([&](std::size_t l) -> const ForceRow& { return sums[l]; }, 4, t);
    second_half_kick<V>(w.balls[ball / lanes], {static_cast<int>(ball % lanes)}, {f[0], f[1], f[2]},
                        {t[0], t[1], t[2]});
  }
}

}  // namespace mahlwerk::soft
