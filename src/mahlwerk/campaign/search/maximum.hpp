// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

namespace mahlwerk::campaign {

/// How hard a highest point is looked for, in evaluations.
struct EvaluationBudget {
  int global = 0;  ///< over the whole box, by dividing it (DIRECT-L, Gablonsky 2001)
  int local = 0;   ///< from each start, by simplexes (Subplex, Rowan 1990)
};

struct Maximum {
  std::vector<double> point;
  double value = 0;
};

/// The highest point found of a function in a box; values that are NaN count as lowest. `starts`
/// lie in the box; what the wide search finds is one more. At least one start, or a wide search.
Maximum find_maximum(const std::function<double(const std::vector<double>&)>& function,
                     const std::vector<double>& least, const std::vector<double>& most,
                     const std::vector<std::vector<double>>& starts,
                     const EvaluationBudget& budget);

}  // namespace mahlwerk::campaign
