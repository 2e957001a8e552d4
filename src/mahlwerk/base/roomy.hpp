// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace mahlwerk {

/// Memory for large arrays read in no order: asks for large pages, whose addresses the processor need
/// not look up so often.
template <class T>
struct RoomyAllocator {
  using value_type = T;
  RoomyAllocator() = default;
  template <class U>
  RoomyAllocator(const RoomyAllocator<U>&) {}  // NOLINT: the conversion allocators must have

  T* allocate(std::size_t count) {
    constexpr std::size_t page = std::size_t{1} << 21;
    const std::size_t bytes = count * sizeof(T);
    const std::size_t align = bytes < page ? 64 : page;
    void* const memory = std::aligned_alloc(align, (bytes + align - 1) / align * align);
    if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    if (bytes >= page) madvise(memory, bytes, MADV_HUGEPAGE);  // a wish; nothing depends on it
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }
  template <class U>
  bool operator==(const RoomyAllocator<U>&) const {
    return true;
  }
};

template <class T>
using RoomyVector = std::vector<T, RoomyAllocator<T>>;

}  // namespace mahlwerk
