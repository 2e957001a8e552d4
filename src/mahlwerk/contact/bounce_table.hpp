// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "mahlwerk/contact/bounce.hpp"

namespace mahlwerk::contact {

/// Who bounces off whom by which rule: a rule for each pair of kinds of balls, and for each kind
/// and face of the jar.
class BounceTable {
 public:
  BounceTable(int kinds, int faces, const BounceRule& all)
      : kinds_(static_cast<std::size_t>(kinds)),
        row_(kinds_ + static_cast<std::size_t>(faces)),
        rules_(kinds_ * row_, all) {}

  const BounceRule& balls(int a, int b) const { return rules_[index(a, b)]; }
  const BounceRule& wall(int kind, int face) const { return rules_[wall_index(kind, face)]; }

  void set_balls(int a, int b, const BounceRule& rule) {
    rules_[index(a, b)] = rules_[index(b, a)] = rule;
  }
  void set_wall(int kind, int face, const BounceRule& rule) {
    rules_[wall_index(kind, face)] = rule;
  }

  int kinds() const { return static_cast<int>(kinds_); }
  int faces() const { return static_cast<int>(row_ - kinds_); }
  bool operator==(const BounceTable&) const = default;

 private:
  /// A row of rules for each kind: against every kind, then against every face.
  std::size_t index(int kind, int other) const {
    return static_cast<std::size_t>(kind) * row_ + static_cast<std::size_t>(other);
  }
  std::size_t wall_index(int kind, int face) const { return index(kind, face) + kinds_; }

  std::size_t kinds_, row_;
  std::vector<BounceRule> rules_;
};

}  // namespace mahlwerk::contact
