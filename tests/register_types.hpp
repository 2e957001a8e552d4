// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>

// A typed test for each model of a register: shapes, motions, contact laws.
namespace mahlwerk::tests {

template <class Variant>
struct TypesOf;
template <class... L>
struct TypesOf<std::variant<L...>> {
  using type = ::testing::Types<L...>;
};
struct NameOfModel {
  template <class L>
  static std::string GetName(int) {
    std::string name(L::name);
    std::ranges::replace(name, '-', '_');
    return name;
  }
};

}  // namespace mahlwerk::tests
