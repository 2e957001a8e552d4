// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace mahlwerk::observe {

/// A mean over independent replicates and its 95 % confidence half-width.
struct Estimate {
  double mean = 0;
  double ci95 = 0;  ///< Student's t; NaN with fewer than two replicates
};

/// `values`: one per replicate, at least one (sta.1).
Estimate estimate(const std::vector<double>& values);

/// Two-sided 95 % quantile of Student's t for `freedom` >= 1 degrees of freedom (sta.2).
double student95(int freedom);

}  // namespace mahlwerk::observe
