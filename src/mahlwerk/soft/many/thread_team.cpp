// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/many/thread_team.hpp"

#include <algorithm>

#include "mahlwerk/base/start_threads.hpp"

namespace mahlwerk::soft {
namespace {

constexpr int spin_polls = 1000;  // polls before a thread sleeps: about ten microseconds

/// Waits until `value` differs from `old`: spins, then sleeps.
template <class T>
void wait_while(const std::atomic<T>& value, T old) {
  for (int i = 0; i < spin_polls; ++i) {
    if (value.load(std::memory_order_acquire) != old) return;
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

ThreadTeam::ThreadTeam(int threads)
    : ranges_(new WorkRange[static_cast<std::size_t>(std::max(threads, 1))]) {
  start_threads(threads_, threads - 1, [this](int k) { work_loop(k); });
}

std::int32_t ThreadTeam::WorkRange::take(bool from_the_end) {
  std::uint64_t old = range_.load(std::memory_order_relaxed);
  for (;;) {
    const auto first = static_cast<std::int32_t>(old >> 32);
    const auto end = static_cast<std::int32_t>(old & 0xffffffff);
    if (first >= end) return -1;
    const std::uint64_t rest = from_the_end ? range(first, end - 1) : range(first + 1, end);
    if (range_.compare_exchange_weak(old, rest, std::memory_order_relaxed))
      return from_the_end ? end - 1 : first;
  }
}

std::int32_t ThreadTeam::take(int thread) {
  const int all = size();
  for (int k = 0; k < all; ++k) {
    const std::int32_t item = ranges_[static_cast<std::size_t>((thread + k) % all)].take(k > 0);
    if (item >= 0) return item;
  }
  return -1;
}

ThreadTeam::~ThreadTeam() {
  stopping_ = true;
  ++generation_;
  generation_.notify_all();
}

void ThreadTeam::work_loop(int k) {
  std::uint32_t last_generation = 0;
  for (;;) {
    wait_while(generation_, last_generation);
    ++last_generation;
    if (stopping_) return;
    call_(work_, k);
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
  }
}

void ThreadTeam::dispatch(Call call, const void* work) {
  call_ = call;
  work_ = work;
  busy_.store(static_cast<int>(threads_.size()), std::memory_order_release);
  generation_.fetch_add(1, std::memory_order_acq_rel);
  generation_.notify_all();
  call(work, 0);
  for (int left = busy_.load(std::memory_order_acquire); left > 0;
       left = busy_.load(std::memory_order_acquire))
    wait_while(busy_, left);
}

}  // namespace mahlwerk::soft
