// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/huge_page_allocator.hpp"

#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace mahlwerk {

void* allocate_huge_pages(std::size_t bytes) {
  constexpr std::size_t line = 64, page = std::size_t{1} << 21;
  const std::size_t align = bytes < page ? line : page;
  void* const memory = std::aligned_alloc(align, (bytes + align - 1) / align * align);
  if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  // A hint to the kernel; nothing depends on it. It excludes the last partial page, which a huge
  // page would round up.
  if (bytes >= page) madvise(memory, bytes / page * page, MADV_HUGEPAGE);
#endif
  return memory;
}

void free_huge_pages(void* memory) {
  std::free(memory);
}

}  // namespace mahlwerk
