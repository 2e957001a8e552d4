// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "mahlwerk/base/indirect.hpp"

// Members of Indirect<T> that need a complete T. Included by the one file that instantiates
// Indirect<T>.
namespace mahlwerk {

template <class T>
Indirect<T>::Indirect() : value_(std::make_unique<T>()) {}
template <class T>
Indirect<T>::Indirect(const T& value) : value_(std::make_unique<T>(value)) {}
template <class T>
Indirect<T>::Indirect(T&& value) : value_(std::make_unique<T>(std::move(value))) {}
template <class T>
Indirect<T>::Indirect(const Indirect& other)
    : value_(other.value_ ? std::make_unique<T>(*other.value_) : nullptr) {}
template <class T>
Indirect<T>::Indirect(Indirect&& other) noexcept = default;
template <class T>
Indirect<T>& Indirect<T>::operator=(const Indirect& other) {
  if (this != &other) value_ = other.value_ ? std::make_unique<T>(*other.value_) : nullptr;
  return *this;
}
template <class T>
Indirect<T>& Indirect<T>::operator=(Indirect&& other) noexcept = default;
template <class T>
Indirect<T>::~Indirect() = default;
template <class T>
bool Indirect<T>::operator==(const T& other) const {
  return *value_ == other;
}

}  // namespace mahlwerk
