// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "mahlwerk/base/isa.hpp"

// SIMD by templates: functions are templates on the number type V, `double` or a register of 2, 4
// or 8 doubles, with masks and selects instead of branches. Only IEEE operations, so each lane has
// the same bits as the scalar result, whatever the register width of the machine. Registers are the
// vector extension that GCC and Clang share, each of exactly the width of the instruction set:
// wider vectors would be split into scalars (docs/architecture.md, Decisions).

// Single instructions by inline assembly where GCC chooses several. Clang, which chooses well, does
// not accept registers that the surrounding function's target lacks, even if it is inlined.
#if defined(MAHLWERK_X86_64) && !defined(__clang__)
#define MAHLWERK_X86_ASM 1
#endif

namespace mahlwerk {

/// Number of lanes of a packet. A packet is computed in groups of as many lanes as fit a register.
constexpr int lanes = 8;

template <int width>
struct RegisterOf {
  typedef double Type __attribute__((vector_size(width * sizeof(double))));
  typedef double Aliased __attribute__((vector_size(width * sizeof(double)), may_alias));
  typedef std::int64_t Mask __attribute__((vector_size(width * sizeof(double))));
  typedef std::int64_t AliasedMask __attribute__((vector_size(width * sizeof(double)), may_alias));
  typedef std::uint64_t Words __attribute__((vector_size(width * sizeof(double))));
  typedef float AliasedFloats __attribute__((vector_size(width * sizeof(float)), may_alias));
};
/// A register of `width` doubles; a mask of as many lanes, 0 or -1.
template <int width>
using Register = typename RegisterOf<width>::Type;
template <int width>
using RegisterMask = typename RegisterOf<width>::Mask;

/// Number of lanes of a number type.
template <class V>
constexpr int width_of = static_cast<int>(sizeof(V) / sizeof(double));

template <class V>
concept Vector = !std::is_class_v<V> && !std::is_arithmetic_v<V> && requires(V v) {
  v[0];
};

template <class V>
struct MaskTypeOf {
  using Type = RegisterMask<width_of<V>>;
};
template <>
struct MaskTypeOf<double> {
  using Type = bool;
};
template <class V>
using MaskOf = typename MaskTypeOf<V>::Type;

/// Where both hold. Clang warns of `&` between bools.
template <class Mask>
[[gnu::always_inline]] inline Mask both(const Mask& a, const Mask& b) {
  if constexpr (std::same_as<Mask, bool>)
    return a && b;
  else
    return a & b;
}

/// A register or mask from f(lane) of each lane. No loop: GCC 12 does not unroll loops at -O1.
template <class V, class F>
[[gnu::always_inline]] inline V lanes_from(const F& f) {
  return [&]<int... lane>(std::integer_sequence<int, lane...>) __attribute__((always_inline)) {
    return V{f(lane)...};
  }
  (std::make_integer_sequence<int, width_of<V>>{});
}

template <class V>
requires(Vector<V> || std::same_as<V, double>) [[gnu::always_inline]] inline V
    select(const MaskOf<V>& which, const V& a, const V& b) {
  return which ? a : b;
}
/// a where `which`, else 0.
template <class V>
[[gnu::always_inline]] inline V where(const MaskOf<V>& which, const V& a) {
  if constexpr (std::same_as<V, double>)
    return which ? a : 0.0;
  else
    return (V)((MaskOf<V>)a & which);
}

[[gnu::always_inline]] inline double sqrt(double a) {
  return std::sqrt(a);
}
/// One instruction for all lanes: compilers take the roots of a loop one by one.
template <Vector V>
[[gnu::always_inline]] inline V sqrt(const V& a) {
  V r;
#if defined(MAHLWERK_X86_ASM)
  if constexpr (width_of<V> == 2)
    asm("sqrtpd %1, %0" : "=x"(r) : "x"(a));
  else
    asm("vsqrtpd %1, %0" : "=v"(r) : "v"(a));
#elif defined(__aarch64__) && !defined(__clang__)
  asm("fsqrt %0.2d, %1.2d" : "=w"(r) : "w"(a));
#else
  r = lanes_from<V>([&](int l) { return std::sqrt(a[l]); });
#endif
  return r;
}

/// a < b as a mask. GCC 12 splits the comparison of registers into scalars unless a select uses it.
template <class V>
requires(Vector<V> || std::same_as<V, double>)
    [[gnu::always_inline]] inline MaskOf<V> less(const V& a, const V& b) {
  if constexpr (std::same_as<V, double>)
    return a < b;
  else
    return (MaskOf<V>)(a < b ? (V)~MaskOf<V>{} : V{});  // reinterprets the bits
}

/// a > b ? a : b, and a < b ? a : b; for registers one instruction, which compilers do not choose
/// because of the rules for NaN and -0 that it shares with this definition.
template <class V>
[[gnu::always_inline]] inline V max(V a, V b) {
#if defined(MAHLWERK_X86_ASM)
  if constexpr (width_of<V> == 2) {
    asm("maxpd %1, %0" : "+x"(a) : "x"(b));
    return a;
  } else if constexpr (width_of<V> > 2) {
    V r;
    asm("vmaxpd %2, %1, %0" : "=v"(r) : "v"(a), "v"(b));
    return r;
  }
#endif
  return select(a > b, a, b);
}
template <class V>
[[gnu::always_inline]] inline V min(V a, V b) {
#if defined(MAHLWERK_X86_ASM)
  if constexpr (width_of<V> == 2) {
    asm("minpd %1, %0" : "+x"(a) : "x"(b));
    return a;
  } else if constexpr (width_of<V> > 2) {
    V r;
    asm("vminpd %2, %1, %0" : "=v"(r) : "v"(a), "v"(b));
    return r;
  }
#endif
  return select(a < b, a, b);
}
template <class V>
[[gnu::always_inline]] inline V abs(V a) {
  return select(a < V{}, -a, a);
}

/// A bit for each lane of a mask, lane 0 the lowest.
template <int width>
[[gnu::always_inline]] inline std::uint32_t bits_of(const typename RegisterOf<width>::Mask& mask) {
#if defined(MAHLWERK_X86_ASM)
  if constexpr (width == 2) {
    std::uint32_t bits;
    asm("movmskpd %1, %0" : "=r"(bits) : "x"(mask));
    return bits;
  } else if constexpr (width == 4) {
    std::uint32_t bits;
    asm("vmovmskpd %1, %0" : "=r"(bits) : "x"(mask));
    return bits;
  } else {
    std::uint8_t bits;
    asm("vpmovq2m %1, %0" : "=Yk"(bits) : "v"(mask));
    return bits;
  }
#else
  std::uint32_t bits = 0;
  for (int l = 0; l < width; ++l) bits |= mask[l] != 0 ? 1U << l : 0U;
  return bits;
#endif
}
template <class M>
[[gnu::always_inline]] inline std::uint32_t bits(const M& mask) {
  return bits_of<width_of<M>>(mask);
}

template <class M>
[[gnu::always_inline]] inline bool any(const M& mask) {
  if constexpr (std::same_as<M, bool>)
    return mask;
  else
    return bits(mask) != 0;
}
template <class M>
[[gnu::always_inline]] inline bool all(const M& mask) {
  return !any(~mask);
}

/// The mask of the lanes whose bits are set.
template <int width>
[[gnu::always_inline]] inline RegisterMask<width> mask_of(std::uint32_t bits) {
  using Mask = RegisterMask<width>;
  if constexpr (width == 8) {
    constexpr Mask lane{0, 1, 2, 3, 4, 5, 6, 7};
    return -(((Mask{} + static_cast<std::int64_t>(bits)) >> lane) & 1);
  } else {
    constexpr int count = 1 << width;
    alignas(64) static constexpr auto table = [=] {
      struct {
        std::int64_t rows[count][width];
      } t{};
      for (int b = 0; b < count; ++b)
        for (int l = 0; l < width; ++l) t.rows[b][l] = (b >> l & 1) != 0 ? -1 : 0;
      return t;
    }();
    using Aliased = typename RegisterOf<width>::AliasedMask;
    return *reinterpret_cast<const Aliased*>(table.rows[bits & (count - 1)]);
  }
}

/// Loads and stores of registers at addresses that are aligned to their size.
template <class V>
[[gnu::always_inline]] inline V load(const double* from) {
  if constexpr (std::same_as<V, double>)
    return *from;
  else
    return *reinterpret_cast<const typename RegisterOf<width_of<V>>::Aliased*>(from);
}
template <class V>
[[gnu::always_inline]] inline void store(double* to, const V& a) {
  if constexpr (std::same_as<V, double>)
    *to = a;
  else
    *reinterpret_cast<typename RegisterOf<width_of<V>>::Aliased*>(to) = a;
}

/// A 3-vector of V: one vector, or one for each lane (structure of arrays).
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
template <class V>
[[gnu::always_inline]] inline Vec<V> where(const MaskOf<V>& which, const Vec<V>& a) {
  return {where<V>(which, a.x), where<V>(which, a.y), where<V>(which, a.z)};
}

/// Storage of a number for each lane of a packet, one column. Alignment and layout are the same on
/// all machines.
struct alignas(64) Lanes {
  double values[lanes];

  double& operator[](std::size_t lane) { return values[lane]; }
  const double& operator[](std::size_t lane) const { return values[lane]; }
};
/// A mask (0 or -1), or an index, for each lane of a packet.
struct alignas(64) LaneMask {
  std::int64_t values[lanes];

  std::int64_t& operator[](std::size_t lane) { return values[lane]; }
  const std::int64_t& operator[](std::size_t lane) const { return values[lane]; }
};
/// The same number in all lanes.
constexpr Lanes broadcast(double a) {
  return {a, a, a, a, a, a, a, a};
}

/// The lanes of a packet that fill one register: `first` to `first` + width - 1.
template <class V>
struct LaneGroup {
  using Mask = MaskOf<V>;
  int first = 0;

  [[gnu::always_inline]] V operator()(const Lanes& column) const {
    return load<V>(column.values + first);
  }
  [[gnu::always_inline]] Mask operator()(const LaneMask& column) const {
    using Aliased = typename RegisterOf<width_of<V>>::AliasedMask;
    if constexpr (std::same_as<V, double>)
      return column.values[first] != 0;
    else
      return *reinterpret_cast<const Aliased*>(column.values + first);
  }
  [[gnu::always_inline]] Vec<V> operator()(const Vec<Lanes>& columns) const {
    return {(*this)(columns.x), (*this)(columns.y), (*this)(columns.z)};
  }
  /// The mask of the group's lanes, from bits of all lanes.
  [[gnu::always_inline]] Mask mask(std::uint32_t bits) const {
    return mask_of<width_of<V>>(bits >> first);
  }
  /// Bits among those of all lanes.
  [[gnu::always_inline]] std::uint32_t bits(const Mask& mask) const {
    return mahlwerk::bits(mask) << first;
  }
  [[gnu::always_inline]] void put(Lanes& column, const V& a) const {
    store<V>(column.values + first, a);
  }
  [[gnu::always_inline]] void put(LaneMask& column, const Mask& a) const {
    using Aliased = typename RegisterOf<width_of<V>>::AliasedMask;
    *reinterpret_cast<Aliased*>(column.values + first) = a;
  }
  [[gnu::always_inline]] void put(Vec<Lanes>& columns, const Vec<V>& a) const {
    put(columns.x, a.x), put(columns.y, a.y), put(columns.z, a.z);
  }
  /// Adds to a column.
  [[gnu::always_inline]] void add(Lanes& column, const V& a) const {
    put(column, (*this)(column) + a);
  }
};

}  // namespace mahlwerk
