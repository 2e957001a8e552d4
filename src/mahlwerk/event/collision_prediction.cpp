// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/collision_prediction.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string_view>

// The search is compiled for several instruction sets, each with vectors of exactly the width of
// its registers; GCC splits wider ones into scalar comparisons. All versions give the same bits.
// The thread sanitizer cannot handle the choice at run time, and clang 14 names the instructions
// differently.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define MAHLWERK_COLLISION_ISAS 1
#include <immintrin.h>
#endif

namespace mahlwerk::event {
namespace {

/// Vectors of `width` doubles.
template <std::size_t width>
struct Vectors {
  typedef double Real __attribute__((vector_size(width * sizeof(double))));
  typedef std::int64_t Mask __attribute__((vector_size(width * sizeof(double))));
};
template <std::size_t width>
using Real = typename Vectors<width>::Real;
using Pair = Real<2>;

[[gnu::always_inline]] inline Pair load_pair(const double* from) {
  Pair loaded;
  std::memcpy(&loaded, from, sizeof loaded);
  return loaded;
}

/// One bit for each lane that is set in `mask`.
template <std::size_t width>
[[gnu::always_inline]] inline std::uint64_t lane_bits(const typename Vectors<width>::Mask& mask) {
#if MAHLWERK_COLLISION_ISAS
  if constexpr (width == 8)
    return static_cast<std::uint8_t>(__builtin_ia32_ptestmq512(
        reinterpret_cast<__v8di>(mask), reinterpret_cast<__v8di>(mask), 0xff));
  if constexpr (width == 4)
    return static_cast<std::uint64_t>(__builtin_ia32_movmskpd256(reinterpret_cast<__m256d>(mask)));
  if constexpr (width == 2)
    return static_cast<std::uint64_t>(__builtin_ia32_movmskpd(reinterpret_cast<__m128d>(mask)));
#endif
  std::uint64_t bits = 0;
  for (std::size_t l = 0; l < width; ++l) bits |= (mask[l] != 0 ? 1ULL : 0ULL) << l;
  return bits;
}

/// Component `first` and the next one of `width` balls: `at[l]` begins the components of ball l.
template <std::size_t width>
[[gnu::always_inline]] inline void gather_two(const double* const (&at)[width], std::size_t first,
                                              Real<width>& a, Real<width>& b) {
  const auto pair = [&](std::size_t l) { return load_pair(at[l] + first); };
  if constexpr (width == 2) {
    const Pair even = pair(0), odd = pair(1);
    a = __builtin_shufflevector(even, odd, 0, 2);
    b = __builtin_shufflevector(even, odd, 1, 3);
  } else if constexpr (width == 4) {
    const Real<4> even = __builtin_shufflevector(pair(0), pair(2), 0, 1, 2, 3);
    const Real<4> odd = __builtin_shufflevector(pair(1), pair(3), 0, 1, 2, 3);
    a = __builtin_shufflevector(even, odd, 0, 4, 2, 6);
    b = __builtin_shufflevector(even, odd, 1, 5, 3, 7);
  } else {
    const Real<4> e0 = __builtin_shufflevector(pair(0), pair(2), 0, 1, 2, 3);
    const Real<4> e1 = __builtin_shufflevector(pair(4), pair(6), 0, 1, 2, 3);
    const Real<4> o0 = __builtin_shufflevector(pair(1), pair(3), 0, 1, 2, 3);
    const Real<4> o1 = __builtin_shufflevector(pair(5), pair(7), 0, 1, 2, 3);
    const Real<8> even = __builtin_shufflevector(e0, e1, 0, 1, 2, 3, 4, 5, 6, 7);
    const Real<8> odd = __builtin_shufflevector(o0, o1, 0, 1, 2, 3, 4, 5, 6, 7);
    a = __builtin_shufflevector(even, odd, 0, 8, 2, 10, 4, 12, 6, 14);
    b = __builtin_shufflevector(even, odd, 1, 9, 3, 11, 5, 13, 7, 15);
  }
}

/// Minimum image convention, as nearest_image().
template <std::size_t width>
[[gnu::always_inline]] inline void fold(Real<width>& x, double period) {
  using Bits = typename Vectors<width>::Mask;
  const Real<width> shift = Real<width>{} + period;
  const Bits sign = reinterpret_cast<Bits>(x) & std::numeric_limits<std::int64_t>::min();
  const auto size = reinterpret_cast<Real<width>>(reinterpret_cast<Bits>(x) ^ sign);
  const Bits signed_shift = reinterpret_cast<Bits>(shift) | sign;
  x -= reinterpret_cast<Real<width>>(signed_shift & (size > 0.5 * period));
}

constexpr std::size_t block = 64;  // candidates whose intermediate results are kept at a time

/// The quantities of (man.2) for a block of candidates, and one bit for each that collides.
struct Approaches {
  alignas(64) double b[block], c[block], d[block];
  std::uint64_t colliding;
};

/// Computes b, c = q and the discriminant d of (man.2) for `width` candidates, from place `k` of
/// the block on.
template <std::size_t width, bool periodic, bool one_size>
[[gnu::always_inline]] inline void approach(const CollisionQuery& me,
                                            const Trajectory* trajectories,
                                            const std::int32_t* others, const double* radii,
                                            const Vec3& periods, std::size_t k, Approaches& out) {
  using V = Real<width>;
  static_assert(offsetof(Trajectory, since) == 3 * sizeof(double) &&
                offsetof(Trajectory, velocity) == 4 * sizeof(double));
  const V zero{};
  V touch_distance = zero + (me.radius + radii[0]);
  const double* at[width];
  for (std::size_t l = 0; l < width; ++l) {
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
  out.colliding |= lane_bits<width>((b < zero) & (d > zero)) << k;
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

template <std::size_t width, bool periodic, bool one_size>
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
      if (count - k < width) {  // filled up with the ball itself, which it does not approach
        for (std::size_t l = 0; l < width; ++l) rest[l] = k + l < count ? group[l] : me.self;
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

#define MAHLWERK_SEARCH_PARAMETERS                                                              \
  const CollisionQuery &me, std::span<const Trajectory> trajectories,                           \
      std::span<const std::int32_t> others, std::span<const double> radii, const Vec3 &periods, \
      const PredictedCollision &best
#define MAHLWERK_SEARCH_ARGUMENTS me, trajectories.data(), others, radii.data(), periods, best

template <std::size_t width>
[[gnu::always_inline]] inline PredictedCollision earliest_of_case(MAHLWERK_SEARCH_PARAMETERS) {
  const bool periodic = periods.x < never, one_size = radii.size() == 1;
  if (periodic && one_size) return earliest<width, true, true>(MAHLWERK_SEARCH_ARGUMENTS);
  if (periodic) return earliest<width, true, false>(MAHLWERK_SEARCH_ARGUMENTS);
  if (one_size) return earliest<width, false, true>(MAHLWERK_SEARCH_ARGUMENTS);
  return earliest<width, false, false>(MAHLWERK_SEARCH_ARGUMENTS);
}

PredictedCollision earliest_baseline(MAHLWERK_SEARCH_PARAMETERS) {
  return earliest_of_case<2>(me, trajectories, others, radii, periods, best);
}
#if MAHLWERK_COLLISION_ISAS
[[gnu::target("avx2")]] PredictedCollision earliest_avx2(MAHLWERK_SEARCH_PARAMETERS) {
  return earliest_of_case<4>(me, trajectories, others, radii, periods, best);
}
[[gnu::target("avx512f")]] PredictedCollision earliest_avx512(MAHLWERK_SEARCH_PARAMETERS) {
  return earliest_of_case<8>(me, trajectories, others, radii, periods, best);
}
#endif

std::vector<CollisionSearch*> searches_of_this_machine() {
  std::vector<CollisionSearch*> found{earliest_baseline};
#if MAHLWERK_COLLISION_ISAS
  if (__builtin_cpu_supports("avx2")) found.push_back(earliest_avx2);
  if (__builtin_cpu_supports("avx512f")) found.push_back(earliest_avx512);
#endif
  return found;
}

/// The widest, or the one that the environment variable MAHLWERK_SIMD asks for.
CollisionSearch* choose_search() {
  const char* wish = std::getenv("MAHLWERK_SIMD");
  const std::string_view asked = wish == nullptr ? "" : wish;
  const std::vector<CollisionSearch*> all = searches_of_this_machine();
  if (asked == "plain") return all.front();
  return asked == "avx2" && all.size() > 1 ? all[1] : all.back();
}

}  // namespace

std::vector<CollisionSearch*> collision_searches() {
  return searches_of_this_machine();
}

CollisionSearch* const earliest_collision = choose_search();

}  // namespace mahlwerk::event
