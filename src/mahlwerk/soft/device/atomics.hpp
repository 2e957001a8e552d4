// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

// Atomic operations on whole numbers, the same on the host and on a graphics card. Sums of floating
// numbers are never atomic: their bits would depend on the order.
namespace mahlwerk::soft {

/// Adds to a number and returns what it was.
template <class T>
inline T atomic_add(T* to, T more) {
  return __atomic_fetch_add(to, more, __ATOMIC_RELAXED);
}

/// A word that other threads may set to a value that tells this one nothing new. A card takes it
/// from its cache.
template <class T>
inline T shared_word(const T& word) {
#ifdef __CUDA_ARCH__
  return word;
#else
  return __atomic_load_n(&word, __ATOMIC_RELAXED);
#endif
}
/// Sets a word that several threads set to the same value.
template <class T>
inline void set_shared(T& word, T value) {
  __atomic_store_n(&word, value, __ATOMIC_RELAXED);
}

/// Lowers a number to `value` where it is larger.
inline void atomic_lower(std::int32_t* to, std::int32_t value) {
  std::int32_t was = __atomic_load_n(to, __ATOMIC_RELAXED);
  while (value < was &&
         !__atomic_compare_exchange_n(to, &was, value, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
  }
}

}  // namespace mahlwerk::soft
