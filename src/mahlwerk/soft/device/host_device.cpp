// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>
#include <limits>
#include <new>

#include "mahlwerk/soft/device/device.hpp"
#include "mahlwerk/soft/many/thread_team.hpp"

namespace mahlwerk::soft {
namespace {

class HostDevice final : public Device {
 public:
  explicit HostDevice(int threads) : team_(threads) {}

  std::string name() const override { return "the host"; }
  std::size_t free_bytes() const override { return std::numeric_limits<std::size_t>::max(); }
  void* allocate(std::size_t bytes) override {
    return ::operator new(bytes, std::align_val_t(alignment));
  }
  void release(void* memory) noexcept override {
    ::operator delete(memory, std::align_val_t(alignment));
  }
  void write(void* to, const void* from, std::size_t bytes) override {
    std::memcpy(to, from, bytes);
  }
  void read(void* to, const void* from, std::size_t bytes) override {
    std::memcpy(to, from, bytes);
  }
  void zero(void* to, std::size_t bytes) override { std::memset(to, 0, bytes); }
  void run(const Kernel& kernel, const DeviceArrays& arrays, std::int64_t count) override {
    team_.run_on_all([&](int thread) {
      const std::int64_t last = count * (thread + 1) / team_.size();
      for (std::int64_t k = count * thread / team_.size(); k < last; ++k) kernel.call(arrays, k);
    });
  }

 private:
  static constexpr std::size_t alignment = 256;  // as cards have it
  ThreadTeam team_;
};

}  // namespace

std::shared_ptr<Device> host_device(int threads) {
  return std::make_shared<HostDevice>(threads);
}

}  // namespace mahlwerk::soft
