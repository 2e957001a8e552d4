// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "mahlwerk/cases/case.hpp"

// A drive whose sense of rotation changes after each cycle: [milling] reverse
// (docs/theory/kinematics.md).
namespace mahlwerk::cases {

/// Whether mill or stirrer turn in a sense that can be reversed.
bool has_sense_of_rotation(const Case& c);

/// Whether `reverse` needs runs in both senses: jar and gravity are not their own mirror image at
/// the plane of x and z. Replicates with an odd index, from 0, then turn the other way.
bool needs_both_senses(const Case& c);

/// The case of a replicate, from 0, in its sense of rotation.
class CaseBySense {
 public:
  explicit CaseBySense(const Case& c);
  const Case& of(std::size_t replicate) const {
    return reversed_ && replicate % 2 == 1 ? *reversed_ : *own_;
  }

 private:
  const Case* own_;
  std::optional<Case> reversed_;
};

}  // namespace mahlwerk::cases
