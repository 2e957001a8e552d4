// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace mahlwerk::soft {

/// Threads that do one thing at a time together. Who does what never changes what is done.
class Crew {
 public:
  explicit Crew(int threads);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  int size() const { return static_cast<int>(team_.size()) + 1; }
  /// Calls `work(k)` for every k below size(), each on a thread of its own, and waits for all.
  /// `work` must not throw.
  template <class Work>
  void all(const Work& work) {
    if (team_.empty()) return work(0);
    do_all([](const void* w, int k) { (*static_cast<const Work*>(w))(k); }, &work);
  }

 private:
  using Call = void (*)(const void* work, int k);
  void do_all(Call call, const void* work);
  void serve(int k);

  Call call_ = nullptr;
  const void* work_ = nullptr;
  std::atomic<std::uint32_t> turn_ = 0;
  std::atomic<int> busy_ = 0;
  std::atomic<bool> ends_ = false;
  std::vector<std::jthread> team_;
};

}  // namespace mahlwerk::soft
