// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "mahlwerk/soft/kernel/periodic.hpp"
#include "mahlwerk/soft/liquid.hpp"

// The forces of the liquid on the balls of FewBodySolver in a step. V is a register of pairs, then
// of balls.
namespace mahlwerk::soft {

/// Eight neighbour pairs: ball i, and ball j or a wall contact point, as a ball of radius 0.
struct alignas(64) LiquidPairs {
  std::array<const double*, lanes> body_i{}, body_j{};  ///< addresses as in GatherMap
  std::array<std::int32_t, lanes> ball_i{}, ball_j{};   ///< ball_j < 0: a wall contact point
  Lanes radii{};                                        ///< [m] sum
  Lanes resistance{}, reach{};                          ///< contact::Liquid; reach 0: a free lane
  Lanes touch_squared{}, reach_squared{};               ///< [m2] of the distance of the centres
};
/// Pairs on which the liquid acts in a step, eight by eight.
struct alignas(64) ActingPairs {
  std::array<std::int32_t, lanes> pair{};  ///< number of the pair
  Vec<Lanes> separation{};                 ///< [m] from i to j
  Lanes squared{}, closing{};              ///< [m2]; [m2/s] separation times relative velocity
  Lanes radii{}, resistance{}, reach{};
};
/// What the liquid asks of eight balls.
struct alignas(64) LiquidBalls {
  Lanes radius{}, displaced_mass{};  ///< [m], [kg]
  Vec<Lanes> force{};                ///< [N] of the pairs in this step
};
struct LiquidNeighbours {
  std::vector<LiquidPairs> pairs;
  std::vector<ActingPairs> acting;  ///< as many; the first `count` pairs of this step
  std::size_t count = 0;
  std::vector<LiquidBalls> balls;
};

struct LiquidStep {
  const LiquidForces& forces;
  LiquidMotion motion;
  bool periodic;
  Vec3 periods;
  LiquidNeighbours& neighbours;
  std::size_t count;        ///< of balls
  const BodyBlock* bodies;  ///< their positions and predicted velocities
  BallBlock* balls;
  LiquidWork work;
};

struct LiquidLoop {
  template <int width>
  [[gnu::always_inline]] static void run(LiquidStep& s) {
    using V = Register<width>;
    for (LiquidBalls& b : s.neighbours.balls) b.force = {};
    s.neighbours.count = 0;
    for (std::size_t n = 0; n < s.neighbours.pairs.size(); ++n)
      for (int first = 0; first < lanes; first += width) find_acting<V>(s, n, {first});
    for (std::size_t first = 0; first < s.neighbours.count; first += width) add_pairs<V>(s, first);
    for (std::size_t b = 0; b < s.neighbours.balls.size(); ++b)
      for (int first = 0; first < lanes; first += width) add_balls<V>(s, b, {first});
  }

 private:
  /// Three numbers of bodies, from the `first` on in the order of BodyBlock.
  template <class V>
  [[gnu::always_inline]] static Vec<V> gather(const std::array<const double*, lanes>& bodies,
                                              const LaneGroup<V>& group, int first) {
    const double* const* body = bodies.data() + group.first;
    const auto column = [&](std::ptrdiff_t c) __attribute__((always_inline)) {
      return lanes_from<V>([&](int l)
                               __attribute__((always_inline)) { return body[l][c * lanes]; });
    };
    return {column(first), column(first + 1), column(first + 2)};
  }

  /// Appends the pairs that do not touch and are so near that the liquid acts: most of those that
  /// are listed do not approach.
  template <class V>
  [[gnu::always_inline]] static void find_acting(LiquidStep& s, std::size_t block,
                                                 const LaneGroup<V>& group) {
    constexpr int position = 0, velocity = 3;
    const LiquidPairs& p = s.neighbours.pairs[block];
    Vec<V> separation = gather<V>(p.body_j, group, position) - gather<V>(p.body_i, group, position);
    if (s.periodic) separation = folded(separation, s.periods);
    const V zero{}, squared = dot(separation, separation);
    const MaskOf<V> near =
        less(group(p.touch_squared), squared) & less(squared, group(p.reach_squared));
    if (!any(near)) return;
    const V closing = dot(
        gather<V>(p.body_i, group, velocity) - gather<V>(p.body_j, group, velocity), separation);
    const MaskOf<V> moves = less(zero, s.forces.liquid().resists_rebound ? abs(closing) : closing);
    for (std::uint32_t found = bits(near & moves); found != 0; found &= found - 1) {
      const int l = std::countr_zero(found);
      const auto from = static_cast<std::size_t>(group.first + l);
      const std::size_t n = s.neighbours.count++, to = n % lanes;
      ActingPairs& a = s.neighbours.acting[n / lanes];
      a.pair[to] = static_cast<std::int32_t>(block * lanes + from);
      a.separation.x[to] = separation.x[l];
      a.separation.y[to] = separation.y[l];
      a.separation.z[to] = separation.z[l];
      a.squared[to] = squared[l], a.closing[to] = closing[l];
      a.radii[to] = p.radii[from];
      a.resistance[to] = p.resistance[from], a.reach[to] = p.reach[from];
    }
  }

  /// Lubrication of a register of pairs (liq.1 to liq.3).
  template <class V>
  [[gnu::always_inline]] static void add_pairs(LiquidStep& s, std::size_t begin) {
    const ActingPairs& a = s.neighbours.acting[begin / lanes];
    const LaneGroup<V> group{static_cast<int>(begin % lanes)};
    const V zero{}, distance = sqrt(group(a.squared)), gap = distance - group(a.radii);
    const V inverse = 1.0 / max(distance, zero + 1e-300), approach = inverse * group(a.closing);
    const double dt = s.forces.time_step();
    const V size = where<V>(less(zero, gap),
                            contact::lubrication_force<V>(s.forces.liquid(), group(a.resistance),
                                                          group(a.reach), gap, approach, dt));
    const Vec<V> force = -(size * inverse) * group(a.separation);
    const V lost = dt * size * approach;
    const std::size_t end = std::min<std::size_t>(width_of<V>, s.neighbours.count - begin);
    for (std::size_t l = 0; l < end; ++l) {
      const auto pair = static_cast<std::size_t>(a.pair[begin % lanes + l]);
      const LiquidPairs& p = s.neighbours.pairs[pair / lanes];
      const Vec3 f{force.x[l], force.y[l], force.z[l]};
      s.work.lost += lost[l];
      add(s, p.ball_i[pair % lanes], f);
      if (p.ball_j[pair % lanes] >= 0) {
        add(s, p.ball_j[pair % lanes], -f);
      } else {
        constexpr std::ptrdiff_t next = lanes;  // from a number to the next of the same body
        const double* velocity = p.body_j[pair % lanes] + 3 * next;
        const Vec3 of_wall{velocity[0], velocity[next], velocity[2 * next]};
        s.work.wall += dt * dot(f, of_wall + s.motion.jar_velocity);
      }
    }
  }
  [[gnu::always_inline]] static void add(LiquidStep& s, std::int32_t ball, const Vec3& force) {
    Vec<Lanes>& sum = s.neighbours.balls[static_cast<std::size_t>(ball / lanes)].force;
    const auto lane = static_cast<std::size_t>(ball % lanes);
    sum.x[lane] += force.x, sum.y[lane] += force.y, sum.z[lane] += force.z;
  }

  /// The forces of the pairs and of the liquid around the balls, and the second half kick by them.
  template <class V>
  [[gnu::always_inline]] static void add_balls(LiquidStep& s, std::size_t block,
                                               const LaneGroup<V>& group) {
    const LiquidBalls& of = s.neighbours.balls[block];
    const BodyBlock& body = s.bodies[block];
    BallBlock& ball = s.balls[block];
    Vec<V> force = group(of.force);
    if (s.forces.acts_on_balls()) {
      const LiquidLoads<V> load = s.forces.on_balls<V>(
          s.motion, group(of.radius), group(of.displaced_mass), group(body.position),
          group(body.velocity), group(body.angular_velocity));
      force = force + load.force;
      group.put(ball.torque, group(ball.torque) + load.torque);
      group.put(ball.spin, group(ball.spin) + group(ball.half_spin_kick_factor) * load.torque);
      const std::size_t first = block * lanes + static_cast<std::size_t>(group.first);
      for (std::size_t l = 0; l < width_of<V> && first + l < s.count; ++l)
        s.work.lost += load.lost[l], s.work.wall += load.wall[l];
    }
    group.put(ball.force, group(ball.force) + force);
    group.put(ball.velocity, group(ball.velocity) + group(ball.half_kick_factor) * force);
  }
};

}  // namespace mahlwerk::soft
