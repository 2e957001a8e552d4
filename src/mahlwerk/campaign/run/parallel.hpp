// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "mahlwerk/base/start_threads.hpp"

namespace mahlwerk::campaign {

/// Calls `work(i)` for every i below `count`. The first exception ends the loop and is rethrown
/// here.
template <class Work>
void in_parallel(int threads, std::size_t count, const Work& work) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failed;
  const auto worker = [&] {
    for (std::size_t i = next++; i < count; i = next++) try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(failed);
        if (!failure) failure = std::current_exception();
        next = count;
      }
  };
  {
    std::vector<std::jthread> team;
    start_threads(team, std::min(threads, static_cast<int>(count)) - 1, [&](int) { worker(); });
    worker();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace mahlwerk::campaign
