// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <string_view>

// Which kinds of machine the innermost loops are compiled for.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define MAHLWERK_WIDE 1
#ifndef __SANITIZE_ADDRESS__  // nothing there that the other two have not, and minutes to compile
#define MAHLWERK_MIDDLING 1
#endif
#endif

namespace mahlwerk::soft {

enum class Machine { plain, middling, wide };

/// The widest registers of this machine: AVX-512, AVX2 or what every machine has; narrower if the
/// environment says MAHLWERK_SIMD=avx2 or plain. Results have the same bits on all.
inline Machine machine() {
#ifdef MAHLWERK_WIDE
  const char* wish = std::getenv("MAHLWERK_SIMD");
  const std::string_view asked = wish == nullptr ? "" : wish;
  if (asked == "plain") return Machine::plain;
  if (asked != "avx2" && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return Machine::wide;
  if (__builtin_cpu_supports("avx2")) return Machine::middling;
#endif
  return Machine::plain;
}

}  // namespace mahlwerk::soft
