// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/soft/device/arrays.hpp"

namespace mahlwerk::soft {

/// A function of an index over the arrays of a run. On the host it is called; on a graphics card
/// the function `name` of the module `module` is the same source, compiled for the card.
struct Kernel {
  std::string module, name;
  void (*call)(const DeviceArrays& arrays, std::int64_t index) = nullptr;
};

/// A device failed; its arrays may be lost.
class DeviceError : public RunError {
 public:
  using RunError::RunError;
};

/// What computes kernels for one run, and the memory where its arrays are. Operations are done in
/// their order. All throw DeviceError where the device fails, with its own words.
class Device {
 public:
  virtual ~Device() = default;
  virtual std::string name() const = 0;
  virtual std::size_t free_bytes() const = 0;

  virtual void* allocate(std::size_t bytes) = 0;
  virtual void release(void* memory) noexcept = 0;
  virtual void write(void* to, const void* from, std::size_t bytes) = 0;
  virtual void read(void* to, const void* from, std::size_t bytes) = 0;  ///< waits for kernels
  virtual void zero(void* to, std::size_t bytes) = 0;
  /// Calls the kernel for all indices below `count`, in any order.
  virtual void run(const Kernel& kernel, const DeviceArrays& arrays, std::int64_t count) = 0;
};

/// The host as a device, with `threads` threads: the plain reference of a graphics card.
std::shared_ptr<Device> host_device(int threads = 1);

/// An array in the memory of a device. It grows without keeping its elements.
template <class T>
class DeviceArray {
 public:
  explicit DeviceArray(Device& device) : device_(&device) {}
  ~DeviceArray() { release(); }
  DeviceArray(const DeviceArray&) = delete;
  DeviceArray& operator=(const DeviceArray&) = delete;

  /// Has room for at least `count` elements afterwards.
  T* reserve(std::size_t count) {
    if (count <= room_) return data_;
    release();
    const std::size_t room = count + count / 8;
    data_ = static_cast<T*>(device_->allocate(room * sizeof(T)));
    room_ = room;
    return data_;
  }
  T* zeroed(std::size_t count) {
    reserve(count);
    device_->zero(data_, count * sizeof(T));
    return data_;
  }
  T* data() const { return data_; }
  std::vector<T> read(std::size_t count) const {
    std::vector<T> all(count);
    if (count > 0) device_->read(all.data(), data_, count * sizeof(T));
    return all;
  }
  T* write(const std::vector<T>& all) {
    reserve(all.size());
    if (!all.empty()) device_->write(data_, all.data(), all.size() * sizeof(T));
    return data_;
  }

 private:
  void release() {
    if (data_ != nullptr) device_->release(data_);
    data_ = nullptr, room_ = 0;
  }

  Device* device_;
  T* data_ = nullptr;
  std::size_t room_ = 0;
};

}  // namespace mahlwerk::soft
