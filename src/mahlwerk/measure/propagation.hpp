// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "mahlwerk/observe/statistics.hpp"

// Errors of results that follow from measured numbers.
namespace mahlwerk::measure {

/// Results with their 95 % half-widths, and what these have in common.
struct Propagated {
  std::vector<observe::Estimate> results;
  /// Products of half-widths, results.size() squared of them: the diagonal holds their squares.
  std::vector<double> covariance;
};

/// Propagates independent half-widths of the inputs to first order (mea.4). An unknown half-width
/// (NaN) counts as 0.
Propagated propagated(
    const std::vector<observe::Estimate>& inputs,
    const std::function<std::vector<double>(const std::vector<double>&)>& results);

}  // namespace mahlwerk::measure
