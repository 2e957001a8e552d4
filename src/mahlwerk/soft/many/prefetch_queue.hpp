// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace mahlwerk::soft {

/// Queue of memory ranges to prefetch, a few cache lines at a time between other work. Requests
/// issued all at once would stall.
class PrefetchQueue {
 public:
  template <class T>
  void add(const T* from, std::size_t count) {
    if (count == 0 || count_ == ranges_.size()) return;
    const auto* first = reinterpret_cast<const char*>(from);
    const std::size_t bytes = count * sizeof(T);
    ranges_[count_++] = {first, first + bytes};
    share_ += bytes / line + 1;
  }
  /// Divides the queue into parts, one for each call of fetch().
  void divide(std::size_t parts) { share_ = share_ / (parts + 1) + 1; }

  /// Prefetches the next part.
  [[gnu::always_inline]] void fetch() {
    std::size_t left = share_;
    while (at_ < count_ && left > 0) {
      Range& r = ranges_[at_];
      for (; left > 0 && r.next < r.end; r.next += line, --left) __builtin_prefetch(r.next, 0, 2);
      if (r.next >= r.end) ++at_;
    }
  }

 private:
  static constexpr std::size_t line = 64;
  struct Range {
    const char *next = nullptr, *end = nullptr;
  };
  std::array<Range, 128> ranges_;
  std::size_t count_ = 0, at_ = 0, share_ = 0;  // lines
};

}  // namespace mahlwerk::soft
