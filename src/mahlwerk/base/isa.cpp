// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/isa.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/printable.hpp"

namespace mahlwerk {
namespace {

/// Words of MAHLWERK_SIMD that work here.
std::string supported_words() {
  std::string words;
  for (const Isa isa : all_isas)
    if (is_supported(isa))
      words += fmt::format("{}{} ({})", words.empty() ? "" : ", ", word_of(isa), name_of(isa));
  return words;
}

}  // namespace

std::string_view name_of(Isa isa) {
  if (isa == Isa::avx512) return "AVX-512";
  if (isa == Isa::avx2) return "AVX2";
#if defined(__x86_64__)
  return "SSE2";
#elif defined(__aarch64__)
  return "NEON";
#else
  return "none";
#endif
}

std::string_view word_of(Isa isa) {
  return isa == Isa::avx512 ? "avx512" : isa == Isa::avx2 ? "avx2" : "plain";
}

bool is_supported(Isa isa) {
  if (isa == Isa::baseline) return true;
#ifdef MAHLWERK_WIDE
  if (isa == Isa::avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
  return __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

Isa isa() {
  const char* value = std::getenv("MAHLWERK_SIMD");
  const std::string_view word = value == nullptr ? "" : value;
  for (const Isa isa : all_isas)
    if (is_supported(isa) && (word.empty() || word == word_of(isa))) return isa;
  const bool known = std::ranges::find(all_isas, word, word_of) != all_isas.end();
  throw InputError(Fault{"MAHLWERK_SIMD",
                         known ? fmt::format("{} is not supported here", word)
                               : fmt::format("'{}' is not an instruction set", printable(word)),
                         "unset the variable, or set it to one of: " + supported_words(),
                         {}});
}

}  // namespace mahlwerk
