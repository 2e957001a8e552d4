// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

// Access by name to a register of models (a variant).
namespace mahlwerk::cases {

template <class... Models>
std::vector<std::string> model_names(std::type_identity<std::variant<Models...>>) {
  return {std::string(Models::name)...};
}

/// Sets `model` to a default-constructed model of this name; false if there is none.
template <class... Models>
bool choose_model(std::variant<Models...>& model, std::string_view name) {
  const auto is_it = [&]<class M>(std::type_identity<M>) {
    if (M::name != name) return false;
    model = M{};
    return true;
  };
  return (is_it(std::type_identity<Models>{}) || ...);
}

}  // namespace mahlwerk::cases
