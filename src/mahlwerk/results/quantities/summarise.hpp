// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::results {

/// Computes all numbers of an outcome from its replicates. A run keeps them in `Outcome::summary`.
Summary summarise(const Outcome& outcome);

/// A quantity that a case does not have, and the section that adds it: "[wear]".
struct MissingQuantity {
  std::string name, section;
};
/// The quantities that the case would have with another section.
std::vector<MissingQuantity> missing_quantities(const cases::Case& mill_case);

}  // namespace mahlwerk::results
