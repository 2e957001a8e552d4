// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace mahlwerk::observe {

/// A mean and its 95 % confidence half-width.
struct Estimate {
  double mean = 0;
  double ci95 = 0;  ///< Student's t; NaN where there is none
};

/// `values`: one per replicate, at least one (sta.1).
Estimate estimate(const std::vector<double>& values);

/// The mean of a series that keeps its character while it goes on, values evenly spaced in time,
/// and the half-width that its own scatter gives: values are put into batches, twice as many a
/// batch until neighbouring batches hardly know of each other, and what is left of that is allowed
/// for (sta.3), (sta.4). NaN for fewer than ten values.
Estimate time_series_estimate(const std::vector<double>& values);

/// How many of the first values belong to a start that the rest does not remember: those whose
/// leaving out makes the mean of the others surest (MSER-5, sta.5). At most half of them; that many
/// means that it has not settled.
std::size_t transient_length(const std::vector<double>& values);

/// Two-sided 95 % quantile of Student's t for `freedom` >= 1 degrees of freedom (sta.2).
double student95(int freedom);

}  // namespace mahlwerk::observe
