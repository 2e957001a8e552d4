// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <memory_resource>
#include <type_traits>
#include <vector>

namespace mahlwerk::soft {

/// Memory of all blocks, shared by all solvers. It is apart from other memory: blocks between large
/// arrays would leave holes that no large array fits. It keeps freed blocks until the program ends.
inline std::pmr::memory_resource& block_memory() {
  static std::pmr::synchronized_pool_resource memory(std::pmr::pool_options{64, 1 << 14});
  return memory;
}

/// List that grows in blocks of one size: growth copies no element, and the memory of a freed block
/// serves any other list.
template <class T>
class BlockList {
 public:
  static constexpr std::size_t block_size = 8;  ///< elements
  using Block = std::array<T, block_size>;
  struct FreeBlock {
    void operator()(Block* block) const {
      block_memory().deallocate(block, sizeof(Block), alignof(Block));
    }
  };
  using Blocks = std::vector<std::unique_ptr<Block, FreeBlock>>;

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  T& operator[](std::size_t n) { return (*blocks_[n / block_size])[n % block_size]; }
  const T& operator[](std::size_t n) const { return (*blocks_[n / block_size])[n % block_size]; }
  const Blocks& blocks() const { return blocks_; }

  /// Adds an element with its default value.
  T& emplace_back() {
    if (size_ == block_size * blocks_.size())
      blocks_.emplace_back(new (block_memory().allocate(sizeof(Block), alignof(Block))) Block());
    return (*this)[size_++];
  }
  /// Frees block `n`, if there is one. Its elements must not be used any more.
  void free_block(std::size_t n) {
    if (n < blocks_.size()) blocks_[n].reset();
  }

 private:
  static_assert(std::is_trivially_destructible_v<T>);
  Blocks blocks_;
  std::size_t size_ = 0;
};

}  // namespace mahlwerk::soft
