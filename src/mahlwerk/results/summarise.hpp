// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::results {

/// All numbers of an outcome, from its replicates: kept in `Outcome::summary` when a run ends.
Summary summarise(const Outcome& outcome);

/// A quantity that a case does not have, and the section it comes with: "[wear]".
struct MissingQuantity {
  std::string name, section;
};
/// Those that the case would have with another section.
std::vector<MissingQuantity> missing_quantities(const cases::Case& what);

}  // namespace mahlwerk::results
