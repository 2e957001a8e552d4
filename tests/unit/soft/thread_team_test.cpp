// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/many/thread_team.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <thread>
#include <vector>

namespace mahlwerk::soft::thread_team_test {
namespace {

TEST(ThreadTeam, runs_on_every_thread_once_each_time) {
  for (const int threads : {1, 2, 5}) {
    ThreadTeam team(threads);
    ASSERT_EQ(team.size(), threads);
    std::vector<int> done(static_cast<std::size_t>(threads));
    for (int turn = 1; turn <= 2000; ++turn) {
      team.run_on_all([&](int k) { ++done[static_cast<std::size_t>(k)]; });
      ASSERT_EQ(std::accumulate(done.begin(), done.end(), 0), turn * threads);
    }
    for (const int count : done) EXPECT_EQ(count, 2000);
  }
}

TEST(ThreadTeam, does_every_item_once_and_next_what_it_says) {
  ThreadTeam team(3);
  const std::vector<std::int32_t> share{0, 40, 41, 100};
  for (int turn = 0; turn < 500; ++turn) {
    std::vector<std::int32_t> done(100);
    std::vector<std::int32_t> promised(3, -2);
    team.run_items(share, [&](int thread, std::int32_t item, std::int32_t next) {
      std::int32_t& mine = promised[static_cast<std::size_t>(thread)];
      EXPECT_TRUE(mine == -2 || mine == item);
      mine = next;
      ++done[static_cast<std::size_t>(item)];
    });
    for (const std::int32_t times : done) ASSERT_EQ(times, 1);
    for (const std::int32_t last : promised) EXPECT_LT(last, 0) << "promised and not done";
  }
}

TEST(ThreadTeam, takes_from_a_thread_that_is_slow) {
  ThreadTeam team(2);
  const std::vector<std::int32_t> share{0, 10, 10};  // the second thread has none
  std::atomic<int> done = 0;
  team.run_items(share, [&](int thread, std::int32_t item, std::int32_t) {
    const auto began = std::chrono::steady_clock::now();
    while (thread == 0 && item == 0 && done < 8 &&  // all but this item and the next
           std::chrono::steady_clock::now() - began < std::chrono::seconds(20))
      std::this_thread::yield();
    if (thread == 0 && item == 0) {
      EXPECT_EQ(done, 8);
    }
    ++done;
  });
  EXPECT_EQ(done, 10);
}

TEST(ThreadTeam, that_never_worked_ends) {
  const ThreadTeam team(4);
  EXPECT_EQ(team.size(), 4);
}

}  // namespace
}  // namespace mahlwerk::soft::thread_team_test
