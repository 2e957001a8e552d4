// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

// Instruction sets, and function multiversioning: a loop is compiled once for each of them, and the
// machine decides which one runs. Each loop is a template on the number of doubles in a register
// (base/lanes.hpp).

#if defined(__x86_64__) && defined(__GNUC__)
#define MAHLWERK_X86_64 1
// Under AddressSanitizer only the baseline is compiled: the same source, and sanitizers multiply
// the time of the compiler.
#ifndef __SANITIZE_ADDRESS__
#define MAHLWERK_WIDE 1
#endif
#endif

namespace mahlwerk {

/// `baseline` is what every processor of the architecture has: SSE2 on x86-64, NEON on ARM64.
enum class Isa { baseline, avx2, avx512 };

/// The widest first.
inline constexpr std::array all_isas{Isa::avx512, Isa::avx2, Isa::baseline};

/// Number of doubles in a register.
constexpr int register_width(Isa isa) {
  return isa == Isa::avx512 ? 8 : isa == Isa::avx2 ? 4 : 2;
}

/// "AVX-512", "AVX2", "SSE2", "NEON".
std::string_view name_of(Isa isa);
/// Its value of MAHLWERK_SIMD: avx512, avx2, plain.
std::string_view word_of(Isa isa);

/// Whether this machine has `isa` and this program code for it.
bool is_supported(Isa isa);

/// The instruction set of all vector loops: the widest that is supported, or the one that the
/// environment variable MAHLWERK_SIMD selects (word_of). Results have the same bits on all. Throws
/// InputError if the variable has another value or names an instruction set that is not supported.
Isa isa();

/// Function multiversioning: `Body::run<width>`, with everything it calls inlined into one function
/// of type F for each instruction set.
template <class Body, class F>
struct Multiversioned;
template <class Body, class Result, class... In>
struct Multiversioned<Body, Result (*)(In...)> {
#ifdef MAHLWERK_WIDE
  [[gnu::target("avx512f,avx512dq,avx512vl"), gnu::flatten]] static Result avx512(In... in) {
    return Body::template run<register_width(Isa::avx512)>(in...);
  }
  [[gnu::target("avx2"), gnu::flatten]] static Result avx2(In... in) {
    return Body::template run<register_width(Isa::avx2)>(in...);
  }
#endif
  [[gnu::flatten]] static Result baseline(In... in) {
    return Body::template run<register_width(Isa::baseline)>(in...);
  }

  /// The function for this machine.
  static auto best() -> Result (*)(In...) {
#ifdef MAHLWERK_WIDE
    const Isa chosen = isa();
    if (chosen == Isa::avx512) return avx512;
    if (chosen == Isa::avx2) return avx2;
#endif
    return baseline;
  }
};

}  // namespace mahlwerk
