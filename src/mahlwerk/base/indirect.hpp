// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace mahlwerk {

/// Owning pointer with value semantics to an incomplete type T: copies and comparisons act on the
/// value. Code that accesses the value includes the header that defines T. One file instantiates
/// the members below, by `template class Indirect<T>` after base/indirect_members.hpp. Null only
/// when moved from.
template <class T>
class Indirect {
 public:
  Indirect();
  Indirect(const Indirect& other);
  Indirect(Indirect&& other) noexcept;
  Indirect& operator=(const Indirect& other);
  Indirect& operator=(Indirect&& other) noexcept;
  ~Indirect();
  Indirect(const T& value);
  Indirect(T&& value);
  /// From a model `M`, a type with a member `name`, from which T can be constructed.
  template <class M>
  requires(requires { std::remove_cvref_t<M>::name; } && std::is_constructible_v<T, M>)
      Indirect(M&& model)
      : value_(std::make_unique<T>(std::forward<M>(model))) {}

  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return value_.get(); }
  const T* operator->() const { return value_.get(); }
  bool operator==(const Indirect& other) const {
    return value_ && other.value_ ? *this == *other : value_ == other.value_;
  }
  bool operator==(const T& other) const;

 private:
  std::unique_ptr<T> value_;
};

}  // namespace mahlwerk
