// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/collision_prediction.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

// Function multiversioning: one source, compiled for several instruction sets, chosen at run time.
// All versions give the same bits. GCC's clones crash under the thread sanitizer, and clang 14
// cannot link them.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define MAHLWERK_CLONES __attribute__((target_clones("default", "avx2", "avx512f"), flatten))
#else
#define MAHLWERK_CLONES
#endif

namespace mahlwerk::event {
namespace {

constexpr std::size_t lanes = 4;
using Four = double __attribute__((vector_size(32)));
using FourIndices = std::int64_t __attribute__((vector_size(32)));
using Rows = Four[lanes];

/// Transposes a 4 x 4 matrix.
[[gnu::always_inline]] inline void transpose(Rows& a) {
  const Four low01 = __builtin_shufflevector(a[0], a[1], 0, 4, 2, 6);
  const Four high01 = __builtin_shufflevector(a[0], a[1], 1, 5, 3, 7);
  const Four low23 = __builtin_shufflevector(a[2], a[3], 0, 4, 2, 6);
  const Four high23 = __builtin_shufflevector(a[2], a[3], 1, 5, 3, 7);
  a[0] = __builtin_shufflevector(low01, low23, 0, 1, 4, 5);
  a[1] = __builtin_shufflevector(high01, high23, 0, 1, 4, 5);
  a[2] = __builtin_shufflevector(low01, low23, 2, 3, 6, 7);
  a[3] = __builtin_shufflevector(high01, high23, 2, 3, 6, 7);
}

[[gnu::always_inline]] inline void fold(Four& x, double period) {
  const Four zero{}, shift = zero + period;
  x -= x > 0.5 * period ? shift : zero;
  x += x < -0.5 * period ? shift : zero;
}

/// The earliest collision of each of four SIMD lanes, with its time since now.
struct EarliestLanes {
  Four time;
  FourIndices partner;
};

template <bool periodic, bool one_size>
[[gnu::always_inline]] inline PredictedCollision earliest_in_lanes(
    const CollisionQuery& me, const Trajectory* trajectories, std::span<const std::int32_t> others,
    const double* radii, const Vec3& periods, const PredictedCollision& best) {
  const Four zero{};
  EarliestLanes earliest{zero + (best.time - me.time), FourIndices{} + best.partner};
  Four touch_distance = zero + (me.radius + radii[0]);
  for (std::size_t k = 0; k < others.size(); k += lanes) {
    Rows p, v;
    std::int64_t index[lanes];
    for (std::size_t l = 0; l < lanes; ++l) {
      index[l] = k + l < others.size() ? others[k + l] : me.self;  // padding: no collision
      const Trajectory& trajectory = trajectories[index[l]];
      static_assert(offsetof(Trajectory, velocity) == sizeof(Four));
      std::memcpy(&p[l], &trajectory.position, sizeof(Four));  // x, y, z, since
      std::memcpy(&v[l], &trajectory.velocity, sizeof(Four));  // x, y, z, unused
      if constexpr (!one_size) touch_distance[l] = me.radius + radii[trajectory.species];
    }
    FourIndices partner;
    std::memcpy(&partner, index, sizeof partner);
    transpose(p);
    transpose(v);
    const Four elapsed = me.time - p[3];
    Four x = me.position.x - (p[0] + elapsed * v[0]), y = me.position.y - (p[1] + elapsed * v[1]),
         z = me.position.z - (p[2] + elapsed * v[2]);
    if constexpr (periodic) {
      fold(x, periods.x);
      fold(y, periods.y);
      fold(z, periods.z);
    }
    const Four ux = me.velocity.x - v[0], uy = me.velocity.y - v[1], uz = me.velocity.z - v[2];
    const Four b = x * ux + y * uy + z * uz, u2 = ux * ux + uy * uy + uz * uz;
    const Four c = x * x + y * y + z * z - touch_distance * touch_distance;
    Four d = b * b - u2 * c;
    const FourIndices collides = (b < zero) & (d > zero);
    d = d > zero ? d : zero;
    Four root;
    for (std::size_t l = 0; l < lanes; ++l) root[l] = std::sqrt(d[l]);
    const Four time = (c > zero ? c : zero) / (root - b);
    const FourIndices earlier = collides & (time < earliest.time);
    earliest.time = earlier ? time : earliest.time;
    earliest.partner = earlier ? partner : earliest.partner;
  }
  PredictedCollision found = best;
  double min_time = best.time - me.time;
  for (std::size_t l = 0; l < lanes; ++l) {
    if (!(earliest.time[l] < min_time)) continue;
    min_time = earliest.time[l];
    found = {me.time + min_time, static_cast<std::int32_t>(earliest.partner[l])};
  }
  return found;
}

}  // namespace

MAHLWERK_CLONES PredictedCollision earliest_collision(const CollisionQuery& me,
                                                      std::span<const Trajectory> trajectories,
                                                      std::span<const std::int32_t> others,
                                                      std::span<const double> radii,
                                                      const Vec3& periods,
                                                      const PredictedCollision& best) {
  const bool periodic = periods.x < never, one_size = radii.size() == 1;
  if (periodic && one_size)
    return earliest_in_lanes<true, true>(me, trajectories.data(), others, radii.data(), periods,
                                         best);
  if (periodic)
    return earliest_in_lanes<true, false>(me, trajectories.data(), others, radii.data(), periods,
                                          best);
  if (one_size)
    return earliest_in_lanes<false, true>(me, trajectories.data(), others, radii.data(), periods,
                                          best);
  return earliest_in_lanes<false, false>(me, trajectories.data(), others, radii.data(), periods,
                                         best);
}

}  // namespace mahlwerk::event
