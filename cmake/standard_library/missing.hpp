// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Parts of C++20's standard library that libc++ 13 lacks (Debian's Emscripten, older compilers of
// Apple). A build with such a library includes this file before every other; no other build reads
// it, and no source names it. Algorithms over ranges are those of range-v3, of which the standard's
// are a copy; numbers are read by fast_float and written from the digits of {fmt}.
#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <range/v3/algorithm.hpp>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

_LIBCPP_BEGIN_NAMESPACE_STD

namespace ranges {
using ::ranges::all_of;
using ::ranges::any_of;
using ::ranges::binary_search;
using ::ranges::copy;
using ::ranges::copy_if;
using ::ranges::count;
using ::ranges::count_if;
using ::ranges::equal;
using ::ranges::fill;
using ::ranges::find;
using ::ranges::find_if;
using ::ranges::is_sorted;
using ::ranges::lexicographical_compare;
using ::ranges::lower_bound;
using ::ranges::max;
using ::ranges::max_element;
using ::ranges::min;
using ::ranges::min_element;
using ::ranges::minmax;
using ::ranges::minmax_element;
using ::ranges::move;
using ::ranges::none_of;
using ::ranges::nth_element;
using ::ranges::partial_sort;
using ::ranges::replace;
using ::ranges::replace_if;
using ::ranges::reverse;
using ::ranges::sort;
using ::ranges::stable_sort;
using ::ranges::transform;
using ::ranges::unique;
using ::ranges::upper_bound;
}  // namespace ranges

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

/// A thread that is joined at its end. It is never asked to stop.
class jthread {
 public:
  template <class... In>
  explicit jthread(In&&... in) : thread_(std::forward<In>(in)...) {}
  jthread(jthread&&) = default;
  jthread& operator=(jthread&&) = delete;
  ~jthread() {
    if (thread_.joinable()) thread_.join();
  }

 private:
  thread thread_;
};

template <class T>
class atomic_ref {
 public:
  explicit atomic_ref(T& object) : object_(&object) {}
  T fetch_sub(T by) const { return __atomic_fetch_sub(object_, by, __ATOMIC_SEQ_CST); }

 private:
  T* object_;
};

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const fast_float::from_chars_result read = fast_float::from_chars(first, last, value);
  return {read.ptr, read.ec};
}

namespace mahlwerk_digits {

/// The shortest digits that are read as the same number, and the power of ten of the first.
struct Decimal {
  string digits, sign;
  int exponent = 0;
};
inline Decimal decimal(double value) {
  const string text = fmt::format("{}", value);
  Decimal made;
  const size_t e = text.find('e');
  int point = 0;  // digits before the decimal point
  bool after = false;
  for (const char c : text.substr(0, e)) {
    if (c == '-') made.sign = "-";
    if (c == '.') after = true;
    if (c < '0' || c > '9') continue;
    if (made.digits.empty() && c == '0') {
      if (after) --point;
      continue;
    }
    made.digits += c;
    if (!after) ++point;
  }
  if (made.digits.empty()) return {"0", made.sign, 0};
  made.exponent = point - 1 + (e == string::npos ? 0 : atoi(text.c_str() + e + 1));
  while (made.digits.size() > 1 && made.digits.back() == '0') made.digits.pop_back();
  return made;
}
inline string scientific(const Decimal& n) {
  string text = n.sign + n.digits.substr(0, 1);
  if (n.digits.size() > 1) text += "." + n.digits.substr(1);
  return text + fmt::format("e{}{:02}", n.exponent < 0 ? '-' : '+',
                            n.exponent < 0 ? -n.exponent : n.exponent);
}
/// All digits are exact: those of a large number as the binary number has them.
inline string fixed(double value, const Decimal& n) {
  const int count = static_cast<int>(n.digits.size());
  if (n.exponent < 0)
    return n.sign + "0." + string(static_cast<size_t>(-n.exponent - 1), '0') + n.digits;
  if (n.exponent >= count) return fmt::format("{:.0f}", value);
  const auto whole = static_cast<size_t>(n.exponent + 1);
  string text = n.sign + n.digits.substr(0, whole);
  if (whole < n.digits.size()) text += "." + n.digits.substr(whole);
  return text;
}
inline to_chars_result put(char* first, char* last, const string& text) {
  if (last - first < static_cast<ptrdiff_t>(text.size())) return {last, errc::value_too_large};
  return {std::copy(text.begin(), text.end(), first), errc()};
}

}  // namespace mahlwerk_digits

inline to_chars_result to_chars(char* first, char* last, double value, chars_format format) {
  const auto n = mahlwerk_digits::decimal(value);
  return mahlwerk_digits::put(first, last,
                              value - value != 0              ? fmt::format("{}", value)
                              : format == chars_format::fixed ? mahlwerk_digits::fixed(value, n)
                                                              : mahlwerk_digits::scientific(n));
}
/// The shorter of both forms.
inline to_chars_result to_chars(char* first, char* last, double value) {
  if (value - value != 0) return to_chars(first, last, value, chars_format::fixed);
  const auto n = mahlwerk_digits::decimal(value);
  const string scientific = mahlwerk_digits::scientific(n),
               fixed = mahlwerk_digits::fixed(value, n);
  return mahlwerk_digits::put(first, last, fixed.size() <= scientific.size() ? fixed : scientific);
}
inline to_chars_result to_chars(char* first, char* last, double value, chars_format format,
                                int precision) {
  char text[400];
  const char* how = format == chars_format::fixed        ? "%.*f"
                    : format == chars_format::scientific ? "%.*e"
                                                         : "%.*g";
  snprintf(text, sizeof text, how, precision, value);
  return mahlwerk_digits::put(first, last, text);
}

_LIBCPP_END_NAMESPACE_STD
