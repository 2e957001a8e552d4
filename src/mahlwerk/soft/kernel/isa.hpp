// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <string_view>

// Instruction sets for which the innermost loops are compiled.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define MAHLWERK_AVX512 1
// No AVX2 copy under AddressSanitizer: it takes minutes to compile and tests nothing that the
// others do not.
#ifndef __SANITIZE_ADDRESS__
#define MAHLWERK_AVX2 1
#endif
#endif

namespace mahlwerk::soft {

enum class Isa { baseline, avx2, avx512 };

/// The widest instruction set of this machine. The environment variable MAHLWERK_SIMD selects a
/// narrower one: avx2, or plain for the baseline (SSE2 on x86-64). Results have the same bits on
/// all.
inline Isa isa() {
#ifdef MAHLWERK_AVX512
  const char* wish = std::getenv("MAHLWERK_SIMD");
  const std::string_view asked = wish == nullptr ? "" : wish;
  if (asked == "plain") return Isa::baseline;
  if (asked != "avx2" && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return Isa::avx512;
  if (__builtin_cpu_supports("avx2")) return Isa::avx2;
#endif
  return Isa::baseline;
}

/// Function multiversioning: `Body::run<avx512>`, inlined into one function of type F for each
/// instruction set.
template <class Body, class F>
struct Multiversioned;
template <class Body, class Result, class... In>
struct Multiversioned<Body, Result (*)(In...)> {
#ifdef MAHLWERK_AVX512
  [[gnu::target("avx512f,avx512dq,avx512vl"), gnu::flatten]] static Result avx512(In... in) {
    return Body::template run<true>(in...);
  }
#endif
#ifdef MAHLWERK_AVX2
  [[gnu::target("avx2"), gnu::flatten]] static Result avx2(In... in) {
    return Body::template run<false>(in...);
  }
#endif
  [[gnu::flatten]] static Result baseline(In... in) {
    return Body::template run<false>(in...);
  }

  /// The function for this machine.
  static auto best() -> Result (*)(In...) {
#ifdef MAHLWERK_AVX512
    if (isa() == Isa::avx512) return avx512;
#endif
#ifdef MAHLWERK_AVX2
    if (isa() == Isa::avx2) return avx2;
#endif
    return baseline;
  }
};

}  // namespace mahlwerk::soft
