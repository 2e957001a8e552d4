// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/collision_prediction.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include "mahlwerk/base/lanes.hpp"

namespace mahlwerk::event {
namespace {

using Pair = Register<2>;

[[gnu::always_inline]] inline Pair load_pair(const double* from) {
  Pair loaded;
  std::memcpy(&loaded, from, sizeof loaded);
  return loaded;
}

/// Component `first` and the next one of `width` balls: `at[l]` begins the components of ball l.
template <int width>
[[gnu::always_inline]] inline void gather_two(const double* const (&at)[width], std::size_t first,
                                              Register<width>& a, Register<width>& b) {
  const auto pair = [&](std::size_t l) { return load_pair(at[l] + first); };
  if constexpr (width == 2) {
    const Pair even = pair(0), odd = pair(1);
    a = __builtin_shufflevector(even, odd, 0, 2);
    b = __builtin_shufflevector(even, odd, 1, 3);
  } else if constexpr (width == 4) {
    const Register<4> even = __builtin_shufflevector(pair(0), pair(2), 0, 1, 2, 3);
    const Register<4> odd = __builtin_shufflevector(pair(1), pair(3), 0, 1, 2, 3);
    a = __builtin_shufflevector(even, odd, 0, 4, 2, 6);
    b = __builtin_shufflevector(even, odd, 1, 5, 3, 7);
  } else {
    const Register<4> e0 = __builtin_shufflevector(pair(0), pair(2), 0, 1, 2, 3);
    const Register<4> e1 = __builtin_shufflevector(pair(4), pair(6), 0, 1, 2, 3);
    const Register<4> o0 = __builtin_shufflevector(pair(1), pair(3), 0, 1, 2, 3);
    const Register<4> o1 = __builtin_shufflevector(pair(5), pair(7), 0, 1, 2, 3);
    const Register<8> even = __builtin_shufflevector(e0, e1, 0, 1, 2, 3, 4, 5, 6, 7);
    const Register<8> odd = __builtin_shufflevector(o0, o1, 0, 1, 2, 3, 4, 5, 6, 7);
    a = __builtin_shufflevector(even, odd, 0, 8, 2, 10, 4, 12, 6, 14);
    b = __builtin_shufflevector(even, odd, 1, 9, 3, 11, 5, 13, 7, 15);
  }
}

/// Minimum image convention, as nearest_image().
template <int width>
[[gnu::always_inline]] inline void fold(Register<width>& x, double period) {
  using V = Register<width>;
  using Bits = RegisterMask<width>;
  const Register<width> shift = Register<width>{} + period;
  const Bits sign = reinterpret_cast<Bits>(x) & std::numeric_limits<std::int64_t>::min();
  const auto size = reinterpret_cast<Register<width>>(reinterpret_cast<Bits>(x) ^ sign);
  const Bits signed_shift = reinterpret_cast<Bits>(shift) | sign;
  x -= reinterpret_cast<Register<width>>(signed_shift & less<V>(V{} + 0.5 * period, size));
}

constexpr std::size_t block = 64;  // candidates whose intermediate results are kept at a time

/// The quantities of (man.2) for a block of candidates, and one bit for each that collides.
struct Approaches {
  alignas(64) double b[block], c[block], d[block];
  std::uint64_t colliding;
};

/// Computes b, c = q and the discriminant d of (man.2) for `width` candidates, from place `k` of
/// the block on.
template <int width, bool periodic, bool one_size>
[[gnu::always_inline]] inline void approach(const CollisionQuery& me,
                                            const Trajectory* trajectories,
                                            const std::int32_t* others, const double* radii,
                                            const Vec3& periods, std::size_t k, Approaches& out) {
  using V = Register<width>;
  static_assert(offsetof(Trajectory, since) == 3 * sizeof(double) &&
                offsetof(Trajectory, velocity) == 4 * sizeof(double));
  const V zero{};
  V touch_distance = zero + (me.radius + radii[0]);
  const double* at[width];
  for (int l = 0; l < width; ++l) {
    const Trajectory& trajectory = trajectories[others[l]];
    at[l] = &trajectory.position.x;
    if constexpr (!one_size) touch_distance[l] = me.radius + radii[trajectory.species];
  }
  V px, py, pz, since, vx, vy, vz, unused;
  gather_two<width>(at, 0, px, py);
  gather_two<width>(at, 2, pz, since);
  gather_two<width>(at, 4, vx, vy);
  gather_two<width>(at, 6, vz, unused);
  const V elapsed = me.time - since;
  V x = me.position.x - (px + elapsed * vx), y = me.position.y - (py + elapsed * vy),
    z = me.position.z - (pz + elapsed * vz);
  if constexpr (periodic) {
    fold<width>(x, periods.x);
    fold<width>(y, periods.y);
    fold<width>(z, periods.z);
  }
  const V ux = me.velocity.x - vx, uy = me.velocity.y - vy, uz = me.velocity.z - vz;
  const V b = x * ux + y * uy + z * uz, u2 = ux * ux + uy * uy + uz * uz;
  const V c = x * x + y * y + z * z - touch_distance * touch_distance;
  const V d = b * b - u2 * c;
  std::memcpy(&out.b[k], &b, sizeof b);
  std::memcpy(&out.c[k], &c, sizeof c);
  std::memcpy(&out.d[k], &d, sizeof d);
  out.colliding |= std::uint64_t{bits(less<V>(b, zero) & less<V>(zero, d))} << k;
}

/// The earliest collision found in the blocks so far.
struct Earliest {
  double time;                            // [s] since now
  const std::int32_t* partner = nullptr;  // null: none
};

/// Square roots and divisions only for the few candidates that collide at all; the first of several
/// at the same time counts. Two at a time and integer comparisons, because no predictor foresees
/// how many there are and which is earlier. Times are not negative, so their bits sort as they do.
[[gnu::always_inline]] inline void choose(const Approaches& found, const std::int32_t* others,
                                          Earliest& earliest) {
  const auto time_at = [&](std::size_t k) {
    const double c = found.c[k];
    return std::bit_cast<std::int64_t>((c > 0 ? c : 0.0) / (std::sqrt(found.d[k]) - found.b[k]));
  };
  auto min_time = std::bit_cast<std::int64_t>(earliest.time);
  std::size_t chosen = block;
  const auto place = [](std::uint64_t bits) {
    return static_cast<std::size_t>(std::countr_zero(bits));
  };
  for (std::uint64_t left = found.colliding; left != 0;) {
    const std::size_t one = place(left);
    left &= left - 1;
    const std::size_t two = left != 0 ? place(left) : one;
    left &= left - 1;
    const std::int64_t time_one = time_at(one), time_two = time_at(two);
    const std::size_t k = time_two < time_one ? two : one;
    const std::int64_t time = time_two < time_one ? time_two : time_one;
    chosen = time < min_time ? k : chosen;
    min_time = time < min_time ? time : min_time;
  }
  if (chosen == block) return;
  earliest = {std::bit_cast<double>(min_time), others + chosen};
}

template <int width, bool periodic, bool one_size>
[[gnu::always_inline]] inline PredictedCollision earliest(const CollisionQuery& me,
                                                          const Trajectory* trajectories,
                                                          std::span<const std::int32_t> others,
                                                          const double* radii, const Vec3& periods,
                                                          const PredictedCollision& best) {
  Earliest earliest{best.time - me.time};
  Approaches found;
  for (; !others.empty(); others = others.subspan(std::min(others.size(), block))) {
    const std::size_t count = std::min(others.size(), block);
    found.colliding = 0;
    for (std::size_t k = 0; k < count; k += width) {
      const std::int32_t* group = &others[k];
      std::int32_t rest[width];
      if (count - k < static_cast<std::size_t>(
                          width)) {  // filled up with the ball itself, which it does not approach
        for (int l = 0; l < width; ++l)
          rest[l] = k + static_cast<std::size_t>(l) < count ? group[l] : me.self;
        group = rest;
      }
      approach<width, periodic, one_size>(me, trajectories, group, radii, periods, k, found);
    }
    choose(found, others.data(), earliest);
  }
  return earliest.partner == nullptr
             ? best
             : PredictedCollision{me.time + earliest.time, *earliest.partner};
}

struct Search {
  template <int width>
  [[gnu::always_inline]] static PredictedCollision run(const CollisionQuery& me,
                                                       std::span<const Trajectory> trajectories,
                                                       std::span<const std::int32_t> others,
                                                       std::span<const double> radii,
                                                       const Vec3& periods,
                                                       const PredictedCollision& best) {
    const bool periodic = periods.x < never, one_size = radii.size() == 1;
    const Trajectory* all = trajectories.data();
    if (periodic && one_size)
      return earliest<width, true, true>(me, all, others, radii.data(), periods, best);
    if (periodic) return earliest<width, true, false>(me, all, others, radii.data(), periods, best);
    if (one_size) return earliest<width, false, true>(me, all, others, radii.data(), periods, best);
    return earliest<width, false, false>(me, all, others, radii.data(), periods, best);
  }
};

}  // namespace

CollisionSearch* collision_search() {
  return Multiversioned<Search, CollisionSearch*>::best();
}

}  // namespace mahlwerk::event
