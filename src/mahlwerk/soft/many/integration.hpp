// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/many/chunk_step.hpp"

// Motion of the balls of a chunk over a step. V is a register.
namespace mahlwerk::soft {

/// Stores the parts of a record, past the cache if `streaming`.
template <bool streaming, class V, std::size_t parts, class R>
[[gnu::always_inline]] inline void store_record(R& record, const V (&values)[parts]) {
  unrolled<parts>([&](std::size_t p) __attribute__((always_inline)) {
    if constexpr (streaming)
      stream_part<V>(record, p * width_of<V>, values[p]);
    else
      store_part<V>(record, p * width_of<V>, values[p]);
  });
}

/// A ball's numbers in a step of the integration, in parts of a register: four of the position,
/// eight of the predicted velocity and spin.
template <class V>
struct IntegratedBall {
  static constexpr std::size_t count = 4 / std::min(width_of<V>, 4);
  using Part = Register<std::min(width_of<V>, 4)>;
  Part position[count], velocity[count], spin[count];
};

/// Velocity Verlet (dem.26) for a ball: advances its half-step velocity and spin.
template <class V>
[[gnu::always_inline]] inline IntegratedBall<V> integrate_ball(const ChunkStep& s, std::int32_t i,
                                                               const VectorPair& ball_force,
                                                               const VectorPair& body_kick_before,
                                                               const VectorPair& body_kick_after) {
  constexpr std::size_t w = width_of<V>;
  using Ball = IntegratedBall<V>;
  using Part = typename Ball::Part;
  const Lanes& factor = s.half_kick_factors[s.species[i]];
  Ball ball;
  unrolled<8 / w>([&](std::size_t n) __attribute__((always_inline)) {
    const std::size_t part = n * w;
    const V half_kick = load<V>(factor.values + part) * load_part<V>(ball_force, part);
    const V half =
        load_part<V>(s.half_step[i], part) + 2.0 * half_kick + load_part<V>(body_kick_before, part);
    const V predicted = half + half_kick + load_part<V>(body_kick_after, part);
    store_part<V>(s.half_step[i], part, half);
    if constexpr (w == 8) {
      ball.velocity[0] = __builtin_shufflevector(predicted, predicted, 0, 1, 2, 3);
      ball.spin[0] = __builtin_shufflevector(predicted, predicted, 4, 5, 6, 7);
      ball.position[0] = load_part<Part>(s.rows[i], 0) +
                         s.constants.dt * __builtin_shufflevector(half, half, 0, 1, 2, 3);
    } else {
      const std::size_t p = part % 4 / w;
      (part < 4 ? ball.velocity : ball.spin)[p] = predicted;
      if (part < 4) ball.position[p] = load_part<V>(s.rows[i], part) + s.constants.dt * half;
    }
  });
  return ball;
}

/// Integrates the balls of a chunk over a step.
template <class V, bool streaming>
[[gnu::always_inline]] inline void integrate_balls(const ChunkStep& s, const Chunk& chunk,
                                                   const VectorPair* ball_forces,
                                                   ChunkDisplacement& displacement) {
  using Ball = IntegratedBall<V>;
  using Part = typename Ball::Part;
  constexpr std::size_t count = Ball::count, w = width_of<Part>;
  const double dt = s.constants.dt;
  const Vec3 before = dt * s.drive.body_acceleration,
             after = 0.5 * dt * s.next_drive.body_acceleration;
  const VectorPair kick_before{before.x, before.y, before.z}, kick_after{after.x, after.y, after.z};
  alignas(64) const double predicted_mean[4] = {
      displacement.predicted_mean.x, displacement.predicted_mean.y, displacement.predicted_mean.z};
  Part sum[count]{}, max_deviation[count]{};
  for (std::int32_t i = chunk.first; i < chunk.last; ++i) {
    const Ball ball =
        integrate_ball<V>(s, i, ball_forces[i - chunk.first], kick_before, kick_after);
    if constexpr (width_of<V> == 8) {
      const V next[1] = {
          __builtin_shufflevector(ball.position[0], ball.velocity[0], 0, 1, 2, 3, 4, 5, 6, 7)};
      store_record<streaming>(s.next_rows[i], next);
    } else {
      Part next[2 * count];
      unrolled<count>([&](std::size_t p) __attribute__((always_inline)) {
        next[p] = ball.position[p], next[count + p] = ball.velocity[p];
      });
      store_record<streaming>(s.next_rows[i], next);
    }
    store_record<streaming>(s.next_spins[i], ball.spin);
    unrolled<count>([&](std::size_t p) __attribute__((always_inline)) {
      const Part way = ball.position[p] - reference_part<Part>(s.reference_positions[i], p * w);
      const Part deviation = way - load<Part>(predicted_mean + p * w);
      sum[p] += way;
      max_deviation[p] = max(max_deviation[p], deviation);
      max_deviation[p] = max(max_deviation[p], -deviation);
    });
  }
  if constexpr (streaming) store_fence();
  const auto number = [](const Part(&parts)[count], std::size_t k) { return parts[k / w][k % w]; };
  const double balls = std::max(1, chunk.last - chunk.first);
  displacement.spread = std::sqrt(number(max_deviation, 0) * number(max_deviation, 0) +
                                  number(max_deviation, 1) * number(max_deviation, 1) +
                                  number(max_deviation, 2) * number(max_deviation, 2));
  displacement.mean = {number(sum, 0) / balls, number(sum, 1) / balls, number(sum, 2) / balls};
}

}  // namespace mahlwerk::soft
