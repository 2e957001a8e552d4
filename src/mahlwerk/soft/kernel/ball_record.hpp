// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "mahlwerk/base/lanes.hpp"
#include "mahlwerk/base/vec3.hpp"

// Ball data as an array of structures: the data that contacts read of a ball lie in one cache line.
// Eight arbitrary balls are eight loads and a transposition to columns in registers.
namespace mahlwerk::soft {

/// f(0) to f(count - 1) with constant indices. No loop: GCC 12 does not unroll loops at -O1 and
/// keeps an array that a loop indexes in memory.
template <std::size_t count, class F>
[[gnu::always_inline]] inline void unrolled(const F& f) {
  [&]<std::size_t... n>(std::index_sequence<n...>) __attribute__((always_inline)) {
    (f(n), ...);
  }
  (std::make_index_sequence<count>{});
}

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

/// The numbers of a record from `first` on, as a register.
template <class V, class R>
[[gnu::always_inline]] inline V load_part(const R& record, std::size_t first = 0) {
  return load<V>(reinterpret_cast<const double*>(&record) + first);
}
template <class V, class R>
[[gnu::always_inline]] inline void store_part(R& record, std::size_t first, const V& a) {
  store<V>(reinterpret_cast<double*>(&record) + first, a);
}
/// Streaming (non-temporal) store, which bypasses the cache.
template <class V, class R>
[[gnu::always_inline]] inline void stream_part(R& record, std::size_t first, const V& a) {
  using Aliased = typename RegisterOf<width_of<V>>::Aliased;
  auto* to = reinterpret_cast<Aliased*>(reinterpret_cast<double*>(&record) + first);
#if defined(MAHLWERK_X86_ASM)
  if constexpr (width_of<V> == 2)
    asm("movntpd %1, %0" : "=m"(*to) : "x"(a));
  else
    asm("vmovntpd %1, %0" : "=m"(*to) : "v"(a));
#elif defined(__clang__)
  __builtin_nontemporal_store(a, to);
#else
  *to = a;
#endif
}
/// Memory fence: orders the streaming stores before other threads read.
[[gnu::always_inline]] inline void store_fence() {
#ifdef MAHLWERK_X86_64
  asm volatile("sfence" ::: "memory");
#endif
}

/// Numbers of a reference position from `first` on.
template <class V>
[[gnu::always_inline]] inline V reference_part(const FloatPosition& position, std::size_t first) {
  using Floats = typename RegisterOf<width_of<V>>::AliasedFloats;
  const auto* from = reinterpret_cast<const float*>(&position) + first;
  return __builtin_convertvector(*reinterpret_cast<const Floats*>(from), V);
}

/// Joins two halves. Inline assembly, because GCC 12 loads both and then shuffles.
[[gnu::always_inline]] inline Register<8> join(const Register<4>& a,
                                               const RegisterOf<4>::Aliased& b) {
  Register<8> both;
#ifdef MAHLWERK_X86_ASM
  asm("vinsertf64x4 $1, %2, %g1, %0" : "=v"(both) : "v"(a), "m"(b));
#else
  const Register<4> second = b;
  both = __builtin_shufflevector(a, second, 0, 1, 2, 3, 4, 5, 6, 7);
#endif
  return both;
}
/// Four numbers of two records each, from `first` on.
template <class R>
[[gnu::always_inline]] inline Register<8> load_fours(const R& a, const R& b, std::size_t first) {
  const double* second = reinterpret_cast<const double*>(&b) + first;
  return join(load_part<Register<4>>(a, first),
              *reinterpret_cast<const RegisterOf<4>::Aliased*>(second));
}

/// Transposes in place: r[k] holds rows k and k + 4 of four numbers each; the result is four
/// columns of eight.
[[gnu::always_inline]] inline void transpose(Register<8> (&r)[4]) {
  using V = Register<8>;
  const auto unpack = [](const V& a, const V& b, V& even, V& odd) {
    even = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
    odd = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  };
  V even[2], odd[2];
  unpack(r[0], r[1], even[0], odd[0]);
  unpack(r[2], r[3], even[1], odd[1]);
  r[0] = __builtin_shufflevector(even[0], even[1], 0, 1, 8, 9, 4, 5, 12, 13);
  r[1] = __builtin_shufflevector(odd[0], odd[1], 0, 1, 8, 9, 4, 5, 12, 13);
  r[2] = __builtin_shufflevector(even[0], even[1], 2, 3, 10, 11, 6, 7, 14, 15);
  r[3] = __builtin_shufflevector(odd[0], odd[1], 2, 3, 10, 11, 6, 7, 14, 15);
}
/// Transposes four rows of four in place.
[[gnu::always_inline]] inline void transpose(Register<4> (&r)[4]) {
  using V = Register<4>;
  const V low01 = __builtin_shufflevector(r[0], r[1], 0, 4, 2, 6);
  const V high01 = __builtin_shufflevector(r[0], r[1], 1, 5, 3, 7);
  const V low23 = __builtin_shufflevector(r[2], r[3], 0, 4, 2, 6);
  const V high23 = __builtin_shufflevector(r[2], r[3], 1, 5, 3, 7);
  r[0] = __builtin_shufflevector(low01, low23, 0, 1, 4, 5);
  r[1] = __builtin_shufflevector(high01, high23, 0, 1, 4, 5);
  r[2] = __builtin_shufflevector(low01, low23, 2, 3, 6, 7);
  r[3] = __builtin_shufflevector(high01, high23, 2, 3, 6, 7);
}
/// Transposes eight rows to eight columns in place, or back.
[[gnu::always_inline]] inline void transpose(Register<8> (&r)[8]) {
  Register<8> t[8], s[8];
  unrolled<4>([&](std::size_t n) __attribute__((always_inline)) {
    const std::size_t k = 2 * n;
    t[k] = __builtin_shufflevector(r[k], r[k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    t[k + 1] = __builtin_shufflevector(r[k], r[k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  });
  unrolled<4>([&](std::size_t n) __attribute__((always_inline)) {
    const std::size_t k = n / 2 * 4, odd = n % 2;
    const Register<8>&a = t[k + odd], &b = t[k + 2 + odd];
    s[k + odd] = __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
    s[k + 2 + odd] = __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
  });
  unrolled<4>([&](std::size_t k) __attribute__((always_inline)) {
    r[k] = __builtin_shufflevector(s[k], s[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    r[k + 4] = __builtin_shufflevector(s[k], s[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  });
}

/// Four numbers from `first` on of the record of each lane, as four columns. `record(lane)` returns
/// a reference.
template <class V, class Record>
[[gnu::always_inline]] inline void load_columns(const Record& record, std::size_t first,
                                                V (&columns)[4]) {
  if constexpr (width_of<V> == 8) {
    columns[0] = load_fours(record(0), record(4), first);
    columns[1] = load_fours(record(1), record(5), first);
    columns[2] = load_fours(record(2), record(6), first);
    columns[3] = load_fours(record(3), record(7), first);
    transpose(columns);
  } else if constexpr (width_of<V> == 4) {
    columns[0] = load_part<V>(record(0), first);
    columns[1] = load_part<V>(record(1), first);
    columns[2] = load_part<V>(record(2), first);
    columns[3] = load_part<V>(record(3), first);
    transpose(columns);
  } else {
    unrolled<2>([&](std::size_t n) __attribute__((always_inline)) {
      const std::size_t half = 2 * n;
      const V a = load_part<V>(record(0), first + half), b = load_part<V>(record(1), first + half);
      columns[half] = __builtin_shufflevector(a, b, 0, 2);
      columns[half + 1] = __builtin_shufflevector(a, b, 1, 3);
    });
  }
}

}  // namespace mahlwerk::soft
