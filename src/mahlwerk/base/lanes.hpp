// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

// SIMD by templates: functions are templates on the number type V, `double` or `Lanes` (eight
// doubles), with masks and selects instead of branches. Only IEEE operations, so each lane has the
// same bits as the scalar result, whatever the register width of the machine.

// Attribute of a function: compiles it for several instruction sets (function multiversioning); the
// best one is selected at run time. Only with GCC, and not under the thread sanitizer, which
// crashes on such functions.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define MAHLWERK_CLONES [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
#else
#define MAHLWERK_CLONES
#endif

namespace mahlwerk {

constexpr int lanes = 8;
using Lanes = double __attribute__((vector_size(lanes * sizeof(double))));
using LaneMask = std::int64_t __attribute__((vector_size(lanes * sizeof(std::int64_t))));  // 0, -1

/// Storage of eight numbers. The alignment is that of the widest registers, independent of the
/// instruction set that a file is compiled for.
struct alignas(64) AlignedLanes {
  Lanes value{};
};

template <class V>
using MaskOf = std::conditional_t<std::is_same_v<V, double>, bool, LaneMask>;

[[gnu::always_inline]] inline double select(bool which, double a, double b) {
  return which ? a : b;
}
[[gnu::always_inline]] inline Lanes select(LaneMask which, Lanes a, Lanes b) {
  return which ? a : b;
}

[[gnu::always_inline]] inline double sqrt(double a) {
  return std::sqrt(a);
}
[[gnu::always_inline]] inline Lanes sqrt(Lanes a) {
  Lanes r;
  for (int l = 0; l < lanes; ++l) r[l] = std::sqrt(a[l]);
  return r;
}

template <class V>
[[gnu::always_inline]] inline V max(V a, V b) {
  return select(a > b, a, b);
}
template <class V>
[[gnu::always_inline]] inline V min(V a, V b) {
  return select(a < b, a, b);
}
template <class V>
[[gnu::always_inline]] inline V abs(V a) {
  return select(a < V{}, -a, a);
}

/// a < b as a mask. GCC 12 splits a comparison of eight numbers into scalars unless a select uses
/// it.
[[gnu::always_inline]] inline bool less(double a, double b) {
  return a < b;
}
[[gnu::always_inline]] inline LaneMask less(Lanes a, Lanes b) {
  return (LaneMask)(a < b ? (Lanes)~LaneMask{} : Lanes{});  // reinterprets the bits
}
[[gnu::always_inline]] inline bool any(bool mask) {
  return mask;
}
[[gnu::always_inline]] inline bool any(LaneMask mask) {
  LaneMask all = mask | __builtin_shufflevector(mask, mask, 4, 5, 6, 7, 0, 1, 2, 3);
  all |= __builtin_shufflevector(all, all, 2, 3, 0, 1, 6, 7, 4, 5);
  return (all[0] | all[1]) != 0;
}
[[gnu::always_inline]] inline bool all(LaneMask mask) {
  return !any(~mask);
}

/// A 3-vector of V: one vector, or eight (structure of arrays).
template <class V>
struct Vec {
  V x, y, z;

  [[gnu::always_inline]] friend Vec operator+(const Vec& a, const Vec& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  [[gnu::always_inline]] friend Vec operator-(const Vec& a, const Vec& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  [[gnu::always_inline]] friend Vec operator-(const Vec& a) { return {-a.x, -a.y, -a.z}; }
  [[gnu::always_inline]] friend Vec operator*(const V& s, const Vec& a) {
    return {s * a.x, s * a.y, s * a.z};
  }
  [[gnu::always_inline]] friend Vec operator*(double s,
                                              const Vec& a) requires(!std::is_same_v<V, double>) {
    return {s * a.x, s * a.y, s * a.z};
  }
};
template <class V>
[[gnu::always_inline]] inline V dot(const Vec<V>& a, const Vec<V>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class V>
[[gnu::always_inline]] inline Vec<V> cross(const Vec<V>& a, const Vec<V>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class V>
[[gnu::always_inline]] inline Vec<V> select(const MaskOf<V>& which, const Vec<V>& a,
                                            const Vec<V>& b) {
  return {select(which, a.x, b.x), select(which, a.y, b.y), select(which, a.z, b.z)};
}

}  // namespace mahlwerk
