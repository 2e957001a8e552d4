// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
#pragma GCC system_header
#pragma GCC diagnostic ignored "-Wparentheses"

// The switches of tools/mutants, which defines MAHLWERK_BREAKS, their number. `a + b` with the
// switch 7 is `a + At<7>{} + b`: both operators have the places of the one, so that the expression
// keeps its meaning.
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <type_traits>
#include <utility>
namespace mahlwerk_breaks {

/// Which places were reached, and in which a type has no other operator; written at the end of the
/// program into the file that MAHLWERK_BREAK_REACHED names.
struct Places {
  std::atomic<bool> reached[MAHLWERK_BREAKS]{}, unchanged[MAHLWERK_BREAKS]{};
  int chosen = std::getenv("MAHLWERK_BREAK") ? std::atoi(std::getenv("MAHLWERK_BREAK")) : -1;
  ~Places() {
    const char* name = std::getenv("MAHLWERK_BREAK_REACHED");
    std::FILE* file = name ? std::fopen(name, "a") : nullptr;
    if (!file) return;
    for (int i = 0; i < MAHLWERK_BREAKS; ++i)
      if (reached[i] || unchanged[i]) std::fprintf(file, "%d %d\n", i, unchanged[i] ? 1 : 0);
    std::fclose(file);
  }
};
inline Places& places() {
  static Places all;
  return all;
}
template <int N>
[[gnu::always_inline]] inline bool on() {
  static Places& all = places();
  if (!all.reached[N].load(std::memory_order_relaxed))
    all.reached[N].store(true, std::memory_order_relaxed);
  return all.chosen == N;
}
template <int N>
[[gnu::always_inline]] inline bool off() {
  return !on<N>();
}
template <int N>
inline void unchanged() {
  places().unchanged[N] = true;
}

/// Between an operator and its right operand.
template <int N>
struct At {};
template <class A, int N, char S>
struct Left {
  A&& a;
};
template <class T>
using Plain = std::remove_cvref_t<T>;
#define MAHLWERK_OPERATOR(SIGN, LETTER, OTHER, ELSE)                                   \
  template <class A, int N>                                                            \
  [[gnu::always_inline]] inline Left<A, N, LETTER> operator SIGN(A&& a, At<N>) {       \
    return {std::forward<A>(a)};                                                       \
  }                                                                                    \
  template <class A, int N, class B>                                                   \
  [[gnu::always_inline]] inline auto operator SIGN(Left<A, N, LETTER> l, B&& b) {      \
    using R = Plain<decltype(l.a SIGN b)>;                                             \
    if constexpr (requires {                                                           \
                    {l.a OTHER b};                                                     \
                    requires std::is_same_v<Plain<decltype(l.a OTHER b)>, R>;          \
                  })                                                                   \
      return on<N>() ? R(l.a OTHER b) : R(l.a SIGN b);                                 \
    else if constexpr (requires {                                                      \
                         {l.a SIGN b ELSE};                                            \
                         requires std::is_same_v<Plain<decltype(l.a SIGN b ELSE)>, R>; \
                       })                                                              \
      return on<N>() ? R(l.a SIGN b ELSE) : R(l.a SIGN b);                             \
    else {                                                                             \
      unchanged<N>();                                                                  \
      return R(l.a SIGN b);                                                            \
    }                                                                                  \
  }
MAHLWERK_OPERATOR(*, '*', /, *2.0)
MAHLWERK_OPERATOR(/, '/', *, *2.0)
MAHLWERK_OPERATOR(+, '+', -, +1)
MAHLWERK_OPERATOR(-, '-', +, +1)
MAHLWERK_OPERATOR(<, '<', >=, )
MAHLWERK_OPERATOR(>, '>', <=, )
MAHLWERK_OPERATOR(<=, 'l', >, )
MAHLWERK_OPERATOR(>=, 'g', <, )
MAHLWERK_OPERATOR(==, '=', !=, )
MAHLWERK_OPERATOR(!=, '!', ==, )
template <int N, class B>
bool operator^(At<N>, B&& b) {
  return static_cast<bool>(b) != on<N>();
}

/// `a += b` is `a += Added<7>{} += b`.
template <int N>
struct Added {
  template <class B>
  [[gnu::always_inline]] inline Plain<B> operator+=(B&& b) {
    if constexpr (requires {
                    {-b};
                    requires std::is_same_v<Plain<decltype(-b)>, Plain<B>>;
                  })
      return on<N>() ? Plain<B>(-b) : Plain<B>(std::forward<B>(b));
    else
      return on<N>() ? Plain<B>{} : Plain<B>(std::forward<B>(b));
  }
};

/// `a *= b` is `a *= Scaled<7>{} *= b`.
template <int N>
struct Scaled {
  template <class B>
  [[gnu::always_inline]] inline Plain<B> operator*=(B&& b) {
    return on<N>() ? Plain<B>(b + b) : Plain<B>(std::forward<B>(b));
  }
};

template <int N, class T>
T least(const T& a, const T& b) {
  return (b < a) != on<N>() ? b : a;
}
template <int N, class T>
T most(const T& a, const T& b) {
  return (a < b) != on<N>() ? b : a;
}
template <int N, class T>
T least(std::initializer_list<T> l) {
  return on<N>() ? std::max(l) : std::min(l);
}
template <int N, class T>
T most(std::initializer_list<T> l) {
  return on<N>() ? std::min(l) : std::max(l);
}

}  // namespace mahlwerk_breaks
