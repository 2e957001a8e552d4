// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <set>

#include "mahlwerk/soft/many/chunk.hpp"

namespace mahlwerk::soft::verlet_list_test {
namespace {

/// A Verlet list with `each` pairs in every bin, numbered consecutively.
VerletList waiting(int each) {
  VerletList w;
  for (std::int32_t k = 0; k < each * VerletList::bins; ++k) w.pairs.push_back({k, k + 1});
  for (int b = 0; b <= VerletList::bins; ++b) w.end[static_cast<std::size_t>(b)] = each * b;
  return w;
}

TEST(VerletList, those_due_are_all_that_can_have_come_near) {
  const VerletList w = waiting(3);
  EXPECT_EQ(w.due(0, 0.1), 3U);  // gaps from 0 on
  EXPECT_EQ(w.due(0.0999, 0.1), 3U);
  EXPECT_EQ(w.due(0.1001, 0.1), 6U);  // gaps from 0.1 on
  EXPECT_EQ(w.due(100, 0.1), w.pairs.size());
}

TEST(VerletList, removal_leaves_every_other_pair_in_its_bin) {
  VerletList w = waiting(3);
  std::set<std::int32_t> gone;
  while (!w.pairs.empty()) {
    const std::size_t at = (7 * w.pairs.size()) / 11;
    gone.insert(w.pairs[at].ball);
    w.remove(at);
    std::set<std::int32_t> left;
    for (std::size_t b = 0; b < VerletList::bins; ++b)
      for (auto k = w.end[b]; k < w.end[b + 1]; ++k) {
        const std::int32_t ball = w.pairs[static_cast<std::size_t>(k)].ball;
        EXPECT_EQ(ball / 3, static_cast<std::int32_t>(b)) << "not its bin";
        EXPECT_FALSE(gone.contains(ball));
        left.insert(ball);
      }
    ASSERT_EQ(left.size() + gone.size(), 3U * VerletList::bins);
  }
}

}  // namespace
}  // namespace mahlwerk::soft::verlet_list_test
