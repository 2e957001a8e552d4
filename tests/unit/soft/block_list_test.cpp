// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/many/block_list.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>

namespace mahlwerk::soft::block_list_test {
namespace {

struct alignas(64) Item {
  int number = 7;
};

TEST(BlockList, growth_moves_no_element) {
  BlockList<Item> list;
  EXPECT_TRUE(list.empty());
  const Item* const first = &list.emplace_back();
  for (int n = 1; n < 100; ++n) list.emplace_back().number = n;
  EXPECT_EQ(list.size(), 100U);
  EXPECT_EQ(&list[0], first);
  EXPECT_EQ(list[0].number, 7) << "the default value";
  for (std::size_t n = 1; n < 100; ++n) {
    EXPECT_EQ(list[n].number, static_cast<int>(n));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(&list[n]) % alignof(Item), 0U);
  }
}

TEST(BlockList, a_reused_block_has_default_values) {
  for (int turn = 0; turn < 2; ++turn) {
    BlockList<Item> list;
    for (int n = 0; n < 20; ++n) {
      EXPECT_EQ(list.emplace_back().number, 7);
      list[static_cast<std::size_t>(n)].number = n;
    }
  }
}

TEST(BlockList, other_blocks_survive_the_freeing_of_one) {
  BlockList<Item> list;
  for (int n = 0; n < 20; ++n) list.emplace_back().number = n;
  list.free_block(1);
  list.free_block(9);  // does not exist
  EXPECT_EQ(list[7].number, 7);
  EXPECT_EQ(list[16].number, 16);
  const BlockList<Item> moved = std::move(list);
  EXPECT_EQ(moved[19].number, 19);
}

}  // namespace
}  // namespace mahlwerk::soft::block_list_test
