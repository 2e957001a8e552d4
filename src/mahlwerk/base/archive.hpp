// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk {

/// The state of a run as bytes, to the bit. One function `serialize(Archive&)` of each part writes
/// or reads it, depending on the archive's direction, so that both cannot disagree. For the machine
/// that wrote it; throws RunError where bytes are missing or left over.
class Archive {
 public:
  Archive() = default;  ///< writes
  explicit Archive(std::string bytes) : bytes_(std::move(bytes)), reading_(true) {}

  bool reading() const { return reading_; }
  const std::string& bytes() const { return bytes_; }
  static RunError broken() { return RunError("the saved state of the run is damaged"); }
  void finish() const {
    if (at_ != bytes_.size()) throw broken();
  }

  template <class T>
  requires std::is_trivially_copyable_v<T> Archive& operator()(T& value) {
    return raw(&value, sizeof value);
  }
  /// Read, a byte that is neither 0 nor 1 is damage.
  Archive& operator()(bool& value) {
    std::uint8_t byte = value ? 1 : 0;
    raw(&byte, sizeof byte);
    if (byte > 1) throw broken();
    value = byte == 1;
    return *this;
  }
  /// A vector or string of plain values.
  template <class List>
  requires requires(List& list) { list.resize(1); }
  Archive& operator()(List& list) {
    static_assert(std::is_trivially_copyable_v<typename List::value_type>);
    auto count = static_cast<std::uint64_t>(list.size());
    (*this)(count);
    if (reading_) {
      if (count > (bytes_.size() - at_) / sizeof(typename List::value_type)) throw broken();
      list.resize(count);
    }
    return raw(list.data(), count * sizeof(typename List::value_type));
  }

 private:
  Archive& raw(void* data, std::size_t size) {
    if (!reading_) {
      bytes_.append(static_cast<const char*>(data), size);
      return *this;
    }
    if (size > bytes_.size() - at_) throw broken();
    if (size > 0) std::memcpy(data, bytes_.data() + at_, size);
    at_ += size;
    return *this;
  }

  std::string bytes_;
  std::size_t at_ = 0;
  bool reading_ = false;
};

}  // namespace mahlwerk
