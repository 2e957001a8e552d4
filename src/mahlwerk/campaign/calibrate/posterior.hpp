// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/campaign/calibrate/calibration.hpp"

// Numbers of a posterior from its sample.
namespace mahlwerk::campaign {

/// Value below which a share of the values lies; interpolated.
double quantile_of(std::vector<double> values, double share);

/// Index of the point with the least mean distance to the others, in standard deviations.
std::size_t most_central(const std::vector<std::vector<double>>& points);

/// `count` points at even distances in the list.
std::vector<std::vector<double>> thinned(const std::vector<std::vector<double>>& points,
                                         std::size_t count);

/// Correlation of the first `coordinates` coordinates.
std::vector<std::vector<double>> correlation_of(const std::vector<std::vector<double>>& points,
                                                std::size_t coordinates);

/// A parameter with its 95 % interval, and whether the posterior is narrower than the range
/// (cal.7).
FittedParameter describe_parameter(const FreeParameter& parameter,
                                   const std::vector<double>& positions, double central);

}  // namespace mahlwerk::campaign
