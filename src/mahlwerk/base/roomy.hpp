// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace mahlwerk {

/// Memory for large arrays read in no order: asks for large pages, whose addresses the processor
/// need not look up so often. Throws std::bad_alloc.
void* roomy_memory(std::size_t bytes);
void give_back(void* memory);

template <class T>
struct RoomyAllocator {
  using value_type = T;
  RoomyAllocator() = default;
  template <class U>
  RoomyAllocator(const RoomyAllocator<U>&) {}  // NOLINT: the conversion allocators must have

  T* allocate(std::size_t count) { return static_cast<T*>(roomy_memory(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t) { give_back(memory); }
  template <class U>
  bool operator==(const RoomyAllocator<U>&) const {
    return true;
  }
};

template <class T>
using RoomyVector = std::vector<T, RoomyAllocator<T>>;

}  // namespace mahlwerk
