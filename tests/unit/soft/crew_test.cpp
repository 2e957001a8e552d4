// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/crew.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace mahlwerk::soft {
namespace {

TEST(Crew, does_every_share_once_each_time) {
  for (const int threads : {1, 2, 5}) {
    Crew crew(threads);
    ASSERT_EQ(crew.size(), threads);
    std::vector<int> done(static_cast<std::size_t>(threads));
    for (int turn = 1; turn <= 2000; ++turn) {
      crew.all([&](int k) { ++done[static_cast<std::size_t>(k)]; });
      ASSERT_EQ(std::accumulate(done.begin(), done.end(), 0), turn * threads);
    }
    for (const int count : done) EXPECT_EQ(count, 2000);
  }
}

TEST(Crew, that_never_worked_goes_home) {
  const Crew crew(4);
  EXPECT_EQ(crew.size(), 4);
}

}  // namespace
}  // namespace mahlwerk::soft
