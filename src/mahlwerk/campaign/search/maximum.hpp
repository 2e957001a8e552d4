// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

namespace mahlwerk::campaign {

/// Budget of a search for a maximum, in function evaluations.
struct EvaluationBudget {
  int global = 0;  ///< global search by dividing the box (DIRECT-L, Gablonsky 2001)
  int local = 0;   ///< local search from each start (Subplex, Rowan 1990)
};

struct Maximum {
  std::vector<double> point;
  double value = 0;
};

/// The highest point found of a function in the box from `least` to `most`; NaN counts as the
/// lowest value. `starts` lie in the box; the result of the global search is one more start.
/// Requires a start or a global budget.
Maximum find_maximum(const std::function<double(const std::vector<double>&)>& function,
                     const std::vector<double>& least, const std::vector<double>& most,
                     const std::vector<std::vector<double>>& starts,
                     const EvaluationBudget& budget);

}  // namespace mahlwerk::campaign
