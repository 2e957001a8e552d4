// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/contact/bounce.hpp"

namespace mahlwerk::contact {

class BounceTable {
 public:
  BounceTable(int kinds, int faces, const BounceRule& all)
      : kinds_(kinds), columns_(kinds + faces), rules_(static_cast<std::size_t>(kinds * columns_), all) {}
  const BounceRule& balls(int a, int b) const { return rules_[static_cast<std::size_t>(a * columns_ + b)]; }
  const BounceRule& wall(int kind, int face) const { return balls(kind, kinds_ + face); }
  int kinds() const { return kinds_; }
 private:
  int kinds_, columns_;
  std::vector<BounceRule> rules_;
};

}  // namespace mahlwerk::contact
