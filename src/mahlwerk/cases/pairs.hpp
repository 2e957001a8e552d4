// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/cases/case.hpp"

// Who is meant by a name in [[contact.pairs]].
namespace mahlwerk::cases {

/// Ball sets and faces of the jar, both counted from 0.
struct PairSelector {
  std::vector<int> kinds, faces;
  bool empty() const { return kinds.empty() && faces.empty(); }
};

/// "balls.1" for the first set, "powder" for grains.
std::string set_name(const Case& c, std::size_t kind);

PairSelector pair_selector(std::string_view name, const Case& c);
std::vector<std::string> pair_selector_names(const Case& c);  ///< all that mean somebody

}  // namespace mahlwerk::cases
