// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace mahlwerk::cases {

/// Powder between bodies that damps their bounce: the section [powder_feedback]
/// (docs/theory/powder.md).
struct PowderFeedback {
  double absorbed_energy = 0;  ///< [J/kg] that captured powder takes out of a hit, at most
  double accuracy = 0.01;      ///< [1] change of the restitution below which it is consistent
  /// Of a case that runs: the restitution is found, and stands in its contact pairs.
  bool found = false;
  bool operator==(const PowderFeedback&) const = default;
};

}  // namespace mahlwerk::cases
