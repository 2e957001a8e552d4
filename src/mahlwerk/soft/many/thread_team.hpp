// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <thread>
#include <vector>

namespace mahlwerk::soft {

/// Fork-join thread team with work stealing. Items must be independent, so that results do not
/// depend on the schedule.
class ThreadTeam {
 public:
  explicit ThreadTeam(int threads);  ///< fewer if the system has no more threads
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  int size() const { return static_cast<int>(threads_.size()) + 1; }
  /// Calls `work(k)` for every k below size(), each on a thread of its own, and waits for all.
  /// `work` must not throw.
  template <class Work>
  void run_on_all(const Work& work) {
    if (threads_.empty()) return work(0);
    dispatch([](const void* w, int k) { (*static_cast<const Work*>(w))(k); }, &work);
  }
  /// Calls `work(thread, item, next)` once for every item from share[0] to share.back() - 1. Thread
  /// k starts with its own items, share[k] to share[k + 1] - 1, in order, and then steals from the
  /// end of the remaining items of other threads. `next` is the item that the thread takes after
  /// `item`; -1 if none.
  template <class Work>
  void run_items(std::span<const std::int32_t> share, const Work& work) {
    for (std::size_t k = 0; k + 1 < share.size(); ++k) ranges_[k].set(share[k], share[k + 1]);
    run_on_all([&](int thread) {
      for (std::int32_t item = take(thread), next; item >= 0; item = next) {
        next = take(thread);
        work(thread, item, next);
      }
    });
  }

 private:
  using Call = void (*)(const void* work, int k);
  /// Range of items that no thread has taken yet, in one atomic word.
  class alignas(64) WorkRange {
   public:
    void set(std::int32_t first, std::int32_t end) {
      range_.store(range(first, end), std::memory_order_relaxed);
    }
    std::int32_t take(bool from_the_end);  ///< -1 if empty

   private:
    static std::uint64_t range(std::int32_t first, std::int32_t end) {
      return std::uint64_t{static_cast<std::uint32_t>(first)} << 32 |
             static_cast<std::uint32_t>(end);
    }
    std::atomic<std::uint64_t> range_ = 0;
  };
  std::int32_t take(int thread);
  void dispatch(Call call, const void* work);
  void work_loop(int k);

  Call call_ = nullptr;
  const void* work_ = nullptr;
  std::atomic<std::uint32_t> generation_ = 0;
  std::atomic<int> busy_ = 0;
  std::atomic<bool> stopping_ = false;
  std::unique_ptr<WorkRange[]> ranges_;  // of each thread
  std::vector<std::jthread> threads_;
};

}  // namespace mahlwerk::soft
