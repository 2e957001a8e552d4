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

/// Binary checkpoint of a run, exact to the bit. One function `serialize(Archive&)` of each class
/// both writes and reads, depending on the direction of the archive, so the two cannot disagree.
/// Native byte order and layout: only for the machine that wrote it. Throws RunError where bytes
/// are missing or left over.
class Archive {
 public:
  Archive() = default;  ///< for writing
  explicit Archive(std::string bytes) : bytes_(std::move(bytes)), reading_(true) {}

  bool reading() const { return reading_; }
  /// Whether this value is what is read next.
  template <class T>
  requires std::is_trivially_copyable_v<T>
  bool begins_with(const T& value) const {
    return bytes_.size() - at_ >= sizeof value &&
           std::memcmp(bytes_.data() + at_, &value, sizeof value) == 0;
  }
  const std::string& bytes() const { return bytes_; }
  static RunError broken() { return RunError("the saved state of the run is damaged"); }
  void finish() const {
    if (at_ != bytes_.size()) throw broken();
  }

  template <class T>
  requires std::is_trivially_copyable_v<T> Archive& operator()(T& value) {
    return raw(&value, sizeof value);
  }
  /// Reading throws RunError for a byte that is neither 0 nor 1.
  Archive& operator()(bool& value) {
    std::uint8_t byte = value ? 1 : 0;
    raw(&byte, sizeof byte);
    if (byte > 1) throw broken();
    value = byte == 1;
    return *this;
  }
  /// A vector or string of trivially copyable values.
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
