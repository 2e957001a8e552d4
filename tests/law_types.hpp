// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>

#include "mahlwerk/contact/laws.hpp"

// A typed test for each contact law of the register.
namespace mahlwerk::tests {

template <class Variant>
struct LawTypes;
template <class... L>
struct LawTypes<std::variant<L...>> {
  using type = ::testing::Types<L...>;
};
struct NameOfLaw {
  template <class L>
  static std::string GetName(int) {
    std::string name(L::name);
    std::ranges::replace(name, '-', '_');
    return name;
  }
};

}  // namespace mahlwerk::tests
