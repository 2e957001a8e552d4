// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>

#include "mahlwerk/base/lanes.hpp"
#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/soft/kernel/isa.hpp"

// Ball data as an array of structures: the data that contacts read of a ball lie in one cache line.
// Eight arbitrary balls are eight loads and a transposition to columns in registers.
namespace mahlwerk::soft {

/// Data of a ball that contacts read, in the jar frame.
struct alignas(64) BallRecord {
  double x = 0, y = 0, z = 0;  ///< [m]
  double radius = 0;           ///< [m]
  double u = 0, v = 0, w = 0;  ///< [m/s] predicted (dem.26)
  double zero = 0;

  Vec3 position() const { return {x, y, z}; }
};
struct alignas(32) SpinRecord {
  double x = 0, y = 0, z = 0;  ///< [rad/s] predicted
  double zero = 0;
};
/// Two 3-vectors: velocity and spin, or force and torque.
struct alignas(64) VectorPair {
  double x = 0, y = 0, z = 0, zero = 0;
  double a = 0, b = 0, c = 0, empty = 0;
};

/// Single-precision position [m], accurate to a few nanometres.
struct alignas(16) FloatPosition {
  float x = 0, y = 0, z = 0, zero = 0;
};

using Four = double __attribute__((vector_size(4 * sizeof(double))));
using FourFloats = float __attribute__((vector_size(4 * sizeof(float)), may_alias));
using AliasedLanes = double __attribute__((vector_size(8 * sizeof(double)), may_alias));
using AliasedFour = double __attribute__((vector_size(4 * sizeof(double)), may_alias));

template <class R>
[[gnu::always_inline]] inline Lanes load_eight(const R& row) {
  return *reinterpret_cast<const AliasedLanes*>(&row);
}
template <class R>
[[gnu::always_inline]] inline void store_eight(R& row, const Lanes& a) {
  *reinterpret_cast<AliasedLanes*>(&row) = a;
}
template <class R>
[[gnu::always_inline]] inline Four load_four(const R& row) {
  return *reinterpret_cast<const AliasedFour*>(&row);
}
/// Joins two halves. Inline assembly, because GCC 12 loads both and then shuffles.
[[gnu::always_inline]] inline Lanes join(const AliasedFour& a, const AliasedFour& b) {
  Lanes both;
#ifdef MAHLWERK_AVX512
  asm("vinsertf64x4 $1, %2, %g1, %0" : "=v"(both) : "v"(a), "m"(b));
#else
  both = __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
#endif
  return both;
}
/// The first (or last) four numbers of two rows.
template <class R>
[[gnu::always_inline]] inline Lanes load_fours(const R& a, const R& b) {
  return join(*reinterpret_cast<const AliasedFour*>(&a), *reinterpret_cast<const AliasedFour*>(&b));
}
template <class R>
[[gnu::always_inline]] inline Lanes load_last_fours(const R& a, const R& b) {
  return join(*(reinterpret_cast<const AliasedFour*>(&a) + 1),
              *(reinterpret_cast<const AliasedFour*>(&b) + 1));
}
template <class R>
[[gnu::always_inline]] inline void store_four(R& row, const Four& a) {
  *reinterpret_cast<AliasedFour*>(&row) = a;
}
/// Streaming (non-temporal) store, which bypasses the cache.
template <class R, class A>
[[gnu::always_inline]] inline void stream_store(R& row, const A& a) {
#ifdef MAHLWERK_AVX512
  asm("vmovntpd %1, %0" : "=m"(row) : "v"(a));
#else
  std::memcpy(&row, &a, sizeof row);
#endif
}
/// Memory fence: orders the streaming stores before other threads read.
[[gnu::always_inline]] inline void store_fence() {
#ifdef MAHLWERK_AVX512
  asm volatile("sfence" ::: "memory");
#endif
}
[[gnu::always_inline]] inline Four load_four(const FloatPosition& position) {
  return __builtin_convertvector(*reinterpret_cast<const FourFloats*>(&position), Four);
}

/// Transposes in place: r[k] holds rows k and k + 4 of four numbers each; the result is four
/// columns of eight.
[[gnu::always_inline]] inline void transpose(Lanes (&r)[4]) {
  const auto unpack = [](const Lanes& a, const Lanes& b, Lanes& even, Lanes& odd) {
    even = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
    odd = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  };
  Lanes even[2], odd[2];
  unpack(r[0], r[1], even[0], odd[0]);
  unpack(r[2], r[3], even[1], odd[1]);
  r[0] = __builtin_shufflevector(even[0], even[1], 0, 1, 8, 9, 4, 5, 12, 13);
  r[1] = __builtin_shufflevector(odd[0], odd[1], 0, 1, 8, 9, 4, 5, 12, 13);
  r[2] = __builtin_shufflevector(even[0], even[1], 2, 3, 10, 11, 6, 7, 14, 15);
  r[3] = __builtin_shufflevector(odd[0], odd[1], 2, 3, 10, 11, 6, 7, 14, 15);
}
/// Transposes eight rows to eight columns in place, or back.
[[gnu::always_inline]] inline void transpose(Lanes (&r)[8]) {
  Lanes t[8], s[8];
  for (int k = 0; k < 8; k += 2) {
    t[k] = __builtin_shufflevector(r[k], r[k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    t[k + 1] = __builtin_shufflevector(r[k], r[k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (int k = 0; k < 8; k += 4)
    for (int odd = 0; odd < 2; ++odd) {
      const Lanes &a = t[k + odd], &b = t[k + 2 + odd];
      s[k + odd] = __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
      s[k + 2 + odd] = __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
    }
  for (int k = 0; k < 4; ++k) {
    r[k] = __builtin_shufflevector(s[k], s[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    r[k + 4] = __builtin_shufflevector(s[k], s[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

}  // namespace mahlwerk::soft
