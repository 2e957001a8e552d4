// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "mahlwerk/base/archive.hpp"

namespace mahlwerk::observe {

/// An array of fixed size into which an observer counts. pack() keeps only the elements that are
/// not zero, for a result that is read from then on: of a replicate's statistics most are zero.
template <class T>
class PackedArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  PackedArray() = default;  ///< of size 0
  explicit PackedArray(std::size_t size) : size_(size), values_(size) {}

  std::size_t size() const { return size_; }
  /// For counting, not of a packed array.
  T& operator[](std::size_t i) { return values_[i]; }
  T operator[](std::size_t i) const {
    if (!packed_) return values_[i];
    const auto at = std::lower_bound(where_.begin(), where_.end(), i);
    return at == where_.end() || *at != i ? T{}
                                          : values_[static_cast<std::size_t>(at - where_.begin())];
  }

  void pack() {
    if (packed_) return;
    std::vector<T> kept;
    for (std::size_t i = 0; i < size_; ++i) {
      if (is_zero(values_[i])) continue;
      where_.push_back(static_cast<std::uint32_t>(i));
      kept.push_back(values_[i]);
    }
    where_.shrink_to_fit();
    kept.shrink_to_fit();
    values_ = std::move(kept);
    packed_ = true;
  }
  /// Forgets the elements: all are zero from then on, and take no memory.
  void let_go() {
    values_ = std::vector<T>();
    where_ = std::vector<std::uint32_t>();
    packed_ = true;
  }
  void unpack() {
    if (!packed_) return;
    std::vector<T> all(size_);
    for (std::size_t k = 0; k < where_.size(); ++k) all[where_[k]] = values_[k];
    values_ = std::move(all);
    where_ = std::vector<std::uint32_t>();
    packed_ = false;
  }
  /// Adds the elements of another array of the same size by `add(mine, others)`.
  template <class Add>
  void merge(const PackedArray& other, const Add& add) {
    unpack();
    if (!other.packed_)
      for (std::size_t i = 0; i < size_; ++i) add(values_[i], other.values_[i]);
    for (std::size_t k = 0; other.packed_ && k < other.where_.size(); ++k)
      add(values_[other.where_[k]], other.values_[k]);
  }
  /// Writes the packed form.
  void serialize(Archive& archive) {
    const bool was_packed = packed_;
    if (!archive.reading()) pack();
    archive(where_)(values_);
    if (archive.reading()) check_read();
    packed_ = true;
    if (!was_packed) unpack();
  }

 private:
  static bool is_zero(const T& value) {
    const T zero{};
    return std::memcmp(&value, &zero, sizeof value) == 0;
  }
  void check_read() const {
    bool sound = where_.size() == values_.size() && (where_.empty() || where_.back() < size_);
    for (std::size_t k = 1; k < where_.size(); ++k) sound = sound && where_[k - 1] < where_[k];
    if (!sound) throw Archive::broken();
  }

  std::size_t size_ = 0;
  std::vector<T> values_;             // all of them, or those that are not zero
  std::vector<std::uint32_t> where_;  // of those, in order
  bool packed_ = false;
};

}  // namespace mahlwerk::observe
