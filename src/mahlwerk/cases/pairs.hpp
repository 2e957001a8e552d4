// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/cases/case.hpp"

// Ball sets and jar faces selected by a name in [[contact.pairs]].
namespace mahlwerk::cases {

/// Ball sets and faces of the jar, both counted from 0.
struct PairSelector {
  std::vector<int> kinds, faces;
  bool empty() const { return kinds.empty() && faces.empty(); }
};

/// Name of a ball set: "balls.1" for the first, "powder" for grains.
std::string set_name(const Case& c, std::size_t kind);

/// The ball sets and faces that `name` selects; empty for an unknown name.
PairSelector pair_selector(std::string_view name, const Case& c);
std::vector<std::string> pair_selector_names(const Case& c);  ///< all known names

}  // namespace mahlwerk::cases
